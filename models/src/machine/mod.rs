//! Golden models of what stands between the object processors and the picture.

pub mod beam;
pub mod decider;
pub mod fitted;
pub mod frame;
pub mod lighting;
pub mod raster;
pub mod shading;
