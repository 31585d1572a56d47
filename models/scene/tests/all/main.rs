//! All tests of the crate that need it from outside, as one program.

mod look;
mod reference;
mod scene_errors;
mod scene_frame;
