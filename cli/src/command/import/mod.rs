//! `imogene import`: one file per kind of data.

mod faces;
mod molecule;
mod terrain;

use super::looked;
use crate::arguments::{Import, kind_name};
use crate::failure::Failure;
use crate::molecules::load;
use crate::{missing, output};
use imogene_files::text::counted;
use imogene_import::{Kind, is_scene, kinds};
use serde::Serialize;
use std::path::{Path, PathBuf};

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

/// Reads a file and writes its scene.
pub fn run(options: &Import, json: bool) -> Result<(), Failure> {
    let bytes = load(&options.file)?;
    let kind = match options.kind {
        Some(kind) => kind,
        None => kind_of(&bytes, &options.file)?,
    };
    let mut imported = match kind {
        Kind::Structure(format) => molecule::import(bytes, format, options)?,
        Kind::Faces => faces::import(&bytes, options)?,
        Kind::Step => faces::import_step(&bytes, options)?,
        Kind::Heights => terrain::import(&bytes, options)?,
    };
    imported.scene = looked(imported.scene, options.look.look(true), None)?;
    let objects = imported.scene.objects.len();
    let imported = molecule::referred(imported, kind, options)?;
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
        output::text(format!(
            "{}; wrote {}",
            counted(report.objects, "object"),
            options.output.display()
        ));
    });
    Ok(())
}

/// What a file is, or what would be read.
fn kind_of(bytes: &[u8], file: &Path) -> Result<Kind, Failure> {
    let found = Kind::of(bytes, &file.to_string_lossy());
    found.ok_or_else(|| {
        let problem = if is_scene(bytes) {
            "this is a scene already, which every command takes as it is"
        } else {
            "it is nothing that is known"
        };
        Failure::Input(format!(
            "{}: {problem}; {} is read, each also compressed with gzip, or what --as says it is",
            file.display(),
            kinds()
        ))
    })
}
