//! What all studies share: sentences, tables and pages, plots, pictures.

mod error;
pub mod page;
pub mod picture;
pub mod plot;
pub mod preview;
pub mod words;

pub use error::DrawError;
