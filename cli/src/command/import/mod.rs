//! `imogene import`: one file per kind of data.

mod faces;
mod molecule;
mod terrain;

use crate::arguments::{Import, ImportKind};
use crate::failure::Failure;
use crate::output;
use imogene_import::Imported;
use imogene_models::text::counted;
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

/// Most bytes of a file: ten million atoms in PDB's columns take eight hundred million.
const MAX_BYTES: u64 = 1 << 30;

/// Reads a file and writes its scene.
pub fn run(options: &Import, json: bool) -> Result<(), Failure> {
    let kind = match options.kind {
        Some(kind) => kind,
        None => kind_of(&options.file)?,
    };
    let bytes = imogene_files::read(&options.file, MAX_BYTES)
        .map_err(|e| Failure::Input(format!("cannot read '{}': {e}", options.file.display())))?;
    let (kind, imported) = match kind {
        ImportKind::Pdb => ("pdb", molecule::import(&bytes, options)?),
        ImportKind::Faces => ("faces", faces::import(&bytes, options)?),
        ImportKind::Step => ("step", faces::import_step(&bytes, options)?),
        ImportKind::Heights => ("heights", terrain::import(&bytes, options)?),
    };
    let text = imported.scene.to_toml().map_err(Failure::input)?;
    output::write_text(&options.output, &text)?;
    print(options, kind, imported, json);
    Ok(())
}

fn print(options: &Import, kind: &'static str, imported: Imported, json: bool) {
    let report = ImportReport {
        file: options.file.clone(),
        kind,
        objects: imported.scene.objects.len(),
        report: imported.report,
        notes: imported.notes,
        files: vec![options.output.clone()],
    };
    if json {
        return output::json(&report);
    }
    for note in &report.notes {
        output::text(note);
    }
    output::text(format!(
        "{}; wrote {}",
        counted(report.objects, "object"),
        options.output.display()
    ));
}

fn kind_of(file: &Path) -> Result<ImportKind, Failure> {
    let name = file.to_string_lossy().to_lowercase();
    let kinds: [(&[&str], ImportKind); 4] = [
        (&[".pdb", ".ent"], ImportKind::Pdb),
        (&[".faces.toml"], ImportKind::Faces),
        (&[".step", ".stp", ".p21"], ImportKind::Step),
        (&[".heights", ".asc"], ImportKind::Heights),
    ];
    let ends = |(endings, _): &&(&[&str], ImportKind)| endings.iter().any(|e| name.ends_with(e));
    kinds.iter().find(ends).map(|(_, kind)| *kind).ok_or_else(|| {
        Failure::Input(format!(
            "'{}' has no extension that says what it is; .pdb, .ent, .faces.toml, .step, .stp, .p21, .heights or .asc, or --as pdb, faces, step or heights",
            file.display()
        ))
    })
}
