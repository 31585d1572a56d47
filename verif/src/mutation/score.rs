//! What is asked of a mutation score, and what it tells.

use crate::engine::design::DesignError;
use crate::signal::Signal;
use imogene_tools::{FileError, ToolError};
use serde::Serialize;
use std::fmt;
use thiserror::Error;

/// What is done.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Mutants at most; Yosys spreads them evenly over cells, ports and source lines.
    pub mutants: usize,
    /// Seed of the choice of mutants.
    pub seed: u64,
    /// Stimuli that a mutant is run on.
    pub stimuli: u64,
    /// Clocks of each.
    pub clocks: usize,
    /// Seconds for one attempt to prove one mutant equivalent.
    pub proof_seconds: u32,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            mutants: 1_000,
            seed: 1,
            stimuli: 150,
            clocks: 150,
            proof_seconds: 120,
        }
    }
}

/// Why there is no score.
#[derive(Debug, Error)]
pub enum MutationError {
    /// A program is missing or refused its input.
    #[error(transparent)]
    Tool(#[from] ToolError),
    /// A file could not be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// The mutants cannot be compiled or loaded.
    #[error(transparent)]
    Verilator(#[from] DesignError),
    /// The unit itself, without a mutation, differs from the golden model.
    #[error(
        "{unit} without a mutation differs from its golden model at clock {clock} of stimulus {stimulus}; a score means nothing"
    )]
    Baseline {
        /// Unit.
        unit: String,
        /// Stimulus.
        stimulus: usize,
        /// Clock.
        clock: usize,
    },
    /// What Yosys wrote is not as expected.
    #[error("the mutation list of yosys cannot be read: {0}")]
    List(String),
}

/// What became of a mutant.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case", tag = "fate")]
pub enum Fate {
    /// An output differed from the golden model.
    Killed {
        /// Stimulus that found it.
        stimulus: usize,
        /// Clock of the difference.
        clock: usize,
    },
    /// Proven to behave like the unit on every input.
    Equivalent {
        /// The proof.
        proof: &'static str,
    },
    /// Neither.
    Survived {
        /// What is known of it.
        reason: String,
    },
}

/// A mutant and what became of it.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// The mutant.
    #[serde(flatten)]
    pub mutant: Mutant,
    /// What became of it.
    #[serde(flatten)]
    pub fate: Fate,
}

/// The score of a unit; the keys are stable.
#[derive(Clone, Debug, Serialize)]
pub struct MutationReport {
    /// Unit.
    pub unit: String,
    /// Options of the command line that give this configuration.
    pub options: String,
    /// Mutants that Yosys found possible; more than those made when they were too many.
    pub candidates: usize,
    /// Mutants made.
    pub mutants: usize,
    /// Killed.
    pub killed: usize,
    /// Proven equivalent.
    pub equivalent: usize,
    /// Neither killed nor proven equivalent.
    pub surviving: Vec<Outcome>,
    /// Killed mutants in a hundred that are not proven equivalent.
    pub score: f64,
    /// Clocks at which the last killed mutant differed, counted over all stimuli.
    pub longest_life: usize,
    /// Seconds taken.
    pub seconds: f64,
}

/// A unit's emitted Verilog.
#[derive(Clone, Copy, Debug)]
pub struct Design<'a> {
    /// Name of the module.
    pub top: &'a str,
    /// Text.
    pub text: &'a str,
    /// Clocks from an input to its result.
    pub latency: usize,
}

/// The input that selects a mutant; 0 selects none.
pub(super) fn selector(mutants: usize) -> Signal {
    Signal::unsigned("mutant_select", (mutants as u64).ilog2() + 1)
}

/// One small change of a netlist.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Mutant {
    /// Number, from 1.
    pub number: usize,
    /// `inv` inverts a bit, `const0` and `const1` hold it, `cnot0` and `cnot1` invert it when another bit of the same
    /// port is 0 or 1.
    pub mode: String,
    /// Cell of the netlist.
    pub cell: String,
    /// Port of the cell.
    pub port: String,
    /// Bit of the port.
    pub bit: u32,
    /// The other bit of `cnot0` and `cnot1`.
    pub control_bit: Option<u32>,
    /// Signal on the bit, if it has a name.
    pub signal: Option<String>,
    /// Line of the Verilog that the cell comes from, if it is known.
    pub line: Option<usize>,
    /// That line's text.
    pub source: String,
    /// Options of Yosys that make it, without module and control.
    #[serde(skip)]
    pub(super) command: String,
}

impl fmt::Display for Mutant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {}[{}]", self.mode, self.port, self.bit)?;
        if let Some(bit) = self.control_bit {
            write!(f, " by [{bit}]")?;
        }
        if let Some(signal) = &self.signal {
            write!(f, " ({signal})")?;
        }
        write!(f, " at {}", self.cell)?;
        match self.line {
            Some(line) => write!(f, ", line {line}: {}", self.source),
            None => Ok(()),
        }
    }
}
