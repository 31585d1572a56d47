//! Formal proofs of the emitted Verilog: properties in SystemVerilog (`verif/formal`), bound to the emitted modules and
//! proved by SymbiYosys or by Yosys and its SMT driver, and the integer steps between them, proved by z3.
//!
//! [`catalogue::jobs`] lists the proofs, [`runner::prove`] runs them, [`mutants::MUTANTS`] are edits of the design that
//! a proof must refute. The argument that the jobs add up to is `docs/proofs.md`.

pub mod bind;
pub mod catalogue;
mod driver;
mod error;
pub mod job;
pub mod mutants;
pub mod runner;
pub mod toolchain;

pub use error::FormalError;
