//! Molecules: atoms of structure files of the Protein Data Bank as spheres and cylinders.
//!
//! The formats are those of the wwPDB: PDB, "Protein Data Bank Contents Guide", version 3.3, with what older files and other programs write;
//! PDBx/mmCIF; and BinaryCIF.

mod assembly;
mod bcif;
mod biomt;
pub mod bonds;
mod choose;
mod cif;
mod columns;
pub mod element;
pub mod framing;
mod lines;
mod names;
mod options;
mod report;
mod scene;
mod select;
mod structure;
mod words;

pub use options::{Alternates, Colouring, ModelChoice, Options, Residues, Style};

use crate::Imported;
use crate::error::ImportError;
use structure::{Structure, unusable};

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

impl Format {
    fn read(self, bytes: &[u8], file: &str) -> Result<Structure, ImportError> {
        if self == Format::Bcif {
            return bcif::read(bytes, file);
        }
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
            let accepted = "text in UTF-8 would be accepted";
            return Err(unusable(file, "this is text in UTF-16", accepted));
        }
        match self {
            Format::Pdb => lines::read(bytes, file),
            _ => cif::read(bytes, file),
        }
    }
}

/// Reads the bytes of a structure; `file` is the name that messages give it.
pub fn read(
    bytes: &[u8],
    format: Format,
    file: &str,
    options: &Options,
) -> Result<Imported, ImportError> {
    let mut structure = format.read(bytes, file)?;
    let count = report::Read::of(&structure);
    let (chosen, left_out) = choose::choose(&mut structure, file, options)?;
    let drawn = scene::build(&structure, &chosen, file, options)?;
    let (report, notes) = report::report(&structure, &count, &chosen, &left_out, &drawn, options);
    Ok(Imported {
        scene: drawn.scene,
        report,
        notes,
    })
}
