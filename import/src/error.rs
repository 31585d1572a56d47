//! Why a file was not read.

use std::fmt;
use thiserror::Error;

/// Where in a text file, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Line.
    pub line: usize,
    /// Column, in characters.
    pub column: usize,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.line, self.column)
    }
}

/// Why a file was not read.
#[derive(Debug, Error)]
pub enum ImportError {
    /// The text is not what its format asks for.
    #[error("{file}:{place}: {problem}; {accepted}")]
    Malformed {
        /// Name of the file.
        file: String,
        /// Where.
        place: Place,
        /// What is wrong.
        problem: String,
        /// What would be accepted.
        accepted: String,
    },
    /// The file as a whole cannot be used.
    #[error("{file}: {problem}; {accepted}")]
    Unusable {
        /// Name of the file.
        file: String,
        /// What is wrong.
        problem: String,
        /// What would be accepted.
        accepted: String,
    },
}

impl ImportError {
    /// What is wrong and where, without the name of the file: for a part of it that is left out.
    pub fn detail(&self) -> String {
        match self {
            Self::Malformed {
                place,
                problem,
                accepted,
                ..
            } => format!("{place}: {problem}; {accepted}"),
            Self::Unusable {
                problem, accepted, ..
            } => format!("{problem}; {accepted}"),
        }
    }
}
