//! Studies: what a machine costs, how fast it is and how far its pictures are from the truth.

pub mod detail;
pub mod evaluate;
pub mod fit;
pub mod growth_plot;
pub mod kit;
pub mod primitives;
pub mod root_errors;
pub mod shading_trial;
pub mod sweep;
pub mod trade;
pub mod trial;

pub use kit::{picture, preview};
