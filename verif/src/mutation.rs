//! Mutation score: does the stimulus of a unit notice every small change of its netlist?
//!
//! Yosys elaborates the emitted Verilog and lists mutants: one bit of one cell port inverted, stuck, or disturbed by another bit. All of
//! them go into one design that an input selects from, which is compiled once; each mutant is then run on the unit's own stimulus against
//! the golden model until the first difference, which *kills* it. A mutant that nothing kills is either proven *equivalent* to the unit, so
//! that no test could kill it, or it *survives* and shows a weakness of the stimulus.

mod campaign;
mod equivalence;
mod facts;
mod list;
mod netlist;
pub mod table;

pub use list::Mutant;

use crate::engine::design::DesignError;
use crate::signal::Signal;
use crate::subject::Subject;
use crate::tool::{ToolError, write};
use serde::Serialize;
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
            proof_seconds: 30,
        }
    }
}

/// Why there is no score.
#[derive(Debug, Error)]
pub enum MutationError {
    /// A program is missing or refused its input.
    #[error(transparent)]
    Tool(#[from] ToolError),
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

/// Makes mutants of a unit's emitted Verilog, kills them, and proves the rest equivalent where that is so.
///
/// `on_done` is called once for each mutant, from any thread.
///
/// # Errors
///
/// When a tool is missing or refuses the unit, or the unit without mutation already differs from its golden model.
pub fn run(
    subject: &Subject,
    design: &Design,
    options: &Options,
    on_done: impl Fn() + Sync,
) -> Result<MutationReport, MutationError> {
    let started = std::time::Instant::now();
    let scratch = tempfile::tempdir().map_err(ToolError::file(&std::env::temp_dir()))?;
    let folder = scratch.path();
    write(&folder.join(netlist::SOURCE), design.text)?;
    let (mutants, candidates) = netlist::elaborate(folder, design, options)?;
    let fates = campaign::run(subject, design.top, folder, &mutants, options)?;
    let judge = equivalence::Judge::new(folder, design, subject, options)?;
    let outcomes = judge.judge(mutants, fates, &on_done)?;
    let killed = outcomes.iter().filter_map(|o| match o.fate {
        Fate::Killed { stimulus, clock } => Some(stimulus * options.clocks + clock + 1),
        _ => None,
    });
    let longest_life = killed.clone().max().unwrap_or(0);
    let killed = killed.count();
    let is_equivalent = |o: &&Outcome| matches!(o.fate, Fate::Equivalent { .. });
    let equivalent = outcomes.iter().filter(is_equivalent).count();
    let mutants = outcomes.len();
    let surviving = outcomes
        .into_iter()
        .filter(|o| matches!(o.fate, Fate::Survived { .. }))
        .collect();
    Ok(MutationReport {
        unit: subject.name.clone(),
        options: subject.options.clone(),
        candidates,
        mutants,
        killed,
        equivalent,
        surviving,
        score: 100.0 * killed as f64 / (mutants - equivalent).max(1) as f64,
        longest_life,
        seconds: started.elapsed().as_secs_f64(),
    })
}

/// The input that selects a mutant; 0 selects none.
fn selector(mutants: usize) -> Signal {
    Signal::unsigned("mutant_select", (mutants as u64).ilog2() + 1)
}
