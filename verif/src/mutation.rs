//! Mutation score: does the stimulus of a unit notice every small change of its netlist?
//!
//! Yosys elaborates the emitted Verilog and lists mutants: one bit of one cell port inverted, stuck, or disturbed by
//! another bit. All of them go into one design that an input selects from, which is compiled once; each mutant is then
//! run on the unit's own stimulus against the golden model until the first difference, which *kills* it. A mutant that
//! nothing kills is either proven *equivalent* to the unit, so that no test could kill it, or it *survives* and shows a
//! weakness of the stimulus.

mod campaign;
mod cut;
mod equivalence;
mod facts;
mod list;
mod netlist;
mod score;
pub mod table;

pub use score::{Design, Fate, Mutant, MutationError, MutationReport, Options, Outcome};

use crate::subject::Subject;
use imogene_tools::{scratch, write};

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
    let scratch = scratch()?;
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
