//! `imogene import` of a molecule.

use crate::arguments::Import;
use crate::failure::Failure;
use crate::molecules::check_memory;
use imogene_import::pdb::{self, Format};
use imogene_import::{Imported, Kind};
use pathdiff::diff_paths;
use std::path::Path;

/// Most objects that are written one by one unless they are asked for: some ten thousand lines are more than anyone
/// reads.
const MOST_LINES: usize = 20_000;

/// The scene of a file.
pub fn import(bytes: Vec<u8>, format: Format, options: &Import) -> Result<Imported, Failure> {
    check_memory(&bytes, &options.file)?;
    let file = options.file.display().to_string();
    pdb::read(&bytes, format, &file, &options.molecule.options()).map_err(Failure::from)
}

/// The same scene, which names its structure file instead of listing the objects, if that is asked for or the list
/// would be long.
pub fn referred(mut imported: Imported, kind: Kind, options: &Import) -> Result<Imported, Failure> {
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
fn relative(file: &Path, other: &Path) -> Result<String, Failure> {
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
