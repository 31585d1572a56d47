//! The atoms of a file, as they stand in it, whatever its format.

use super::assembly::Assemblies;
use super::element::{Element, UNKNOWN, of_name, of_symbol};
use super::words::{Word, Words};

#[derive(Clone, Debug)]
pub struct Atom {
    /// Place in angstroms.
    pub place: [f64; 3],
    pub element: &'static Element,
    /// Its number in the file, which is only compared.
    pub serial: Serial,
    /// Share of the molecules that have the atom here; 1 if the file does not say.
    pub occupancy: f32,
    pub name: Word,
    /// Alternate location, or nothing.
    pub alternate: Word,
    pub residue: Word,
    /// Number of its residue, with the insertion code.
    pub number: Word,
    /// Chain as its authors name it, or nothing.
    pub chain: Word,
    /// Chain as the archive names it, if it does, else as its authors do; assemblies are put together by it.
    pub part: Word,
}

// Millions of atoms are held.
const _: () = assert!(size_of::<Atom>() <= 72);

/// Names of water in the files of the archive and of simulations.
const WATER: [&str; 13] = [
    "HOH", "WAT", "H2O", "DOD", "SOL", "TIP", "TP3", "TIP3", "TIP4", "T3P", "T4P", "SPC", "OH2",
];

pub fn is_water(residue: &str) -> bool {
    WATER.iter().any(|n| n.eq_ignore_ascii_case(residue))
}

pub struct Model {
    pub number: i64,
    pub atoms: Vec<Atom>,
}

/// One end of a bond that a file names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum End {
    /// By the atom's number.
    Serial(Serial),
    /// By its names: chain of the archive, residue number, atom, alternate.
    Names([Word; 4]),
}

#[derive(Default)]
pub struct Structure {
    /// Title, or the classification of the header, or nothing.
    pub title: String,
    /// The identifier of the entry, or nothing.
    pub entry: String,
    /// Models that have atoms.
    pub models: Vec<Model>,
    /// Pairs of atoms that are bonded.
    pub connections: Vec<[End; 2]>,
    /// What can be put together of copies of its chains.
    pub assemblies: Assemblies,
    pub words: Words,
    // In how many places it is unusual.
    /// Elements from the names of atoms.
    pub named_element: usize,
    pub no_element: usize,
    pub no_occupancy: usize,
    /// Data blocks behind the first with atoms.
    pub other_blocks: bool,
    /// Bonds to copies of the crystal.
    pub other_cells: usize,
}

impl Structure {
    /// The occupancy of an atom; 1 if the file does not give it, or no number.
    pub fn occupancy(&mut self, is_given: bool, number: Option<f64>) -> f32 {
        self.no_occupancy += usize::from(is_given && number.is_none());
        number.unwrap_or(1.0) as f32
    }

    /// The element of a symbol, or else of an atom's name in its columns and that of its residue.
    pub fn element(
        &mut self,
        symbol: &[u8],
        name: impl FnOnce() -> ([u8; 4], String),
    ) -> &'static Element {
        // A charge may stand behind the symbol; in files before 1996 there are digits.
        let end = symbol.iter().position(|c| !c.is_ascii_alphabetic());
        let letters = &symbol[..end.unwrap_or(symbol.len())];
        if let Some(element) = of_symbol(std::str::from_utf8(letters).expect("letters")) {
            return element;
        }
        let (columns, residue) = name();
        let found = of_name(columns, &residue);
        self.named_element += usize::from(found.is_some());
        self.no_element += usize::from(found.is_none());
        found.unwrap_or(&UNKNOWN)
    }
}

/// The number that a file gives an atom. Most are whole numbers; hybrid-36, hexadecimal and starred ones are words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Serial {
    /// Decimal, without leading zeros.
    Number(u32),
    Word(Word),
}

impl Serial {
    pub fn of(text: &[u8], words: &mut Words) -> Serial {
        // Neither a sign nor leading zeros.
        let is_plain = matches!(text, [b'0'] | [b'1'..=b'9', ..]);
        let decimal = std::str::from_utf8(text).ok().filter(|_| is_plain);
        match decimal.and_then(|text| text.parse().ok()) {
            Some(number) => Serial::Number(number),
            None => Serial::Word(words.keep_bytes(text)),
        }
    }

    pub fn text(self, words: &Words) -> String {
        match self {
            Serial::Number(number) => number.to_string(),
            Serial::Word(word) => words.text(word).to_owned(),
        }
    }
}
