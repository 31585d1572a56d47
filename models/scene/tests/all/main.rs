//! All tests of the crate, as one program.

mod animation;
mod error;
mod look;
mod paraboloids;
mod quadric;
mod reference;
mod scene_errors;
mod scene_frame;
