//! Sets of files that appear together or not at all.

use crate::litter::{litter, remove_empty};
use crate::target::{Identity, Target, folder_of};
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::os::unix::fs::{MetadataExt, fchown};
use std::path::{Path, PathBuf};
use tempfile::TempPath;
use thiserror::Error;

/// A file that could not be written.
#[derive(Debug, Error)]
#[error("cannot write '{}': {source}", path.display())]
pub struct WriteError {
    /// Destination.
    pub path: PathBuf,
    /// Why.
    pub source: io::Error,
}

impl WriteError {
    /// From the system's error at a path.
    pub fn at(path: &Path) -> impl Fn(io::Error) -> WriteError {
        move |source| WriteError {
            path: path.to_path_buf(),
            source,
        }
    }
}

/// Files that appear together when [`Outputs::finish`] is called. If that never happens, nothing of them is left.
#[derive(Debug, Default)]
pub struct Outputs {
    inputs: Vec<Identity>,
    staged: Vec<Staged>,
    /// Folders made for them.
    folders: Vec<PathBuf>,
}

/// A file that waits for its name.
#[derive(Debug)]
struct Staged {
    path: PathBuf,
    target: Target,
    identity: Option<Identity>,
    file: TempPath,
}

impl Outputs {
    /// An empty set.
    pub fn new() -> Outputs {
        Outputs::default()
    }

    /// An empty set that refuses to replace these files, because they are read.
    pub fn sparing(inputs: Vec<Identity>) -> Outputs {
        let mut set = Outputs::new();
        set.inputs = inputs;
        set
    }

    /// Adds a file; missing folders are made. Fails when it cannot be written, is an input, or is in the set already.
    pub fn add(
        &mut self,
        path: &Path,
        fill: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), WriteError> {
        let mut out = BufWriter::new(self.open(path)?);
        let filled = fill(&mut out).and_then(|()| out.flush());
        filled.map_err(|error| {
            self.staged.pop();
            WriteError::at(path)(error)
        })
    }

    /// Adds a text. Fails as [`Outputs::add`] does.
    pub fn add_text(&mut self, path: &Path, text: &str) -> Result<(), WriteError> {
        self.add(path, |out| out.write_all(text.as_bytes()))
    }

    /// Adds a file that the caller fills before the set is finished. Fails as [`Outputs::add`] does.
    pub fn open(&mut self, path: &Path) -> Result<File, WriteError> {
        self.stage(path).map_err(WriteError::at(path))
    }

    fn stage(&mut self, path: &Path) -> io::Result<File> {
        let target = Target::of(path)?;
        let identity = target.identity()?;
        self.refuse_collision(identity.as_ref())?;
        let folder = match &target {
            Target::File(real) => folder_of(real).to_path_buf(),
            Target::Standard | Target::Stream(_) => tempfile::env::temp_dir(),
        };
        let mut litter = litter();
        self.folders.extend(litter.new_folders(&folder)?);
        let (file, temporary) = litter.new_file(&folder)?;
        if let Target::File(real) = &target {
            keep_mode(real, &file)?;
        }
        let returned = file.try_clone()?;
        self.staged.push(Staged {
            path: path.to_path_buf(),
            identity,
            target,
            file: temporary,
        });
        Ok(returned)
    }

    fn refuse_collision(&self, identity: Option<&Identity>) -> io::Result<()> {
        let Some(identity) = identity else {
            return Ok(());
        };
        if self.inputs.contains(identity) {
            return Err(io::Error::other(
                "it is read by the same command; give another name",
            ));
        }
        let mut staged = self.staged.iter();
        let same = staged.find(|other| other.identity.as_ref() == Some(identity));
        same.map_or(Ok(()), |other| {
            Err(io::Error::other(format!(
                "'{}' of the same command is the same file; give another name",
                other.path.display()
            )))
        })
    }

    /// The paths of the set so far, in the order in which they were added.
    pub fn paths(&self) -> Vec<PathBuf> {
        self.staged.iter().map(|one| one.path.clone()).collect()
    }

    /// Lets all files appear and returns their paths. Fails when one cannot be written. Devices and pipes are written
    /// to first, for they can refuse; then no file appears.
    pub fn finish(mut self) -> Result<Vec<PathBuf>, WriteError> {
        let paths = self.paths();
        for one in &self.staged {
            one.write_through().map_err(WriteError::at(&one.path))?;
        }
        // From here on an interruption waits until the set is complete.
        let mut litter = litter();
        for one in std::mem::take(&mut self.staged) {
            litter.forget_file(&one.file);
            if let Target::File(real) = &one.target {
                let named = one.file.persist(real);
                named.map_err(|error| WriteError::at(&one.path)(error.error))?;
            }
        }
        litter.forget_folders(&std::mem::take(&mut self.folders));
        Ok(paths)
    }
}

impl Drop for Outputs {
    fn drop(&mut self) {
        let mut litter = litter();
        for one in self.staged.drain(..) {
            litter.forget_file(&one.file);
        }
        litter.forget_folders(&self.folders);
        remove_empty(&self.folders);
    }
}

impl Staged {
    fn write_through(&self) -> io::Result<()> {
        let mut stream: Box<dyn Write> = match &self.target {
            Target::File(_) => return Ok(()),
            Target::Standard => Box::new(io::stdout().lock()),
            Target::Stream(path) => Box::new(OpenOptions::new().append(true).open(path)?),
        };
        io::copy(&mut File::open(&self.file)?, &mut stream)?;
        stream.flush()
    }
}

/// Mode and owner of the file that is replaced.
fn keep_mode(real: &Path, file: &File) -> io::Result<()> {
    let Ok(old) = fs::metadata(real) else {
        return Ok(());
    };
    let new = file.metadata()?;
    if (old.uid(), old.gid()) != (new.uid(), new.gid()) {
        // Only the administrator may give files away; for others the file becomes their own.
        let _ = fchown(file, Some(old.uid()), Some(old.gid()));
    }
    file.set_permissions(old.permissions())
}

/// Writes one file whole or not at all; missing folders are made. Fails when it cannot be written.
pub fn write_whole(
    path: &Path,
    fill: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), WriteError> {
    let mut set = Outputs::new();
    set.add(path, fill)?;
    set.finish().map(|_| ())
}
