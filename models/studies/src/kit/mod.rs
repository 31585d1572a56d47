//! What all studies share: sentences, tables and pages, plots, pictures.

pub mod page;
pub mod picture;
pub mod plot;
pub mod sheet;
pub mod words;

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
