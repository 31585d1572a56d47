//! All tests of the crate that need it from outside, as one program.

mod common;
mod cracks;
mod ordinary;
mod repair;
mod scenes;
mod tracer;
