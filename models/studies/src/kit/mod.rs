//! What all studies share: sentences, tables and pages, plots, pictures.

pub mod page;
pub mod picture;
pub mod plot;
pub mod sheet;
pub mod words;

use thiserror::Error;

/// A plot or a page that the library does not make: what, and why not.
#[derive(Debug, Error)]
#[error("{0}: {1}")]
pub struct DrawError(String, String);
