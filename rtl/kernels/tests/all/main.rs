//! All tests of the crate that need it from outside, as one program.

#[macro_use]
mod support;

mod budget;
mod simulation;
