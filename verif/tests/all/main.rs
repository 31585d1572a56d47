//! All tests of the crate that need it from outside, as one program.

mod deciders;
mod engines;
mod equivalence;
mod exhaustive;
mod extremes;
mod faults;
mod fitted;
mod icarus;
mod kernels;
mod machines;
mod mutation;
mod patches;
mod proofs;
mod roots;
mod shading_processor;
mod tile;
mod units;
mod verilator;
mod video;
mod waveforms;
mod zone_core;
