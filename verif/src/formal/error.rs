//! Why a proof did not run.

use imogene_contract::RequestError;
use imogene_tools::FileError;
use thiserror::Error;

/// A proof that did not run. A property that does not hold is not an error but a result.
#[derive(Debug, Error)]
pub enum FormalError {
    /// No job has this name.
    #[error("there is no proof `{name}`; the proofs are {names}, or `all`")]
    Unknown {
        /// The name asked for.
        name: String,
        /// The proofs that there are.
        names: String,
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
    #[error(transparent)]
    File(#[from] FileError),
}

impl FormalError {
    pub(super) fn text(job: &str, problem: impl Into<String>) -> FormalError {
        FormalError::Text {
            job: job.to_owned(),
            problem: problem.into(),
        }
    }
}
