//! Why a machine cannot be emitted.

use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why a machine cannot be emitted.
#[derive(Debug, Error)]
pub enum GeneratorError {
    /// The sources of the hardware are not where they were.
    #[error(
        "fitted hardware is compiled from the sources of imogene, which are no longer in {}; \
         run imogene in its checkout", .0.display()
    )]
    Sources(PathBuf),
    /// No compiler.
    #[error(
        "fitted hardware is compiled by cargo, which cannot be started ({0}); install Rust, or set CARGO to the program"
    )]
    Cargo(std::io::Error),
    /// The program does not compile.
    #[error("the fitted hardware does not compile:\n{0}")]
    Compile(String),
    /// The compiled program failed.
    #[error("the program that emits fitted hardware failed: {0}")]
    Program(String),
    /// Not as many answers as requests.
    #[error("the program that emits fitted hardware gave no answer")]
    Answer,
    /// A count or a prefix is refused.
    #[error("{0}")]
    Refused(String),
    /// A file cannot be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// File or folder.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
}

impl GeneratorError {
    pub(crate) fn file(path: &Path) -> impl FnOnce(std::io::Error) -> GeneratorError {
        let path = path.to_path_buf();
        move |source| GeneratorError::File { path, source }
    }
}
