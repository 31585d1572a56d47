//! Arguments of `import`.

mod faces;
mod molecule;
mod terrain;

use super::LookOptions;
use super::parse::{Choices, choice, name};
use clap::Args;
pub use faces::{Deviation, FaceOptions};
use imogene_import::Kind;
use imogene_import::pdb::Format;
pub use molecule::MoleculeOptions;
use std::path::PathBuf;
pub use terrain::{Terrain, TerrainOptions};

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
