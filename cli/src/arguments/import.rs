//! Arguments of `import`, and of `terrain`.

use super::parse::{Choices, at_least_zero, choice, list, name};
use super::scene::LookOptions;
use clap::Args;
use imogene_import::Kind;
use imogene_import::pdb::{Alternates, Colouring, Format, ModelChoice, Options, Residues, Style};
use imogene_import::terrain::{Cells, Region};
use imogene_scene::Molecule;
use std::path::PathBuf;
use std::str::FromStr;

/// Arguments of `import`.
#[derive(Debug, Args)]
pub struct Import {
    /// File to read: a molecule, a face list, a STEP file or a grid of heights; it may be compressed with gzip.
    pub file: PathBuf,
    /// Scene file to write.
    #[arg(short, long, value_name = "SCENE.toml")]
    pub output: PathBuf,
    /// What the file is; found out from what it holds, and else from its name.
    #[arg(long = "as", value_parser = choice(KINDS), value_name = "KIND")]
    pub kind: Option<Kind>,
    /// How the scene's camera looks at it; its directional lights turn with it.
    #[command(flatten)]
    pub look: LookOptions,
    /// Options of molecules.
    #[command(flatten, next_help_heading = "Molecules")]
    pub molecule: MoleculeOptions,
    /// Options of face lists and STEP files.
    #[command(flatten, next_help_heading = "CAD faces")]
    pub faces: FaceOptions,
    /// Options of terrain.
    #[command(flatten, next_help_heading = "Terrain")]
    pub terrain: TerrainOptions,
}

/// Kinds of files that are read.
#[rustfmt::skip]
const KINDS: Choices<Kind> = &[
    (Kind::Structure(Format::Pdb), "pdb", "A structure of the Protein Data Bank in its PDB format (.pdb, .ent)"),
    (Kind::Structure(Format::Mmcif), "mmcif", "A structure in the PDBx/mmCIF format (.cif, .mmcif)"),
    (Kind::Structure(Format::Bcif), "bcif", "A structure in the BinaryCIF format (.bcif)"),
    (Kind::Faces, "faces", "A list of CAD faces (.faces.toml)"),
    (Kind::Step, "step", "A STEP file, ISO 10303-21 (.step, .stp, .p21)"),
    (Kind::Heights, "heights", "A grid of heights (.heights, .asc)"),
];

/// The name of a kind of file.
pub fn kind_name(kind: Kind) -> &'static str {
    name(KINDS, kind)
}

/// Options of molecules.
#[derive(Clone, Debug, Args)]
pub struct MoleculeOptions {
    /// How it is drawn.
    #[arg(long, value_parser = choice(STYLES), default_value = "space-filling")]
    style: Style,
    /// What gives an atom its colour.
    #[arg(long, alias = "color", value_parser = choice(COLOURS), default_value = "element")]
    colour: Colouring,
    /// Model to draw: `first`, its number, or `all`, each where its coordinates put it.
    #[arg(long, default_value = "first", value_parser = ModelChoice::from_str, value_name = "N|first|all", allow_hyphen_values = true)]
    model: ModelChoice,
    /// Alternate locations to draw: `best` of each residue by occupancy, those of a letter, or `all`.
    #[arg(long, default_value = "best", value_parser = alternates, value_name = "LETTER|best|all")]
    alternates: String,
    /// Chains to draw, by the names that their authors gave them.
    #[arg(long, value_name = "CHAIN,...", value_delimiter = ',')]
    chain: Vec<String>,
    /// Residues to draw: numbers (with insertion code: 52A), ranges of numbers, and names.
    #[arg(long, value_name = "10-20,55,HEM,...", value_delimiter = ',', value_parser = Residues::from_str, allow_hyphen_values = true)]
    residue: Vec<Residues>,
    /// Draw an assembly, put together of copies of the chains, instead of the coordinates as they stand.
    #[arg(long, value_name = "ID")]
    assembly: Option<String>,
    /// Leave hydrogens out.
    #[arg(long, alias = "no-hydrogens")]
    without_hydrogens: bool,
    /// Leave water out.
    #[arg(long, alias = "no-water")]
    without_water: bool,
    /// Write a scene that names the structure file and is filled from it when it is read; so it is with more than 20
    /// 000 objects.
    #[arg(long, conflicts_with = "inline")]
    pub reference: bool,
    /// Write an object for each atom and bond, however many there are.
    #[arg(long)]
    pub inline: bool,
}

#[rustfmt::skip]
const STYLES: Choices<Style> = &[
    (Style::SpaceFilling, "space-filling", "Spheres of the van der Waals radii"),
    (Style::BallAndStick, "ball-and-stick", "Small spheres, and cylinders for bonds"),
];
const COLOURS: Choices<Colouring> = &[
    (Colouring::Element, "element", "The element"),
    (Colouring::Chain, "chain", "The chain"),
    (Colouring::Model, "model", "The model"),
];

