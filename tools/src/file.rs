//! Texts that programs exchange over files.

use std::io;
use std::path::{Path, PathBuf};
use tempfile::TempDir;
use thiserror::Error;

/// A file that cannot be read or written, or a program that does not start.
#[derive(Debug, Error)]
#[error("{}: {source}", path.display())]
pub struct FileError {
    /// File, folder or program.
    pub path: PathBuf,
    /// What the system says.
    pub source: io::Error,
}

impl FileError {
    /// Makes an error of the system into one that names the file.
    pub fn at(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> FileError {
        let path = path.into();
        move |source| FileError { path, source }
    }
}

/// Reads a text file. Fails when it cannot be read.
pub fn read(path: &Path) -> Result<String, FileError> {
    std::fs::read_to_string(path).map_err(FileError::at(path))
}

/// Writes a text file. Fails when it cannot be written.
pub fn write(path: &Path, text: &str) -> Result<(), FileError> {
    std::fs::write(path, text).map_err(FileError::at(path))
}

/// A temporary folder for a program to work in. Fails when it cannot be made.
pub fn scratch() -> Result<TempDir, FileError> {
    tempfile::tempdir().map_err(FileError::at(std::env::temp_dir()))
}
