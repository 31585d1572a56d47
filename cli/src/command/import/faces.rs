//! `imogene import` of faces.

use crate::arguments::Import;
use crate::failure::Failure;
use imogene_import::Imported;
use imogene_import::faces::{FaceOptions, read};

/// The scene of a file.
pub fn import(bytes: &[u8], options: &Import) -> Result<Imported, Failure> {
    let faces = FaceOptions {
        max_deviation: options.faces.max_deviation,
        no_volumes: options.faces.no_volumes,
    };
    read(bytes, &options.file.display().to_string(), &faces).map_err(Failure::input)
}
