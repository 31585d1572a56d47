//! `imogene import` of faces: face lists and STEP files.

use crate::arguments::{Deviation, Import};
use crate::failure::Failure;
use crate::molecules::load;
use imogene_import::faces::{FaceOptions, read, read_step};
use imogene_import::{ImportError, Imported};
use std::path::Path;

/// The scene of a face list.
pub fn import(bytes: &[u8], options: &Import) -> Result<Imported, Failure> {
    within(options, |asked| read(bytes, &name(options), asked))
}

/// The scene of a STEP file.
pub fn import_step(bytes: &[u8], options: &Import) -> Result<Imported, Failure> {
    let folder = options.file.parent().unwrap_or(Path::new(""));
    let beside = |name: &str| load(&folder.join(name)).ok();
    within(options, |asked| {
        read_step(bytes, &name(options), asked, &beside)
    })
}

fn name(options: &Import) -> String {
    options.file.display().to_string()
}

/// Reads within the deviation that is asked for. One in pixels needs a picture first: what is read within the usual
/// deviation gives it, looked at as the user wants.
fn within(
    options: &Import,
    read: impl Fn(&FaceOptions) -> Result<Imported, ImportError>,
) -> Result<Imported, Failure> {
    let read = |max_deviation: Option<f64>| {
        let no_volumes = options.faces.no_volumes;
        read(&FaceOptions {
            max_deviation,
            no_volumes,
        })
        .map_err(Failure::from)
    };
    let pixels = match options.faces.max_deviation {
        None => return read(None),
        Some(Deviation::Length(length)) => return read(Some(length)),
        Some(Deviation::Pixels(pixels)) => pixels,
    };
    let mut scene = read(None)?.scene;
    let (width, height) = (scene.image.width, scene.image.height);
    if let Some(look) = options.look.look(true) {
        (scene, _) = look.applied(&scene, (width, height))?;
    }
    let pixel = scene.nearest_pixel(height)?;
    if !(pixel.is_finite() && pixel > 0.0) {
        return Err(Failure::input(format!(
            "--max-deviation {pixels}px: a pixel has no size where the nearest face is, because the camera is within the \
             part; a length, as in --max-deviation 0.01, or a camera outside would be accepted"
        )));
    }
    let mut imported = read(Some(pixels * pixel))?;
    imported.notes.push(format!(
        "a pixel of {width}x{height} is {pixel:.3e} or more; nothing is off by more than {:.3e}",
        pixels * pixel
    ));
    Ok(imported)
}
