//! Mutants of a unit's netlist.
//!
//! Yosys elaborates the emitted Verilog and lists mutants: one bit of one cell port inverted, stuck, or disturbed by
//! another bit. All of them go into one design that an input selects from, which is compiled once; each mutant is then
//! run on the unit's own stimulus against the golden model until the first difference. What nothing kills Yosys may
//! prove equivalent.

mod campaign;
pub mod cut;
pub mod elaborate;
mod equivalence;
pub mod facts;
pub mod mutant;

use super::score::{MutationError, MutationReport, Options};
use crate::subject::Subject;
use imogene_tools::{scratch, write};
use std::time::Instant;

/// Makes mutants of a unit's emitted Verilog, the name of its module and the text, kills them, and proves the rest
/// equivalent where that is so.
///
/// `on_done` is called once for each mutant, from any thread.
pub fn run(
    subject: &Subject,
    (top, text): (&str, &str),
    options: &Options,
    on_done: impl Fn() + Sync,
) -> Result<MutationReport, MutationError> {
    let started = Instant::now();
    let scratch = scratch()?;
    let folder = scratch.path();
    write(&folder.join(elaborate::SOURCE), text)?;
    let (mutants, candidates) = elaborate::elaborate(folder, top, text, options)?;
    let kills = campaign::run(subject, top, folder, &mutants, options)?;
    let judge = equivalence::Judge::new(folder, top, subject, options)?;
    let fates = judge.judge(&mutants, kills, &on_done)?;
    let mut report = MutationReport::new(subject);
    for (mutant, fate) in mutants.iter().zip(fates) {
        report.count(fate, options.clocks, || mutant.text.clone());
    }
    report.candidates = candidates;
    Ok(report.ended(started))
}
