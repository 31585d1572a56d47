//! Are two texts the same circuit, whatever their registers are called? A proof by ABC.
//!
//! Yosys builds a miter of both: one output that is 1 as soon as any output of one differs from that of the other.
//! Both start at their initial values. ABC finds registers that are always equal by induction (`scorr`) and then
//! proves that the output is never 1, or gives a clock at which it is.

use super::{EquivalenceError, Text, Verdict};
use crate::tool::{ToolError, YOSYS_ABC, write};
use crate::yosys::yosys;

/// Compares two texts from their initial values on.
///
/// # Errors
///
/// When a tool is missing or refuses a text.
pub fn compare_sequences(one: Text, other: Text) -> Result<Verdict, EquivalenceError> {
    let scratch = tempfile::tempdir().map_err(ToolError::file(&std::env::temp_dir()))?;
    let folder = scratch.path();
    for (name, text) in [("one", one), ("other", other)] {
        write(&folder.join(format!("{name}.v")), text.verilog)?;
        let script = format!(
            "read_verilog {name}.v\nhierarchy -check -top {top}\nproc\nflatten\nopt -full\nmemory -nomap\nmemory_map\nopt -full\n\
             rename {top} {name}\nwrite_rtlil {name}.il\n",
            top = text.top
        );
        yosys(folder, &format!("{name}.ys"), &script)?;
    }
    let script = "read_rtlil one.il\nread_rtlil other.il\nmiter -equiv -flatten one other miter\nhierarchy -top miter\n\
                  techmap\nopt -full\ndffunmap\nabc -g AND\nopt_clean\nsetundef -zero\naigmap\nwrite_aiger -zinit miter.aig\n";
    yosys(folder, "miter.ys", script)?;
    let commands = "read_aiger miter.aig; strash; scorr; strash; dprove";
    let said = YOSYS_ABC.run(["-q", commands], folder)?;
    Ok(match &said {
        equal if equal.contains("UNSATISFIABLE") || equal.contains("Networks are equivalent") => {
            Verdict::Equal
        }
        differs if differs.contains("asserted in frame") || differs.contains("SATISFIABLE") => {
            let line = differs.lines().find(|line| line.contains("frame"));
            Verdict::Differs(line.unwrap_or("an output").trim().to_owned())
        }
        _ => Verdict::Open,
    })
}
