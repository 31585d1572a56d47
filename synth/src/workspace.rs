//! The build folder of the checkout, where tools and results are kept.

use std::path::PathBuf;

/// The nearest folder `target` at or above the current folder.
pub(crate) fn build_folder() -> Option<PathBuf> {
    let current = std::env::current_dir().ok()?;
    let mut folders = current.ancestors().map(|folder| folder.join("target"));
    folders.find(|folder| folder.is_dir())
}
