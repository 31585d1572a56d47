//! `imogene check`.

use super::load_scene;
use crate::arguments::Check;
use crate::failure::{Failure, Result};
use crate::output;
use imogene_analysis::bounds::{CheckReport, check};
use imogene_studies::picture;
use std::path::Path;

pub fn run(options: &Check, json: bool) -> Result {
    let map = options.map.as_deref();
    let is_picture = map.map(is_picture).transpose()?;
    let (framed, prepared) = load_scene(&options.scene)?;
    let report = check(&framed, &prepared);
    if let Some((path, is_picture)) = map.zip(is_picture) {
        write_map(path, is_picture, &report.marks(), prepared.width as usize)?;
    }
    let files = options.map.iter().cloned().collect();
    output::written(json, &report, files, include_str!("check.txt"))?;
    verdict(&report)
}

fn verdict(report: &CheckReport) -> Result {
    let adrift = report.objects.iter().filter(|o| o.undecided.adrift > 0);
    let why = match output::joined(adrift.map(|o| format!("'{}'", o.name)), ", ") {
        none if none.is_empty() => "a word wraps".to_owned(),
        adrift => {
            format!("the outline of {adrift} may be a pixel or more away from the true one")
        }
    };
    Failure::unless(report.ok, || format!("{why}; see the objects' problems"))
}

/// Whether a map is a picture, or else an array.
fn is_picture(path: &Path) -> Result<bool> {
    match path.extension().and_then(|e| e.to_str()) {
        Some("png") => Ok(true),
        Some("npy") => Ok(false),
        _ => Err(Failure::Input(format!(
            "--map '{}': neither a picture nor an array; give a name that ends in .png or .npy",
            path.display()
        ))),
    }
}

/// Writes a file of the open pixels.
fn write_map(path: &Path, is_picture: bool, marks: &[u8], width: usize) -> Result {
    let mut files = output::files();
    files.add(path, |out| {
        if !is_picture {
            return picture::marks(out, width, marks);
        }
        let colours = marks.iter().map(|&m| COLOURS[usize::from(m)]);
        let rgb: Vec<u8> = colours.flatten().collect();
        picture::png(out, width, marks.len() / width, &rgb)
    })?;
    files.finish()?;
    Ok(())
}

/// Of the marks of a map: decided, object or face open, light open, both.
const COLOURS: [[u8; 3]; 4] = [[0, 0, 0], [255, 255, 255], [255, 160, 0], [255, 80, 80]];
