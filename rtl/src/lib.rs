//! Designs and Verilog of units and machines.
//!
//! [`design`](emit::design) builds a unit, [`emit`](emit::emit) writes its Verilog. What units and machines are is in
//! `imogene-circuits`, what is stated of them in `imogene-contract`.

pub mod emit;
