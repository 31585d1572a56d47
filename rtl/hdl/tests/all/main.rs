//! All tests of the crate that need it from outside, as one program.

mod circuits;
mod operations;
