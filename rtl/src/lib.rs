//! Hardware that draws quadrics: the units in rust-hdl, their simulation and their Verilog.
//!
//! One unit, one file. [`unit`](mod@unit) holds what processors are built from, [`object`] the object processors, [`machine`] the raster
//! control, the decider and the beam machine. [`emit`](emit::emit) writes Verilog, [`catalogue`] names units, parameters and
//! latencies, [`simulator`] runs a processor or a machine of any format of the catalogue behind one interface.
#![warn(missing_docs)]

pub mod catalogue;
pub mod emit;
/// Widths and numbers of the formats.
pub use imogene_contract::words as format;
mod kernel;
pub mod machine;
pub mod object;
pub mod simulator;
pub mod step;
mod tree;
pub mod unit;
pub mod word;