impl MoleculeOptions {
    /// The table of a scene that asks for this of a file.
    pub fn molecule(&self, file: &str) -> Molecule {
        Molecule {
            file: file.to_owned(),
            style: name(STYLES, self.style).to_owned(),
            colour: name(COLOURS, self.colour).to_owned(),
            model: self.model.to_string(),
            alternates: self.alternates.clone(),
            hydrogens: !self.without_hydrogens,
            water: !self.without_water,
            chains: self.chain.clone(),
            residues: self.residue.iter().map(Residues::to_string).collect(),
            assembly: self.assembly.clone(),
            ..Molecule::default()
        }
    }

    /// The options of the reader.
    pub fn options(&self) -> Options {
        Options::of(&self.molecule("")).expect("each word was read once")
    }
}

fn alternates(text: &str) -> Result<String, String> {
    Alternates::from_str(text).map(|_| text.to_owned())
}

/// Options of face lists and STEP files.
#[derive(Clone, Debug, Args)]
pub struct FaceOptions {
    /// Most that an approximated border may be off, in units of the list, or mm of a STEP file, or in pixels of the
    /// scene's picture as in 0.5px; 0 rejects what is not exact. A thousandth of the part's size by default.
    #[arg(long, value_name = "LENGTH", value_parser = deviation)]
    pub max_deviation: Option<Deviation>,
    /// Compile each face by itself, also where a whole solid is one cut quadric.
    #[arg(long)]
    pub no_volumes: bool,
}

/// Most that something may be off.
#[derive(Clone, Copy, Debug)]
pub enum Deviation {
    /// In units of the scene.
    Length(f64),
    /// In pixels of the picture that the scene asks for.
    Pixels(f64),
}

/// A finite number that is not negative, with or without `px` behind it.
fn deviation(text: &str) -> Result<Deviation, String> {
    let (number, kind): (&str, fn(f64) -> Deviation) = match text.strip_suffix("px") {
        Some(number) => (number.trim_end(), Deviation::Pixels),
        None => (text, Deviation::Length),
    };
    let expected = "a length, 0 or more, is needed, such as 0.01, or pixels as in 0.5px";
    at_least_zero(number, expected).map(kind)
}

/// Options of terrain.
#[derive(Clone, Debug, Args)]
pub struct TerrainOptions {
    /// What a cell of the grid is drawn as.
    #[arg(long, value_parser = choice(CELLS), default_value = "bilinear", value_name = "FORM")]
    pub cells: Cells,
    /// Factor of the heights.
    #[arg(
        long,
        default_value_t = 1.0,
        value_name = "FACTOR",
        allow_hyphen_values = true
    )]
    pub height_factor: f64,
    /// The part of the grid from node (C, R) that is M nodes wide and N nodes deep.
    #[arg(long, value_name = "C,R,M,N", value_parser = region)]
    pub region: Option<Region>,
    /// Take every N-th node.
    #[arg(long, default_value_t = 1, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000))]
    pub every: u32,
    /// The eye: x east and z south of the middle of the terrain, y its height.
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    pub eye_at: Option<[f64; 3]>,
    /// The point that the eye looks at.
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    pub look_at: Option<[f64; 3]>,
}

/// Arguments of `terrain`.
#[derive(Debug, Args)]
pub struct Terrain {
    /// File of heights to write.
    #[arg(short, long, value_name = "FILE.heights")]
    pub output: PathBuf,
    /// Levels of recursion: 2^N + 1 nodes a side, N from 1 to 10.
    #[arg(long, default_value_t = 6, value_name = "N")]
    pub levels: u32,
    /// The exponent h from 0 (rough) to 1 (smooth): each level is displaced by 2^-h of the one before.
    #[arg(long, default_value_t = 0.8, value_name = "H")]
    pub roughness: f64,
    /// Deviation of the corners of the grid, in units of height.
    #[arg(long, default_value_t = 100.0, value_name = "UNITS")]
    pub relief: f64,
    /// Distance of two nodes.
    #[arg(long, default_value_t = 10.0, value_name = "UNITS")]
    pub node_distance: f64,
    /// Seed of the random numbers.
    #[arg(long, default_value_t = 1, value_name = "SEED")]
    pub seed: u64,
}

#[rustfmt::skip]
const CELLS: Choices<Cells> = &[
    (Cells::Bilinear, "bilinear", "Bilinear patches, whatever the eye"),
    (Cells::Ruled, "ruled", "Surfaces ruled from edge to edge as the eye sees them: one quotient a pixel and no root"),
    (Cells::Auto, "auto", "Facets where the bilinear patch is flat to half a pixel, else bilinear patches"),
];

fn point(text: &str) -> Result<[f64; 3], String> {
    let numbers = list(text).filter(|numbers| numbers.iter().all(|v: &f64| v.abs() <= 1e9));
    let point = numbers.and_then(|numbers| numbers.try_into().ok());
    point.ok_or_else(|| "three numbers such as 0,120,300 are expected".to_owned())
}

fn region(text: &str) -> Result<Region, String> {
    match list(text).as_deref() {
        Some(&[c, r, m, n]) => Ok(Region {
            first: [c, r],
            nodes: [m, n],
        }),
        _ => Err(
            "first column, first row, columns and rows such as 0,0,33,33 are expected".to_owned(),
        ),
    }
}
