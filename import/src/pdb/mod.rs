//! Molecules: atoms of a structure file of the Protein Data Bank as spheres and cylinders.
//!
//! The format is that of the wwPDB, "Protein Data Bank Contents Guide", version 3.3, with what older files and other programs write.

pub mod bonds;
mod choose;
mod columns;
pub mod element;
pub mod framing;
mod names;
mod report;
mod scene;
mod structure;

use crate::Imported;
use crate::error::ImportError;
use structure::Structure;

/// How a molecule is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Style {
    /// Every atom as a sphere of its van der Waals radius.
    #[default]
    SpaceFilling,
    /// Small spheres, and cylinders for bonds.
    BallAndStick,
}

/// What gives an atom its colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Colouring {
    /// Its element.
    #[default]
    Element,
    /// Its chain.
    Chain,
    /// Its model.
    Model,
}

/// Which models are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ModelChoice {
    /// The first of the file.
    #[default]
    First,
    /// The first of this number.
    Number(i64),
    /// All, each where its coordinates put it.
    All,
}

/// Which locations of atoms that have several are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Alternates {
    /// In each residue the alternate of the highest mean occupancy; of equal ones that whose atoms stand first.
    #[default]
    Best,
    /// The alternate of a letter, and the best where a residue has no such.
    Letter(u8),
    /// All.
    All,
}

/// How a file is read; the default draws all atoms of the first model.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// How it is drawn.
    pub style: Style,
    /// What gives the colours.
    pub colouring: Colouring,
    /// Which models.
    pub model: ModelChoice,
    /// Which alternate locations.
    pub alternates: Alternates,
    /// Whether hydrogens are drawn.
    pub hydrogens: bool,
    /// Whether water is drawn.
    pub water: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            style: Style::default(),
            colouring: Colouring::default(),
            model: ModelChoice::default(),
            alternates: Alternates::default(),
            hydrogens: true,
            water: true,
        }
    }
}

/// Reads the bytes of a structure; `file` is the name that messages give it.
pub fn read(bytes: &[u8], file: &str, options: &Options) -> Result<Imported, ImportError> {
    let mut structure = Structure::read(bytes, file)?;
    let count = report::Read::of(&structure);
    let (chosen, left_out) = choose::choose(&mut structure, file, options)?;
    let drawn = scene::build(&structure, &chosen, file, options)?;
    let (report, notes) = report::report(&structure, &count, &chosen, &left_out, &drawn);
    Ok(Imported {
        scene: drawn.scene,
        report,
        notes,
    })
}
