//! Results kept by what they depend on, so that a table is made again only where something changed.

use crate::error::SynthError;
use crate::workspace::build_folder;
use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};
use std::path::PathBuf;

/// Digest of a Verilog text; comment lines do not count, for they change no cell.
pub fn digest(verilog: &str) -> String {
    let lines = verilog
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    hash(lines)
}

fn hash<'a>(parts: impl IntoIterator<Item = &'a str>) -> String {
    let mut hasher = Sha256::new();
    for part in parts {
        hasher.update(part.as_bytes());
        hasher.update(b"\n");
    }
    let bytes = hasher.finalize();
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Whether kept results count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Cache {
    /// A result of the same Verilog and tools is taken as it is.
    #[default]
    Use,
    /// Everything is synthesised, and then kept.
    Renew,
}

/// Where one result is kept.
pub(crate) struct Kept {
    path: Option<PathBuf>,
}

impl Kept {
    /// The place of a result that depends on these texts alone. Outside a checkout nothing is kept.
    pub fn new(parts: &[&str]) -> Self {
        let name = format!("{}.json", hash(parts.iter().copied()));
        let path = build_folder().map(|folder| folder.join("synth-cache").join(name));
        Self { path }
    }

    /// The result, if it is kept and of this form.
    pub fn load<T: DeserializeOwned>(&self) -> Option<T> {
        let text = std::fs::read_to_string(self.path.as_ref()?).ok()?;
        serde_json::from_str(&text).ok()
    }

    /// Keeps a result.
    pub fn store(&self, result: &impl Serialize) -> Result<(), SynthError> {
        let Some(path) = &self.path else {
            return Ok(());
        };
        let folder = path
            .parent()
            .expect("an entry lies in the folder of the cache");
        std::fs::create_dir_all(folder).map_err(SynthError::file(folder))?;
        let text =
            serde_json::to_string_pretty(result).expect("results have no unserialisable keys");
        // Written beside and renamed: another process never reads half an entry.
        let mut file = tempfile::NamedTempFile::new_in(folder).map_err(SynthError::file(folder))?;
        std::io::Write::write_all(&mut file, text.as_bytes()).map_err(SynthError::file(path))?;
        file.persist(path)
            .map_err(|error| SynthError::file(path)(error.error))?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_do_not_change_the_digest() {
        let text = "// a\nmodule m;\nendmodule\n";
        assert_eq!(
            digest(text),
            digest("// b\n    // c\nmodule m;\nendmodule\n")
        );
        assert_ne!(digest(text), digest("module n;\nendmodule\n"));
    }
}
