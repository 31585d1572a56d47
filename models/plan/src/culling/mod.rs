//! Only what a scene requires: which objects, planes, volumes and bits matter, on the screen and in each zone of it
//! (`docs/detail.md`).
//!
//! [`part`] and [`volume`] decide by bounds, which a host can afford for each zone; what they leave out is certain to
//! change no pixel. [`reduce`] visits every pixel of an object and leaves out exactly what changes none of them, or,
//! asked for less, at most so many. [`precision`] counts the bits that an object needs.

pub mod blocks;
pub mod part;
pub mod precision;
pub mod reduce;
mod surface;
pub mod volume;
pub mod zones;

pub use surface::{Planes, all_planes};
