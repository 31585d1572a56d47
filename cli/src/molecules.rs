//! Structure files: those that are imported, and those that scenes name.

use crate::failure::{Failure, Result};
use crate::missing;
use imogene_import::{Kind, is_compressed, pdb, unpack};
use imogene_scene::SceneFile;
use std::path::Path;

/// Most bytes of a file, as it is and unpacked: ten million atoms in PDB's columns take eight hundred million.
const MAX_BYTES: u64 = 1 << 30;

/// The bytes of a file, unpacked if they are compressed.
pub fn load(path: &Path) -> Result<Vec<u8>> {
    let bytes = imogene_files::read(path, MAX_BYTES)
        .map_err(|e| Failure::Input(format!("cannot read '{}': {e}", path.display())))?;
    if !is_compressed(&bytes) {
        return Ok(bytes);
    }
    unpack(&bytes, MAX_BYTES, &path.display().to_string()).map_err(Failure::from)
}

/// Bytes of memory for each byte of a structure file, at least: 6.4 were measured of spheres, 18 with cylinders.
const MEMORY_PER_BYTE: u64 = 6;

/// Refuses a structure that does not fit into memory, before the system ends the process for it.
pub fn check_memory(bytes: &[u8], path: &Path) -> Result {
    let needed = bytes.len() as u64 * MEMORY_PER_BYTE;
    let mib = |bytes: u64| bytes >> 20;
    match imogene_files::free_memory() {
        Some(free) if needed > free => Err(Failure::Input(format!(
            "{}: its atoms take {} MiB of memory and more, and {} MiB are free; so much memory would do",
            path.display(),
            mib(needed),
            mib(free)
        ))),
        _ => Ok(()),
    }
}

/// Reads a scene, and the molecules that it names from their files.
pub fn read_scene(path: &Path) -> Result<SceneFile> {
    let mut scene = SceneFile::read(path)?;
    missing::incomplete(path, scene.incomplete.as_deref())?;
    let molecules = std::mem::take(&mut scene.molecules);
    if molecules.is_empty() {
        return Ok(scene);
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    for molecule in &molecules {
        let file = folder.join(&molecule.file);
        let name = file.display().to_string();
        let bytes = load(&file)?;
        check_memory(&bytes, &file)?;
        let Some(Kind::Structure(format)) = Kind::of(&bytes, &name) else {
            return Err(Failure::Input(format!(
                "{name}: it is no structure, as the scene {} says; the PDB, PDBx/mmCIF or BinaryCIF format would be accepted",
                path.display()
            )));
        };
        pdb::add(&mut scene, molecule, &bytes, format, &name)?;
    }
    scene.validate().map_err(Failure::in_file(path))?;
    Ok(scene)
}
