//! What a process has begun and must not leave behind when it is interrupted.

use std::collections::BTreeSet;
use std::fs::File;
use std::io;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::{TempDir, TempPath};

/// Temporary files and folders of this process.
pub(crate) struct Litter {
    files: BTreeSet<PathBuf>,
    scratch: BTreeSet<PathBuf>,
    /// Folders made for files that are not there yet, outer ones first.
    folders: Vec<PathBuf>,
}

static LITTER: Mutex<Litter> = Mutex::new(Litter {
    files: BTreeSet::new(),
    scratch: BTreeSet::new(),
    folders: vec![],
});

/// Holds off [`end_process`] until it is dropped.
pub(crate) fn litter() -> MutexGuard<'static, Litter> {
    LITTER.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Litter {
    /// A new temporary file with the permissions of an ordinary one; temporary files are private by default.
    pub(crate) fn new_file(&mut self, folder: &Path) -> io::Result<(File, TempPath)> {
        let made = tempfile::Builder::new()
            .prefix(".imogene-")
            .permissions(std::fs::Permissions::from_mode(0o666))
            .tempfile_in(folder);
        let (file, path) = made.map_err(without_name)?.into_parts();
        self.files.insert(path.to_path_buf());
        Ok((file, path))
    }

    /// The file has got its name, or is gone.
    pub(crate) fn forget_file(&mut self, path: &Path) {
        self.files.remove(path);
    }

    /// Makes a folder and those above it; returns the ones that were not there, outer ones first.
    pub(crate) fn new_folders(&mut self, folder: &Path) -> io::Result<Vec<PathBuf>> {
        let missing = |folder: &&Path| !folder.as_os_str().is_empty() && !folder.exists();
        let made = folder.ancestors().take_while(missing);
        let mut made: Vec<PathBuf> = made.map(PathBuf::from).collect();
        made.reverse();
        self.folders.extend(made.iter().cloned());
        std::fs::create_dir_all(folder)?;
        Ok(made)
    }

    fn clear_away(&self) {
        for file in &self.files {
            let _ = std::fs::remove_file(file);
        }
        for folder in &self.scratch {
            let _ = std::fs::remove_dir_all(folder);
        }
        remove_empty(&self.folders);
    }

    /// The folders stay.
    pub(crate) fn forget_folders(&mut self, folders: &[PathBuf]) {
        self.folders.retain(|folder| !folders.contains(folder));
    }
}

/// The error without the name of a temporary file, which nobody has asked for.
fn without_name(error: io::Error) -> io::Error {
    let said = error.to_string();
    match said.split_once(" at path ") {
        Some((problem, _)) => io::Error::new(error.kind(), problem),
        None => error,
    }
}

/// Removes folders in which nothing was put, inner ones first.
pub(crate) fn remove_empty(folders: &[PathBuf]) {
    for folder in folders.iter().rev() {
        // Another process may have put something there: then it stays.
        let _ = std::fs::remove_dir(folder);
    }
}

/// Ends the process with this exit code. Temporary files, scratch folders and folders made for files that never came
/// are removed first; a set that is being renamed is renamed to its end.
pub fn end_process(code: i32) -> ! {
    // Held until the end: no other thread begins a file after this.
    let litter = litter();
    litter.clear_away();
    std::process::exit(code)
}

/// The same where nothing may be waited for; what another thread is about to name is left.
pub fn end_process_at_once(code: i32) -> ! {
    let litter = LITTER.try_lock();
    if let Ok(litter) = &litter {
        litter.clear_away();
    }
    std::process::exit(code)
}

/// A folder for files of no lasting worth; it is removed with all its contents when this is dropped, or by
/// [`end_process`].
#[derive(Debug)]
pub struct Scratch(TempDir);

impl Scratch {
    /// A new one in a folder, whose name begins with the prefix. Fails when it cannot be made.
    pub fn new_in(folder: &Path, prefix: &str) -> io::Result<Scratch> {
        let mut litter = litter();
        let made = tempfile::Builder::new().prefix(prefix).tempdir_in(folder);
        let made = made.map_err(without_name)?;
        litter.scratch.insert(made.path().to_path_buf());
        Ok(Scratch(made))
    }

    /// A new one in the system's temporary folder, in which all further temporary files and folders of this process
    /// are made: [`end_process`] removes them with it. Fails when it cannot be made.
    pub fn of_process() -> io::Result<Scratch> {
        let scratch = Scratch::new_in(&std::env::temp_dir(), "imogene-")?;
        let set = tempfile::env::override_temp_dir(scratch.path());
        set.map_err(|_| io::Error::other("temporary files have their folder already"))?;
        Ok(scratch)
    }

    /// The folder.
    pub fn path(&self) -> &Path {
        self.0.path()
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        litter().scratch.remove(self.0.path());
    }
}
