//! Verilog that this build of the program has emitted before.

use crate::error::GeneratorError;
use imogene_rtl::emit::Emitted;
use imogene_rtl::emit::machine::MachineRequest;
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

/// The folder of what fitted hardware needs: the program, its lock, its results.
pub(crate) fn folder() -> PathBuf {
    workspace().join("target").join("fitted")
}

/// Where the sources were when this program was built.
pub(crate) fn workspace() -> PathBuf {
    let generator = Path::new(env!("CARGO_MANIFEST_DIR"));
    generator.parent().unwrap_or(generator).to_path_buf()
}

/// Results of the same sources.
pub(crate) struct Cache {
    folder: PathBuf,
    sources: String,
}

impl Cache {
    pub fn open() -> Result<Cache, GeneratorError> {
        let sources = workspace().join("rtl").join("src");
        if !sources.is_dir() {
            return Err(GeneratorError::Sources(workspace()));
        }
        let folder = folder().join("verilog");
        std::fs::create_dir_all(&folder).map_err(GeneratorError::file(&folder))?;
        let mut digest = Sha256::new();
        add_folder(&mut digest, &sources)?;
        Ok(Cache {
            folder,
            sources: hexadecimal(&digest.finalize()),
        })
    }

    fn path(&self, request: &MachineRequest) -> PathBuf {
        let request = serde_json::to_string(request).expect("plain numbers and texts");
        let key = Sha256::digest(format!("{}\n{request}", self.sources));
        self.folder.join(format!("{}.json", hexadecimal(&key)))
    }

    pub fn load(&self, request: &MachineRequest) -> Option<Emitted> {
        let text = std::fs::read_to_string(self.path(request)).ok()?;
        serde_json::from_str(&text).ok()
    }

    pub fn store(&self, request: &MachineRequest, emitted: &Emitted) -> Result<(), GeneratorError> {
        let path = self.path(request);
        let text = serde_json::to_string(emitted).expect("plain numbers and texts");
        // Written beside and renamed: another process never reads half an entry.
        let file = tempfile::NamedTempFile::new_in(&self.folder);
        let mut file = file.map_err(GeneratorError::file(&self.folder))?;
        let written = std::io::Write::write_all(&mut file, text.as_bytes());
        written.map_err(GeneratorError::file(&path))?;
        let kept = file.persist(&path);
        kept.map_err(|error| GeneratorError::file(&path)(error.error))?;
        Ok(())
    }
}

/// Names, lengths and times of change of all files: that is what cargo goes by too.
fn add_folder(digest: &mut Sha256, folder: &Path) -> Result<(), GeneratorError> {
    let entries = std::fs::read_dir(folder).map_err(GeneratorError::file(folder))?;
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            add_folder(digest, &path)?;
            continue;
        }
        let facts = path.metadata().map_err(GeneratorError::file(&path))?;
        let changed = facts.modified().ok();
        let changed = changed.and_then(|time| time.duration_since(UNIX_EPOCH).ok());
        digest.update(format!("{} {} {changed:?}\n", path.display(), facts.len()));
    }
    Ok(())
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
