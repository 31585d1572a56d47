//! All tests of the crate, as one program.

mod common;
mod crack;
mod cracks;
mod interval;
mod ordinary;
mod repair;
mod root;
mod scenes;
mod tracer;
mod transform;
