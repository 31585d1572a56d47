//! Arguments of `import`.

mod faces;
mod molecule;
mod terrain;

use super::LookOptions;
use clap::{Args, ValueEnum};
pub use faces::{Deviation, FaceOptions};
use imogene_import::Kind;
pub use molecule::MoleculeOptions;
use std::path::PathBuf;
pub use terrain::{CellForm, Terrain, TerrainOptions};

/// Arguments of `import`.
#[derive(Debug, Args)]
pub struct Import {
    /// File to read: a molecule, a face list, a STEP file or a grid of heights; it may be compressed with gzip.
    pub file: PathBuf,
    /// Scene file to write.
    #[arg(short, long, value_name = "SCENE.toml")]
    pub output: PathBuf,
    /// What the file is; found out from what it holds, and else from its name.
    #[arg(long = "as", value_enum, value_name = "KIND")]
    pub kind: Option<ImportKind>,
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
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ImportKind {
    /// A structure of the Protein Data Bank in its PDB format (.pdb, .ent).
    Pdb,
    /// A structure in the PDBx/mmCIF format (.cif, .mmcif).
    Mmcif,
    /// A structure in the BinaryCIF format (.bcif).
    Bcif,
    /// A list of CAD faces (.faces.toml).
    Faces,
    /// A STEP file, ISO 10303-21 (.step, .stp, .p21).
    Step,
    /// A grid of heights (.heights, .asc).
    Heights,
}

impl ImportKind {
    /// The kind that it names.
    pub fn kind(self) -> Kind {
        match self {
            ImportKind::Pdb => Kind::Pdb,
            ImportKind::Mmcif => Kind::Mmcif,
            ImportKind::Bcif => Kind::Bcif,
            ImportKind::Faces => Kind::Faces,
            ImportKind::Step => Kind::Step,
            ImportKind::Heights => Kind::Heights,
        }
    }
}
