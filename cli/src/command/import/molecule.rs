//! `imogene import` of a molecule.

use crate::arguments::Import;
use crate::failure::Failure;
use imogene_import::Imported;
use imogene_import::pdb::{self, Format};

/// The scene of a file.
pub fn import(bytes: &[u8], format: Format, options: &Import) -> Result<Imported, Failure> {
    let file = options.file.display().to_string();
    pdb::read(bytes, format, &file, &options.molecule.options()).map_err(Failure::input)
}
