//! Where programs are, and which version they are.

use std::path::PathBuf;

/// Environment variable that names the only folder to look in.
pub const FOLDER_VARIABLE: &str = "IMOGENE_TOOLS";

/// The nearest of these below a folder at or above the current one.
fn above(name: &str) -> Option<PathBuf> {
    let current = std::env::current_dir().ok()?;
    let mut folders = current.ancestors().map(|folder| folder.join(name));
    folders.find(|folder| folder.is_dir())
}

/// The build folder of the checkout: the nearest folder `target` at or above the current folder.
pub fn target_folder() -> Option<PathBuf> {
    above("target")
}

/// The folder that the environment names, or that of the tools that the set-up installs.
pub fn own_folders() -> Vec<PathBuf> {
    let named = std::env::var_os(FOLDER_VARIABLE).map(PathBuf::from);
    let folder = named.or_else(|| above("target/tools/bin"));
    folder.into_iter().collect()
}

/// The folders of the variable `PATH`.
pub fn path_folders() -> Vec<PathBuf> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path).collect()
}

/// Where to look for programs. A folder given by the environment is the only one: figures never come from another tool
/// than the one asked for.
pub fn search_folders() -> Vec<PathBuf> {
    let mut folders = own_folders();
    if std::env::var_os(FOLDER_VARIABLE).is_none() {
        folders.extend(path_folders());
    }
    folders
}

/// The first program of these names; in one folder the earlier name comes first.
pub fn find(folders: &[PathBuf], names: &[&str]) -> Option<PathBuf> {
    let folders = folders.iter();
    let mut paths = folders.flat_map(|folder| names.iter().map(|name| folder.join(name)));
    paths.find(|path| path.is_file())
}

/// The version in the answer of a program.
pub fn version(answer: &str) -> Option<&str> {
    let is_number = |word: &&str| word.starts_with(|c: char| c.is_ascii_digit());
    let mut words = answer.split_whitespace();
    let word = words.find(|word| is_number(word) || word.starts_with("nextpnr-0"))?;
    Some(word.trim_start_matches("nextpnr-").trim_end_matches(')'))
}
