//! All tests of the crate that need it from outside, as one program.

mod random;
mod refusals;
mod upsets;
