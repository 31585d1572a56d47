//! All tests of the crate, as one program.

mod matrix;
mod rational;
mod vector;
