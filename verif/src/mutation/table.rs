//! The scores as a page of the documentation.

use super::score::{Fate, MutationReport};
use imogene_files::text::wrapped;
use std::fmt::Write as _;

/// Units whose score is published, smallest first.
pub const UNITS: [&str; 10] = [
    "pe1",
    "pe2",
    "cut_plane",
    "two_volume_merge",
    "visibility_node",
    "plane_depth",
    "depth_interval",
    "square_root",
    "square_root_non_restoring",
    "quadric_pe",
];

const INTRODUCTION: &str = "\
# Mutation scores

A test suite is worth what it notices. Each unit's emitted Verilog is elaborated by Yosys, and mutants are made of the
netlist: one bit of one cell port inverted (`inv`), held (`const0`, `const1`), or inverted when another bit of the port
is 0 or 1 (`cnot0`, `cnot1`). A mutant is *killed* when the unit's own stimulus shows a difference from the golden
model, and *equivalent* when it is proven to behave like the unit on every input, so that no test could kill it. The
score is the share of the killed among the others.
";

/// The page; `command` made it.
pub fn markdown(reports: &[MutationReport], command: &str) -> String {
    let mut text = format!("{INTRODUCTION}\nMade by `{command}`.\n\n");
    text += "| unit | configuration | candidates | mutants | killed | equivalent | surviving | score | longest life, clocks |\n";
    text += "|---|---|---:|---:|---:|---:|---:|---:|---:|\n";
    for r in reports {
        let _ = writeln!(
            text,
            "| {} | `{}` | {} | {} | {} | {} | {} | {:.2} % | {} |",
            r.unit,
            r.options,
            r.candidates,
            r.mutants,
            r.killed,
            r.equivalent,
            r.surviving.len(),
            r.score,
            r.longest_life
        );
    }
    text += "\n*Candidates* are the mutants that Yosys finds possible; where they are more than the mutants, it picks them \
             evenly over\ncells, ports and source lines. *Longest life* is how much stimulus the hardest of the killed \
             mutants took.\n";
    text += "\n## Survivors\n\n";
    for line in survivors(reports).lines() {
        text += &(wrapped(line, "  ") + "\n");
    }
    text
}

/// Survivors one by one, with the reason.
pub fn survivors(reports: &[MutationReport]) -> String {
    let mut text = String::new();
    for report in reports {
        for outcome in &report.surviving {
            if let Fate::Survived { reason } = &outcome.fate {
                let _ = writeln!(text, "- {}: {}. {reason}", report.unit, outcome.mutant);
            }
        }
    }
    if text.is_empty() {
        text += "None.\n";
    }
    text
}
