//! Mutation score: does the stimulus of a unit notice every small change of it?
//!
//! A mutant is run on the unit's own stimulus against the golden model until the first difference, which *kills* it. A
//! mutant that nothing kills is either proven *equivalent* to the unit, so that no test could kill it, or it *survives*
//! and shows a weakness of the stimulus. [`circuit`] makes every mutant of the circuit and needs no tool; [`netlist`]
//! makes those that Yosys knows of the emitted Verilog.

pub mod circuit;
pub mod contract;
pub mod machine;
pub mod netlist;
mod score;
pub mod table;
mod vectors;

pub use score::{Fate, Kill, MutationError, MutationReport, Options, Survivor};
