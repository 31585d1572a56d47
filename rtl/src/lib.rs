//! The catalogue of units and machines: their parameters and latencies, their designs and their Verilog.
//!
//! [`catalogue`] names units, parameters and latencies, [`design`](emit::design) builds a unit, [`emit`](emit::emit)
//! writes its Verilog. What units and machines are is in `imogene-circuits`.
#![warn(missing_docs)]

pub mod catalogue;
pub mod emit;
/// Widths and numbers of the formats.
pub use imogene_contract::words as format;
