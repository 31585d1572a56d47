//! What is asked of a mutation score, and what it tells.

use crate::engine::design::DesignError;
use crate::subject::Subject;
use imogene_faults::CONFLICTS;
use imogene_tools::{FileError, ToolError};
use serde::Serialize;
use std::time::Instant;
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
    /// Conflicts after which the solver gives a mutant up.
    pub effort: u64,
    /// Bits of the words of which all are run in the end, for what can differ for these alone.
    pub word_bits: u32,
    /// Seconds for one attempt to prove one mutant equivalent.
    pub proof_seconds: u32,
}

impl Options {
    /// So that a stimulus reaches every state of a unit, in as many clocks of all stimuli.
    pub(super) fn reaching(&self, subject: &Subject) -> Options {
        let clocks = self.clocks.max(subject.longest);
        let stimuli = self.stimuli * self.clocks as u64 / clocks as u64;
        Options {
            clocks,
            stimuli: stimuli.max(1),
            ..*self
        }
    }
}

impl Default for Options {
    fn default() -> Options {
        Options {
            mutants: 1_000,
            seed: 1,
            stimuli: 150,
            clocks: 150,
            effort: CONFLICTS,
            word_bits: 24,
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
    /// A machine, or its mutants, cannot be run.
    #[error(transparent)]
    Design(#[from] DesignError),
    /// A unit itself, without a mutation, differs from the golden model, in a stimulus at a clock.
    #[error(
        "{0} without a mutation differs from its golden model at clock {2} of stimulus {1}; a score means nothing"
    )]
    Baseline(String, usize, usize),
    /// What Yosys wrote is not as expected.
    #[error("the mutation list of yosys cannot be read: {0}")]
    List(String),
}

/// A stimulus that found a mutant, and the clock of the difference.
pub type Kill = (usize, usize);

/// What became of a mutant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fate {
    /// An output differed from the golden model.
    Killed(Kill),
    /// Proven to behave like the unit on every input.
    Equivalent,
    /// A change of the state at power-up that is proven to be gone before the first result.
    Forgotten,
    /// None of these; the reason is what is known of it.
    Survived(String),
}

/// A mutant that is neither killed nor proven equivalent.
#[derive(Clone, Debug, Serialize)]
pub struct Survivor {
    /// What it changes.
    pub mutant: String,
    /// What is known of it.
    pub reason: String,
}

/// The score of a unit; the keys are stable.
#[derive(Clone, Debug, Default, Serialize)]
pub struct MutationReport {
    /// Unit.
    pub unit: String,
    /// Options of the command line that give this configuration.
    pub options: String,
    /// Mutants that are possible; of a netlist more than those made when they are too many.
    pub candidates: usize,
    /// Mutants made.
    pub mutants: usize,
    /// Killed.
    pub killed: usize,
    /// Proven equivalent.
    pub equivalent: usize,
    /// Changes of the state at power-up that are gone before the first result.
    pub forgotten: usize,
    /// None of these.
    pub surviving: Vec<Survivor>,
    /// Killed mutants in a hundred that are not proven equivalent.
    pub score: f64,
    /// Clocks at which the last killed mutant differed, counted over all stimuli.
    pub longest_life: usize,
    /// Seconds taken.
    pub seconds: f64,
}

impl MutationReport {
    /// Of something with a name, with the options that give it, before its first mutant.
    pub fn of(unit: &str, options: &str) -> MutationReport {
        MutationReport {
            unit: unit.to_owned(),
            options: options.to_owned(),
            ..MutationReport::default()
        }
    }

    /// Counts a mutant; `clocks` are those of a stimulus.
    pub(super) fn count(&mut self, fate: Fate, clocks: usize, mutant: impl Fn() -> String) {
        self.mutants += 1;
        match fate {
            Fate::Killed((stimulus, clock)) => {
                self.killed += 1;
                self.longest_life = self.longest_life.max(stimulus * clocks + clock + 1);
            }
            Fate::Equivalent => self.equivalent += 1,
            Fate::Forgotten => self.forgotten += 1,
            Fate::Survived(reason) => {
                let mutant = mutant();
                self.surviving.push(Survivor { mutant, reason });
            }
        }
    }

    pub(super) fn ended(self, started: Instant) -> MutationReport {
        let judged = (self.killed + self.surviving.len()).max(1);
        MutationReport {
            candidates: self.candidates.max(self.mutants),
            score: 100.0 * self.killed as f64 / judged as f64,
            seconds: started.elapsed().as_secs_f64(),
            ..self
        }
    }
}
