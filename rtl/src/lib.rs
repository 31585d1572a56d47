//! Designs and Verilog of units and machines.
//!
//! [`design`](emit::design) builds a unit, [`emit`](emit::emit) writes its Verilog. What units and machines are is in
//! `imogene-circuits`, what is stated of them in `imogene-contract`.
#![warn(missing_docs)]

pub mod emit;
/// Widths and numbers of the formats.
pub use imogene_contract::words as format;
