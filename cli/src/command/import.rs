//! `imogene import`.

use super::looked;
use crate::arguments::{Deviation, Import, kind_name};
use crate::failure::{Failure, Result};
use crate::molecules::{check_memory, load};
use crate::{missing, output};
use imogene_files::text::counted;
use imogene_import::faces::{FaceOptions, read, read_step};
use imogene_import::pdb;
use imogene_import::terrain::{self, TerrainOptions};
use imogene_import::{ImportError, Imported, Kind, is_scene, kinds};
use pathdiff::diff_paths;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Most objects that are written one by one unless they are asked for: some ten thousand lines are more than anyone
/// reads.
const MOST_LINES: usize = 20_000;

/// What was read; the keys are stable.
#[derive(Serialize)]
struct ImportReport {
    file: PathBuf,
    kind: &'static str,
    objects: usize,
    report: serde_json::Value,
    notes: Vec<String>,
    files: Vec<PathBuf>,
}

pub fn run(options: &Import, json: bool) -> Result {
    let bytes = load(&options.file)?;
    let kind = match options.kind {
        Some(kind) => kind,
        None => kind_of(&bytes, &options.file)?,
    };
    let mut imported = match kind {
        Kind::Structure(format) => {
            check_memory(&bytes, &options.file)?;
            pdb::read(&bytes, format, &name(options), &options.molecule.options())?
        }
        Kind::Faces => within(options, |asked| read(&bytes, &name(options), asked))?,
        Kind::Step => step(&bytes, options)?,
        Kind::Heights => heights(&bytes, options)?,
    };
    imported.scene = looked(imported.scene, options.look.look(true), None)?;
    let objects = imported.scene.objects.len();
    let imported = referred(imported, kind, options)?;
    missing::incomplete(&options.file, imported.scene.incomplete.as_deref())?;
    let text = imported.scene.to_toml()?;
    output::write_text(&options.output, &text)?;
    let report = ImportReport {
        file: options.file.clone(),
        kind: kind_name(kind),
        objects,
        report: imported.report,
        notes: imported.notes,
        files: vec![options.output.clone()],
    };
    output::report(json, &report, |report| {
        report.notes.iter().for_each(output::text);
        let (objects, path) = (counted(objects, "object"), options.output.display());
        output::text(format!("{objects}; wrote {path}"));
    });
    Ok(())
}

/// What a file is, or what would be read.
fn kind_of(bytes: &[u8], file: &Path) -> Result<Kind> {
    let found = Kind::of(bytes, &file.to_string_lossy());
    found.ok_or_else(|| {
        let problem = match is_scene(bytes) {
            true => "this is a scene already, which every command takes as it is",
            false => "it is nothing that is known",
        };
        Failure::Input(format!(
            "{}: {problem}; {} is read, each also compressed with gzip, or what --as says it is",
            file.display(),
            kinds()
        ))
    })
}

/// The same scene, which names its structure file instead of listing the objects, if that is asked for or the list
/// would be long.
fn referred(mut imported: Imported, kind: Kind, options: &Import) -> Result<Imported> {
    let asked = &options.molecule;
    let is_long = imported.scene.objects.len() > MOST_LINES && !asked.inline;
    if !matches!(kind, Kind::Structure(_)) || !(asked.reference || is_long) {
        return Ok(imported);
    }
    let file = relative(&options.file, &options.output)?;
    imported.scene.objects.clear();
    imported.scene.molecules = vec![asked.molecule(&file)];
    imported.notes.push(format!(
        "the scene names {file} and takes its atoms from there; --inline writes an object for each"
    ));
    Ok(imported)
}

/// The path of a file from the folder of another, which may not be there yet.
fn relative(file: &Path, other: &Path) -> Result<String> {
    let folder = other.parent().filter(|folder| *folder != Path::new(""));
    let folder = folder.unwrap_or(Path::new(".")).canonicalize().ok();
    let whole = file.canonicalize().unwrap_or(file.to_owned());
    let path = folder.and_then(|folder| diff_paths(&whole, folder));
    let path = path.unwrap_or(whole);
    let text = path.to_str().ok_or_else(|| {
        Failure::Input(format!(
            "{}: the path is not text in UTF-8, as that of a molecule in a scene must be; --inline needs none",
            path.display()
        ))
    })?;
    Ok(text.replace('\\', "/"))
}

fn step(bytes: &[u8], options: &Import) -> Result<Imported> {
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
) -> Result<Imported> {
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
        return Err(Failure::Input(format!(
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

fn heights(bytes: &[u8], options: &Import) -> Result<Imported> {
    let asked = &options.terrain;
    let factor = asked.height_factor;
    if !(factor != 0.0 && factor.abs() <= 1e6) {
        return Err(Failure::Input(format!(
            "a height factor of {factor}; any number but 0 up to 1000000 is accepted"
        )));
    }
    let title = options.file.file_stem().map(|name| name.to_string_lossy());
    let asked = TerrainOptions {
        cells: asked.cells,
        height_factor: factor,
        region: asked.region,
        every: asked.every as usize,
        eye: asked.eye_at,
        target: asked.look_at,
        title: title.map_or("Terrain".to_owned(), |name| name.into_owned()),
    };
    Ok(terrain::import(bytes, &name(options), &asked)?)
}
