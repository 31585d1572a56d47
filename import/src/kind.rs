//! What a file is, by what it holds and else by what it is called, and files compressed with gzip.

use crate::error::{Error, ImportError};
use flate2::read::MultiGzDecoder;
use std::io::Read;

/// The formats of structures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Lines of fixed columns.
    Pdb,
    /// PDBx/mmCIF, a text of categories.
    Mmcif,
    /// BinaryCIF, the same categories as encoded columns.
    Bcif,
}

/// Kinds of files that are read. They are told apart whatever features are on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A molecule.
    Structure(Format),
    /// A list of CAD faces.
    Faces,
    /// A STEP file, ISO 10303-21.
    Step,
    /// A grid of heights.
    Heights,
}

const PDB: Kind = Kind::Structure(Format::Pdb);
const CIF: Kind = Kind::Structure(Format::Mmcif);
const BCIF: Kind = Kind::Structure(Format::Bcif);

/// Each kind with what a person calls it, and endings of its files.
const KINDS: [(Kind, &str, &str); 6] = [
    (PDB, "a structure in the PDB format", ".pdb, .ent"),
    (CIF, "a structure in the PDBx/mmCIF format", ".cif, .mmcif"),
    (BCIF, "a structure in the BinaryCIF format", ".bcif"),
    (Kind::Faces, "a list of CAD faces", ".faces.toml"),
    (Kind::Step, "a STEP file", ".step, .stp, .p21"),
    (Kind::Heights, "a grid of heights", ".heights, .asc"),
];

/// Records that a PDB file begins with; its coordinates may come much later.
const RECORDS: [&str; 26] = [
    "HEADER", "OBSLTE", "TITLE", "SPLIT", "CAVEAT", "COMPND", "SOURCE", "KEYWDS", "EXPDTA",
    "NUMMDL", "MDLTYP", "AUTHOR", "REVDAT", "SPRSDE", "JRNL", "REMARK", "DBREF", "SEQRES",
    "CRYST1", "ORIGX1", "SCALE1", "MODEL", "ATOM", "HETATM", "USER", "ANISOU",
];

const LOOKED_AT: usize = 1 << 16;

impl Kind {
    /// What the bytes of a file, not compressed, and its name say; the bytes count for more.
    pub fn of(bytes: &[u8], file: &str) -> Option<Kind> {
        let name = file.to_lowercase();
        let name = name.strip_suffix(".gz").unwrap_or(&name);
        let ends = |endings: &str| endings.split(", ").any(|e| name.ends_with(e));
        let named = KINDS.iter().find(|(.., endings)| ends(endings));
        Kind::of_bytes(bytes).or(named.map(|(kind, ..)| *kind))
    }

    fn of_bytes(bytes: &[u8]) -> Option<Kind> {
        let bytes = &bytes[..bytes.len().min(LOOKED_AT)];
        let is_map = matches!(bytes.first(), Some(0x80..=0x8f | 0xde | 0xdf));
        let has = |word: &[u8]| bytes.windows(word.len()).any(|w| w == word);
        if is_map && (has(b"dataBlocks") || has(b"encoder")) {
            return Some(BCIF);
        }
        let text = String::from_utf8_lossy(bytes);
        let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
        let lines = || text.split(['\n', '\r']).map(str::trim_end);
        let is_told = |line: &&str| !line.is_empty() && !line.starts_with('#');
        let first = lines().find(is_told)?;
        if first.trim_start().starts_with("ISO-10303-21") {
            return Some(Kind::Step);
        }
        let word = first.split_whitespace().next()?;
        let start = word.to_ascii_lowercase();
        let cif = ["data_", "loop_", "global_", "_"];
        if cif.iter().any(|own| start.starts_with(own)) {
            return Some(CIF);
        }
        if is_grid_keyword(word) || lines().filter(is_told).take(3).all(is_heights) {
            return Some(Kind::Heights);
        }
        let has_table = |name: &str| lines().any(|line| line.trim() == name);
        if has_table("[[faces]]") || has_table("[[edges]]") || has_table("[vertices]") {
            return Some(Kind::Faces);
        }
        let is_record = |line: &str| {
            let (name, rest) = line.split_at_checked(6).unwrap_or((line, ""));
            let is = |record: &&str| name.trim_end().eq_ignore_ascii_case(record);
            // A serial number may reach up to the name or into it; a word that goes on is no record.
            let ends = rest.starts_with(|c: char| c == ' ' || c.is_ascii_digit());
            (rest.is_empty() || ends) && (RECORDS.iter().any(is) || name.starts_with("ATOM "))
        };
        is_record(first).then_some(PDB)
    }
}

/// Whether a word is a keyword of the header of an ESRI ASCII grid, in any case.
pub fn is_grid_keyword(word: &str) -> bool {
    KEYS.contains(&word.to_lowercase().as_str())
}

/// The keywords of that header.
pub(crate) const KEYS: [&str; 10] = [
    "ncols",
    "nrows",
    "xllcorner",
    "yllcorner",
    "xllcenter",
    "yllcenter",
    "cellsize",
    "dx",
    "dy",
    "nodata_value",
];

/// A row of numbers, or the line that gives their distances.
fn is_heights(line: &str) -> bool {
    let mut words = line.split_whitespace().peekable();
    words.next_if(|word| *word == "step");
    words.all(|word| word.parse::<f64>().is_ok())
}

/// What is read, with the endings of the names.
pub fn kinds() -> String {
    let kinds = KINDS.map(|(.., what, endings)| format!("{what} ({endings})"));
    let (last, others) = kinds.split_last().expect("kinds");
    format!("{} or {last}", others.join(", "))
}

/// Whether a text is a scene, which needs no import.
pub fn is_scene(bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(LOOKED_AT)]);
    let has = |name: &str| text.lines().any(|line| line.trim() == name);
    has("[camera]") && (has("[[objects]]") || has("[[molecules]]"))
}

/// Whether bytes begin as gzip's do.
pub fn is_compressed(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0x1f, 0x8b])
}

/// What was compressed, in one member or several, if it takes at most `limit` bytes; messages name `file`.
pub fn unpack(bytes: &[u8], limit: u64, file: &str) -> Result<Vec<u8>, ImportError> {
    let mut unpacked = vec![];
    let mut decoder = MultiGzDecoder::new(bytes).take(limit + 1);
    let (problem, accepted) = match decoder.read_to_end(&mut unpacked) {
        Ok(count) if count as u64 <= limit => return Ok(unpacked),
        Ok(_) => (
            format!("it unpacks to more than {limit} bytes"),
            format!("up to {limit} bytes would be accepted"),
        ),
        Err(error) => (
            format!("it cannot be unpacked ({error})"),
            "a whole file compressed with gzip would be accepted".to_owned(),
        ),
    };
    Err(ImportError::of(file)(Error::whole(problem, accepted)))
}
