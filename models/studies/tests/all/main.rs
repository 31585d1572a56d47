//! All tests of the crate, as one program.

mod detail;
mod evaluate;
mod fit;
mod kit;
mod lit_sphere;
mod primitives;
mod root_errors;
mod shading_trial;
mod sweep;
mod sweeps;
mod trade;
mod trial;
mod zones;
