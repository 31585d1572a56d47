//! Formal proofs of the emitted Verilog: properties in SystemVerilog (`verif/formal`), bound to the emitted modules and proved by SymbiYosys
//! or by Yosys and its SMT driver, and the integer steps between them, proved by z3.
//!
//! [`catalogue::jobs`] lists the proofs, [`runner::prove`] runs them, [`mutants::MUTANTS`] are edits of the design that a proof must refute.
//! The argument that the jobs add up to is `docs/proofs.md`.

pub mod bind;
pub mod catalogue;
mod driver;
pub mod job;
pub mod mutants;
mod network;
pub mod runner;
pub mod toolchain;

use imogene_contract::RequestError;
use thiserror::Error;

/// A proof that did not run. A property that does not hold is not an error but a result.
#[derive(Debug, Error)]
pub enum FormalError {
    /// No job has this name.
    #[error("there is no proof `{name}`; the proofs are {}, or `all`", catalogue::names().join(", "))]
    Unknown {
        /// The name asked for.
        name: String,
    },
    /// The tools are not installed.
    #[error(
        "the proofs need SymbiYosys and z3 (`scripts/setup --formal` installs both in target/tools), or yosys, yosys-smtbmc and z3 of the \
         system; not found: {missing}"
    )]
    MissingTools {
        /// Programs looked for.
        missing: String,
    },
    /// The design cannot be emitted.
    #[error(transparent)]
    Emit(#[from] RequestError),
    /// The emitted text is not as a property or a mutant needs it.
    #[error("{job}: {problem}")]
    Text {
        /// Job or mutant.
        job: String,
        /// What is missing.
        problem: String,
    },
    /// A tool ran and failed without a verdict.
    #[error("{job}: {tool} failed: {message}")]
    Tool {
        /// Job.
        job: String,
        /// Program.
        tool: String,
        /// Last lines of what it said.
        message: String,
    },
    /// A file could not be read or written, or a program not started.
    #[error("{what}: {source}")]
    Io {
        /// File or program.
        what: String,
        /// What the system says.
        source: std::io::Error,
    },
}

impl FormalError {
    fn text(job: &str, problem: impl Into<String>) -> FormalError {
        FormalError::Text {
            job: job.to_owned(),
            problem: problem.into(),
        }
    }

    fn io(what: impl std::fmt::Display) -> impl FnOnce(std::io::Error) -> FormalError {
        let what = what.to_string();
        move |source| FormalError::Io { what, source }
    }
}
