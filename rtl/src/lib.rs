//! The catalogue of units and machines: their parameters and latencies, their Verilog and their simulation.
//!
//! [`catalogue`] names units, parameters and latencies, [`emit`](emit::emit) writes Verilog, [`simulator`] runs a unit or
//! a machine on plain words. What they are is in `imogene-circuits`.
#![warn(missing_docs)]

pub mod catalogue;
pub mod emit;
/// Widths and numbers of the formats.
pub use imogene_contract::words as format;
pub mod simulator;
