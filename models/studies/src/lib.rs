//! Studies: what a machine costs, how fast it is and how far its pictures are from the truth.

pub mod compare;
pub mod detail;
pub mod evaluate;
pub mod fit;
pub mod growth_plot;
pub mod picture;
pub mod preview;
pub mod root_errors;
pub mod shading_trial;
pub mod sweep;
pub mod text;
pub mod trade;
pub mod trial;
