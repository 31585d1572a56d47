//! Formal proofs of the emitted Verilog: properties in SystemVerilog (`verif/formal`), bound to the emitted modules and
//! proved by SymbiYosys or by Yosys and its SMT driver, and the integer steps between them, proved by z3.
//!
//! [`catalogue::jobs`] lists the proofs, [`runner::prove`] runs them, [`mutants::MUTANTS`] are edits of the design that
//! a proof must refute. The argument that the jobs add up to is `docs/proofs.md`.

pub mod bind;
pub mod catalogue;
pub mod job;
pub mod mutants;
pub mod runner;
pub mod toolchain;

use imogene_contract::RequestError;
use imogene_tools::FileError;
use thiserror::Error;

/// A proof that did not run. A property that does not hold is not an error but a result.
#[derive(Debug, Error)]
pub enum FormalError {
    /// No job has this name; the proofs that there are.
    #[error("there is no proof `{0}`; the proofs are {1}, or `all`")]
    Unknown(String, String),
    /// The tools are not installed; the programs looked for.
    #[error(
        "the proofs need SymbiYosys and z3 (`scripts/setup --formal` installs both in target/tools), or yosys, yosys-smtbmc and z3 of the \
         system; not found: {0}"
    )]
    MissingTools(String),
    /// The design cannot be emitted.
    #[error(transparent)]
    Emit(#[from] RequestError),
    /// The emitted text is not as the property or the mutant of a job needs it: what is missing.
    #[error("{0}: {1}")]
    Text(String, String),
    /// In a job a tool ran and failed without a verdict: the last lines of what it said.
    #[error("{0}: {1} failed: {2}")]
    Tool(String, String, String),
    /// A file could not be read or written, or a program not started.
    #[error(transparent)]
    File(#[from] FileError),
}
