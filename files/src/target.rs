//! What the name of an output stands for.

use crate::litter::litter;
use std::fs::{self, OpenOptions};
use std::io::{Error, ErrorKind, Result};
use std::os::unix::fs::{FileTypeExt, MetadataExt};
use std::path::{Path, PathBuf};

/// As many as the system follows.
const MAX_LINKS: usize = 40;

/// What is written to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// Standard output: `-`, or one of the system's names for it.
    Standard,
    /// A device, a pipe, or a file that this process was started with: it is written to and stays.
    Stream(PathBuf),
    /// A regular file, there or not, with all links followed: it is replaced.
    File(PathBuf),
}

/// What two names of one file have in common.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Identity {
    /// Standard output.
    Standard,
    /// Device and number of a file that is there.
    Node(u64, u64),
    /// Name of a file that is not there, in a folder without links.
    Name(PathBuf),
}

impl Target {
    /// What a path names. Fails when nothing can be written there.
    pub fn of(path: &Path) -> Result<Target> {
        if path == Path::new("-") {
            return Ok(Target::Standard);
        }
        let mut path = path.to_path_buf();
        for _ in 0..MAX_LINKS {
            if let Some(open) = open_file(&path) {
                return Ok(open);
            }
            match fs::read_link(&path) {
                Ok(next) => path = folder_of(&path).join(next),
                Err(_) => return end_of_links(path),
            }
        }
        Err(Error::other("its symbolic links lead in a circle"))
    }

    /// What no other output may share; none of a device, to which much can be written. Fails when the system does not
    /// tell.
    pub fn identity(&self) -> Result<Option<Identity>> {
        match self {
            Target::Standard => Ok(Some(Identity::Standard)),
            Target::Stream(path) | Target::File(path) => Identity::of(path),
        }
    }

    /// Refuses what nothing can be written to. Nothing is left there. Fails when the folder of the file cannot be
    /// made, or takes no file.
    pub fn check(&self) -> Result<()> {
        match self {
            Target::File(path) => check_folder(folder_of(path)),
            Target::Standard | Target::Stream(_) => Ok(()),
        }
    }
}

impl Identity {
    /// Of a file, for which a name with links does as well. Fails when the system does not tell.
    pub fn of(path: &Path) -> Result<Option<Identity>> {
        match fs::metadata(path) {
            Ok(facts) if facts.file_type().is_char_device() => Ok(None),
            Ok(facts) => Ok(Some(Identity::Node(facts.dev(), facts.ino()))),
            Err(error) if error.kind() == ErrorKind::NotFound => {
                let folder = existing(folder_of(path));
                let below = path.strip_prefix(folder).unwrap_or(path);
                Ok(Some(Identity::Name(fs::canonicalize(folder)?.join(below))))
            }
            Err(error) => Err(error),
        }
    }
}

/// Refuses a folder that takes no files, or cannot be made. Nothing is left there. Fails when it is a file, lies below
/// one, or is closed to us.
pub fn check_folder(folder: &Path) -> Result<()> {
    let there = existing(folder);
    if !there.is_dir() {
        let problem = match there == folder {
            true => "it is a file; a folder is wanted, one that is there or a new one".to_owned(),
            false => format!(
                "'{}' is a file, and no folder can be below it",
                there.display()
            ),
        };
        return Err(Error::new(ErrorKind::NotADirectory, problem));
    }
    let mut litter = litter();
    let (_, probe) = litter.new_file(there)?;
    litter.forget_file(&probe);
    Ok(())
}

/// The folder of a file.
pub(crate) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// The innermost part of a path that is there.
fn existing(path: &Path) -> &Path {
    let there = |path: &&Path| fs::symlink_metadata(path).is_ok();
    path.ancestors().find(there).unwrap_or(Path::new("."))
}

fn end_of_links(path: PathBuf) -> Result<Target> {
    let refused = |why: &str| Err(Error::new(ErrorKind::IsADirectory, why));
    match fs::metadata(&path) {
        Ok(facts) if facts.is_dir() => refused("it is a folder; a file is wanted"),
        Ok(facts) if facts.is_file() => {
            // A file that may not be written to is not replaced either.
            OpenOptions::new().write(true).open(&path)?;
            Ok(Target::File(path))
        }
        Ok(_) => Ok(Target::Stream(path)),
        Err(error) if error.kind() != ErrorKind::NotFound => Err(error),
        Err(_) if ends_as_folder(&path) => refused("it is the name of a folder; a file is wanted"),
        Err(_) => Ok(Target::File(path)),
    }
}

/// A path such as `pictures/` or `..`, which no file can have.
fn ends_as_folder(path: &Path) -> bool {
    path.file_name().is_none() || path.as_os_str().as_encoded_bytes().ends_with(b"/")
}

/// An open file of this process, such as /dev/stdout: a link that is to be opened, not followed.
fn open_file(path: &Path) -> Option<Target> {
    let own = fs::canonicalize("/proc/self/fd").ok()?;
    if fs::canonicalize(folder_of(path)).ok()? != own {
        return None;
    }
    match path.file_name()?.to_str() {
        Some("1") => Some(Target::Standard),
        _ => Some(Target::Stream(path.to_path_buf())),
    }
}
