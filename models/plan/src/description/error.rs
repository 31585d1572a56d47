//! Why a description is refused.

use imogene_golden::format::FittedError;
use thiserror::Error;

/// Why a description is refused.
#[derive(Debug, Error)]
pub enum DescriptionError {
    /// The file cannot be read, and the system's reason.
    #[error(
        "{0}: the machine description cannot be read ({1}); give the path of a readable TOML file"
    )]
    Unreadable(String, #[source] std::io::Error),
    /// Not a description.
    #[error("{file}:{line}:{column}: {problem}")]
    Syntax {
        /// Path as given.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What the parser says.
        problem: String,
    },
    /// A width out of its range.
    #[error("{place}: {key}: {problem}")]
    Widths {
        /// Path as given, with line and column of the value if that stands in it.
        place: String,
        /// Key.
        key: &'static str,
        /// Which, and what would be accepted.
        problem: FittedError,
    },
    /// A value out of its range.
    #[error("{place}: {key} is {value}; accepted: {accepted}")]
    Value {
        /// Path as given, with line and column of the value if that stands in it.
        place: String,
        /// Key.
        key: &'static str,
        /// Value.
        value: String,
        /// What would be accepted.
        accepted: String,
    },
}
