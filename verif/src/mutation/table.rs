//! The scores as a page of the documentation.

use super::score::{MutationReport, Survivor};
use imogene_files::text::wrapped;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Units whose netlists' scores are published, smallest first.
pub const NETLISTS: [&str; 9] = [
    "pe1",
    "pe2",
    "cut_plane",
    "visibility_node",
    "plane_depth",
    "quadric_cut",
    "square_root",
    "square_root_non_restoring",
    "quadric_pe",
];

/// Groups of survivors of a unit that the page shows.
const SHOWN: usize = 8;

/// Before the table of circuits.
pub const OF_CIRCUITS: &str = "\
# Mutation scores

A test suite is worth what it notices. *Every* mutant of each unit's circuit is run: each bit of each net stuck at 0,
stuck at 1 and inverted, each bit of a constant inverted, each operator exchanged for another, the enable of each
register stuck and inverted, each bit of what it holds at power-up inverted, in every instance. A mutant is *killed*
when the unit's own stimulus shows a difference from the golden model. It is *equivalent* when no test could kill it,
which is proven in one of these ways:

- outputs and next states are those of the unit for every input and every state that the unit can come to; of these
  states, bounds of registers and pairs of bits are guessed from a simulation and proven by induction; of the next
  states only those count that are read, and none is read beside a constant that hides it;
- the unit keeps nothing longer than its latency, and the outputs are the same for all inputs of that time;
- the words of an object or a volume are held over a zone, and the clocks of a zone are the same;
- the unit rests until its work begins and rests again after its latency, and does the same in between;
- registers differ only in phases of the work in which nothing that counts reads them; an output that the golden model
  states beside a flag of 1 alone, such as `valid`, counts only there;
- some bits of registers may differ, and of 10 clocks from any state in which no others do, the last one shows nothing
  and makes no others differ; the words of a zone may be held meanwhile;
- results of words of more than 16, 20 or 24 bits are the same, and all shorter words were run; with `--word-bits 32`
  all words of 32 bits are, in the end.

A mutant is *forgotten* when it changes the state at power-up and it is proven that nothing of it is left once the work
began, or that no output that counts shows it before it is gone or while a flag is down. The score is the share of the
killed among the killed and the surviving.

A mutant runs on up to 20 000 stimuli of 150 clocks; where a counter needs longer ones, on as many clocks. Proofs are
tried after 150 stimuli with half the effort, and after 3 000. The solver gives up after 10 000 conflicts, or as many as
`--effort` says, or earlier, and a mutant of which it knows nothing survives.

A score below 100 % says that the stimulus is too weak, that the unit's contract leaves an input open, or that the
proof needs to know more of the states that are never reached.
";

/// Before the table of netlists.
pub const OF_NETLISTS: &str = "\
# Mutation scores of netlists

A test suite is worth what it notices. Each unit's emitted Verilog is elaborated by Yosys, and mutants are made of the
netlist: one bit of one cell port inverted (`inv`), held (`const0`, `const1`), or inverted when another bit of the port
is 0 or 1 (`cnot0`, `cnot1`). A mutant is *killed* when the unit's own stimulus shows a difference from the golden
model, and *equivalent* when it is proven to behave like the unit on every input, so that no test could kill it. The
score is the share of the killed among the others.
";

/// The page; `command` made it.
pub fn markdown(reports: &[MutationReport], introduction: &str, command: &str) -> String {
    let mut text = format!("{introduction}\nMade by:\n\n```sh\n{command}\n```\n\n");
    text += "| unit | configuration | candidates | mutants | killed | equivalent | forgotten | surviving | score | longest life, clocks |\n";
    text += "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|\n";
    for r in reports {
        let others = [r.equivalent, r.forgotten, r.surviving.len()];
        let counts = [&[r.candidates, r.mutants, r.killed], &others[..]].concat();
        let counts: Vec<String> = counts.iter().map(usize::to_string).collect();
        let (unit, options, life) = (&r.unit, &r.options, r.longest_life);
        let row = format!("{unit} | `{options}` | {}", counts.join(" | "));
        let _ = writeln!(text, "| {row} | {:.2} % | {life} |", r.score);
    }
    text += "\n*Candidates* are the mutants that are possible; where they are more than the mutants, Yosys picks them evenly \
             over\ncells, ports and source lines. *Longest life* is how much stimulus the hardest of the killed mutants took.\n";
    text += "\n## Survivors\n\n";
    for line in groups(reports).lines() {
        text += &(wrapped(line, "  ") + "\n");
    }
    text
}

/// A mutant without the number of its bit.
fn without_bits(mutant: &str) -> String {
    let mut parts = mutant.split('[');
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| match part.split_once(']') {
        Some((bit, rest)) if bit.parse::<u32>().is_ok() => text + "[]" + rest,
        _ => text + "[" + part,
    })
}

/// Survivors of a unit and a reason in a line: those that differ in their bits alone as one, the most numerous alone.
fn groups(reports: &[MutationReport]) -> String {
    let mut text = String::new();
    for report in reports {
        let mut reasons: BTreeMap<&str, BTreeMap<String, usize>> = BTreeMap::new();
        for Survivor { mutant, reason } in &report.surviving {
            let counts = reasons.entry(reason).or_default();
            *counts.entry(without_bits(mutant)).or_default() += 1;
        }
        for (reason, counts) in reasons {
            let mut counts: Vec<(String, usize)> = counts.into_iter().collect();
            counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
            let shown = counts.iter().take(SHOWN);
            let shown = shown.map(|(mutant, count)| format!("{count} of {mutant}"));
            let mut shown: Vec<String> = shown.collect();
            let others: usize = counts.iter().skip(SHOWN).map(|(_, count)| count).sum();
            if others > 0 {
                shown.push(format!("{others} others"));
            }
            let MutationReport { unit, options, .. } = report;
            let shown = shown.join(", ");
            let _ = writeln!(text, "- {unit} `{options}`: {shown}. {reason}.");
        }
    }
    if text.is_empty() {
        text += "None.\n";
    }
    text
}

/// Survivors one by one, with the reason.
pub fn survivors(reports: &[MutationReport]) -> String {
    let mut text = String::new();
    for report in reports {
        for Survivor { mutant, reason } in &report.surviving {
            let _ = writeln!(text, "- {}: {mutant}. {reason}", report.unit);
        }
    }
    if text.is_empty() {
        text += "None.\n";
    }
    text
}
