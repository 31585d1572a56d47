//! All tests of the crate that need it from outside, as one program.

mod compare;
mod detail;
mod fit;
mod sweeps;
mod trade;
