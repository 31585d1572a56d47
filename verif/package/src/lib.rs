//! Units as IP cores: the contract of each, and a folder with Verilog, contract, self-checking bench and FuseSoC core
//! file.
//!
//! [`contract`] is the one source of what a unit promises; Markdown and JSON are two forms of it. [`core`] makes the
//! files of a package; [`census`] counts what a unit is made of; [`processors`] puts the object processors beside their
//! sources.

pub mod census;
pub mod contract;
pub mod core;
pub mod processors;
