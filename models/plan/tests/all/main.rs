//! All tests of the crate that need it from outside, as one program.

mod split;
mod zone_machine;
