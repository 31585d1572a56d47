//! `imogene import` of terrain.

use crate::arguments::Import;
use crate::failure::Failure;
use imogene_import::Imported;

/// The scene of a file.
pub fn import(_bytes: &[u8], options: &Import) -> Result<Imported, Failure> {
    Err(Failure::Input(format!(
        "'{}': this kind is not read yet",
        options.file.display()
    )))
}
