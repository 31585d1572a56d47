//! Results kept by what they depend on, so that work is done again only where something changed.

use crate::file::{FileError, write};
use imogene_files::Scratch;
use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};

/// Digest of texts, each with a line break behind it.
pub fn digest<'a>(parts: impl IntoIterator<Item = &'a str>) -> String {
    let mut hasher = Sha256::new();
    for part in parts {
        hasher.update(part.as_bytes());
        hasher.update(b"\n");
    }
    let bytes = hasher.finalize();
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Makes a file unless it is there: whole or not at all. `make` works in a folder beside it, and names its result
/// there. Fails when it cannot be made.
pub fn made<E: From<FileError>>(
    path: &Path,
    make: impl FnOnce(&Path) -> Result<&'static str, E>,
) -> Result<(), E> {
    if path.is_file() {
        return Ok(());
    }
    renewed(path, make)
}

fn renewed<E: From<FileError>>(
    path: &Path,
    make: impl FnOnce(&Path) -> Result<&'static str, E>,
) -> Result<(), E> {
    let folder = path.parent().unwrap_or(Path::new(""));
    std::fs::create_dir_all(folder).map_err(FileError::at(folder))?;
    let scratch = Scratch::new_in(folder, "build-").map_err(FileError::at(folder))?;
    let name = make(scratch.path())?;
    // Renamed within one file system, so that another process never reads half a file.
    std::fs::rename(scratch.path().join(name), path).map_err(FileError::at(path))?;
    Ok(())
}

/// Where one result is kept.
pub struct Kept(Option<PathBuf>);

impl Kept {
    /// The place of a result in a folder that depends on these texts alone. Without a folder nothing is kept.
    pub fn new(folder: Option<PathBuf>, parts: &[&str]) -> Kept {
        let name = format!("{}.json", digest(parts.iter().copied()));
        Kept(folder.map(|folder| folder.join(name)))
    }

    /// The result, if it is kept and of this form.
    pub fn load<T: DeserializeOwned>(&self) -> Option<T> {
        let text = std::fs::read_to_string(self.0.as_ref()?).ok()?;
        serde_json::from_str(&text).ok()
    }

    /// The result, or else what `make` gives, which is kept. Fails when that does, or it cannot be written.
    pub fn or_made<T: DeserializeOwned + Serialize, E: From<FileError>>(
        &self,
        make: impl FnOnce() -> Result<T, E>,
    ) -> Result<T, E> {
        if let Some(result) = self.load() {
            return Ok(result);
        }
        let result = make()?;
        self.store(&result)?;
        Ok(result)
    }

    /// Keeps a result. Fails when it cannot be written. Panics if its keys are no texts.
    pub fn store(&self, result: &impl Serialize) -> Result<(), FileError> {
        let Some(path) = &self.0 else {
            return Ok(());
        };
        let text =
            serde_json::to_string_pretty(result).expect("results have no unserialisable keys");
        renewed(path, |folder| {
            write(&folder.join("result.json"), &text)?;
            Ok("result.json")
        })
    }
}
