//! All tests of the crate that need it from outside, as one program.

mod detail;
mod fit;
mod lit_sphere;
mod primitives;
mod sweeps;
mod trade;
mod zones;
