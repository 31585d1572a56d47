//! Are two texts the same circuit, whatever their registers are called? A proof by Yosys and ABC.
//!
//! Yosys builds a miter of both: one output that is 1 as soon as any output of one differs from that of the other. Both
//! start at their initial values. ABC finds registers that are always equal by induction (`scorr`) and then proves that
//! the output is never 1, or gives a clock at which it is. So the two circuits give equal outputs for every sequence of
//! inputs of any length.

use imogene_hdl::Module;
use imogene_tools::{ToolError, YOSYS_ABC, scratch, write, yosys};

/// What was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Equal outputs for every sequence of inputs.
    Equal,
    /// The outputs differ; where ABC says so, from which clock on.
    Differs(String),
    /// No answer.
    Open,
}

/// A Verilog text and its module.
#[derive(Clone, Copy, Debug)]
pub struct Text<'a> {
    /// Name of the module.
    pub top: &'a str,
    /// All modules.
    pub verilog: &'a str,
}

/// Compares two texts from their initial values on.
pub fn compare(one: Text, other: Text) -> Result<Verdict, ToolError> {
    let scratch = scratch()?;
    let folder = scratch.path();
    for (name, text) in [("one", one), ("other", other)] {
        // Memories begin with the zeros that simulators read; without them Yosys leaves each text its own.
        let kept = "`ifndef LEFT_OUT";
        let verilog = text.verilog.replace("`ifndef SYNTHESIS", kept);
        write(&folder.join(format!("{name}.v")), &verilog)?;
        let script = format!(
            "read_verilog {name}.v\nhierarchy -check -top {top}\nproc\nflatten\nopt -full\nmemory -nomap\nmemory_map\n\
             opt -full\nrename {top} {name}\nwrite_rtlil {name}.il\n",
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

/// Bits of all block memories in a module. Each is a register to a proof.
pub fn memory_bits(module: &Module) -> u32 {
    let own = module.memories.iter();
    let own = own.map(|memory| memory.words as u32 * memory.width);
    let inner = module.instances.iter();
    let inner = inner.map(|instance| memory_bits(&instance.module));
    own.chain(inner).sum()
}
