//! Exact reference, error bounds and measures of pictures.
//!
//! The exact reference ([`exact`]) solves each pixel in big integers by another route than the machine. It is the truth
//! that golden models and hardware are measured against ([`metrics`]) and that the bounds ([`bounds`]) hold for.

pub mod bounds;
pub mod exact;
pub mod metrics;
pub mod phong;
