//! `imogene import` of faces: face lists and STEP files.

use crate::arguments::Import;
use crate::failure::Failure;
use crate::molecules::load;
use imogene_import::Imported;
use imogene_import::faces::{FaceOptions, read, read_step};
use std::path::Path;

/// The scene of a face list.
pub fn import(bytes: &[u8], options: &Import) -> Result<Imported, Failure> {
    read(bytes, &name(options), &asked(options)).map_err(Failure::input)
}

/// The scene of a STEP file.
pub fn import_step(bytes: &[u8], options: &Import) -> Result<Imported, Failure> {
    let folder = options.file.parent().unwrap_or(Path::new(""));
    let beside = |name: &str| load(&folder.join(name)).ok();
    read_step(bytes, &name(options), &asked(options), &beside).map_err(Failure::input)
}

fn name(options: &Import) -> String {
    options.file.display().to_string()
}

fn asked(options: &Import) -> FaceOptions {
    FaceOptions {
        max_deviation: options.faces.max_deviation,
        no_volumes: options.faces.no_volumes,
    }
}
