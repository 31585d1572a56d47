//! Why there is no drawing.

use thiserror::Error;

/// A plot or a page that the library does not make.
#[derive(Debug, Error)]
#[error("{what}: {problem}")]
pub struct DrawError {
    /// What cannot be made.
    pub what: String,
    /// Why not.
    pub problem: String,
}
