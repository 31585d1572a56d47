//! Is the emitted text the same circuit as rust-hdl's own? A proof by Yosys, unit by unit.
//!
//! Both texts are elaborated and their registers paired by name: the emitter keeps the names of the blocks, so that
//! rust-hdl's `stages$3.kept_root` is our `stages_3.kept_root`. Paired registers must have the same width, clock edge
//! and initial value. Then they are cut: each value becomes an input, each next value and clock an output, of both
//! texts under the same name. What is left has no state, and Yosys' SAT solver shows that all outputs are equal for
//! every value of all inputs. By induction over the clocks the two circuits then give equal outputs for every sequence
//! of inputs of any length. Undefined and undriven bits are zeros on one side and ones on the other, so that none of
//! them can matter.

mod netlist;
pub mod sequential;
pub mod table;

use crate::tool::{ToolError, write};
use crate::yosys::yosys;
use imogene_rtl::emit::{EmitError, EmitRequest, emit, raw};
use netlist::{Netlist, names_of_registers};
use std::path::Path;
use thiserror::Error;

/// Seconds that the solver may take.
const SECONDS: u32 = 600;

/// Why nothing can be said.
#[derive(Debug, Error)]
pub enum EquivalenceError {
    /// A program is missing or refuses a text.
    #[error(transparent)]
    Tool(#[from] ToolError),
    /// A text cannot be made.
    #[error("{0}")]
    Emit(EmitError),
    /// A netlist is not of the form that is compared.
    #[error("the netlist of `{top}` cannot be compared: {problem}")]
    Netlist {
        /// Module.
        top: String,
        /// What is wrong with it.
        problem: String,
    },
}

/// What was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Equal outputs for every sequence of inputs.
    Equal,
    /// Something differs: a register that has no partner, or outputs and next values of registers on some input.
    Differs(String),
    /// No answer in time.
    Open,
}

/// A comparison of two texts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Comparison {
    /// Registers of the emitted text.
    pub registers: usize,
    /// Their bits.
    pub bits: usize,
    /// What was found.
    pub verdict: Verdict,
}

/// A Verilog text and its module.
#[derive(Clone, Copy, Debug)]
pub struct Text<'a> {
    /// Name of the module.
    pub top: &'a str,
    /// All modules.
    pub verilog: &'a str,
}

/// Compares the emitted text of a unit with rust-hdl's own, as rust-hdl prints it or with the ranges that
/// [`with_ranges`] adds.
///
/// # Errors
///
/// When rust-hdl cannot print the unit, or a tool is missing or refuses a text.
pub fn unit(request: &EmitRequest, ranges: bool) -> Result<Comparison, EquivalenceError> {
    let printed = raw(request).map_err(EquivalenceError::Emit)?;
    let emitted = emit(request).map_err(EquivalenceError::Emit)?;
    let printed = if ranges {
        with_ranges(&printed)
    } else {
        printed
    };
    let theirs = Text {
        top: "top",
        verilog: &printed,
    };
    let ours = Text {
        top: &emitted.top,
        verilog: &emitted.bundle(),
    };
    compare(theirs, ours)
}

/// Gives rust-hdl's signed constants the range of their value.
///
/// rust-hdl prints `localparam signed limit = 26'h3800001;`. A parameter with a sign and no range takes the range of
/// its value and is signed
///, and Icarus Verilog and Verilator read it so; Yosys takes the sign of the value, which has none.
pub fn with_ranges(raw: &str) -> String {
    let line = |line: &str| -> String {
        let ranged = line
            .split_once("localparam signed ")
            .and_then(|(indent, rest)| {
                let (name, value) = rest.split_once(" = ")?;
                let width: usize = value.split_once('\'')?.0.parse().ok()?;
                Some(format!(
                    "{indent}localparam signed [{}:0] {name} = {value}\n",
                    width - 1
                ))
            });
        ranged.unwrap_or_else(|| format!("{line}\n"))
    };
    raw.lines().map(line).collect()
}

/// Compares rust-hdl's text with a text whose names are those of the emitter.
///
/// # Errors
///
/// When Yosys is missing or refuses a text, or one has state besides registers.
pub fn compare(theirs: Text, ours: Text) -> Result<Comparison, EquivalenceError> {
    let scratch = tempfile::tempdir().map_err(ToolError::file(&std::env::temp_dir()))?;
    let folder = scratch.path();
    let mut printed = elaborate(folder, "printed", theirs, "-zero")?;
    let emitted = elaborate(folder, "emitted", ours, "-one")?;
    let count = |found| Comparison {
        registers: emitted.registers.len(),
        bits: emitted.bits(),
        verdict: found,
    };
    if let Some(difference) = printed.adopt_ports(&emitted) {
        return Ok(count(Verdict::Differs(difference)));
    }
    if let Some(difference) = printed.difference(&emitted) {
        return Ok(count(Verdict::Differs(difference)));
    }
    write(&folder.join("printed.il"), &printed.cut())?;
    write(&folder.join("emitted.il"), &emitted.cut())?;
    // Merging leaves one copy of all that both sides have; the solver sees what they compute differently.
    let script = format!(
        "read_rtlil printed.il\nrename {} printed\nread_rtlil emitted.il\nrename {} emitted\nopt_clean\n\
         miter -equiv -make_outcmp -flatten printed emitted miter\nhierarchy -top miter\nopt -full\nopt_merge -share_all\nopt_clean\n\
         sat -prove trigger 0 -show-outputs -timeout {SECONDS} miter\n",
        theirs.top, ours.top
    );
    let said = yosys(folder, "miter.ys", &script)?;
    Ok(count(verdict(&said, &emitted)))
}

fn elaborate(
    folder: &Path,
    name: &str,
    text: Text,
    undefined: &str,
) -> Result<Netlist, EquivalenceError> {
    write(&folder.join(format!("{name}.v")), text.verilog)?;
    let script = format!(
        "read_verilog {name}.v\nhierarchy -check -top {}\nproc\nflatten\nsetundef -undriven {undefined}\nwrite_rtlil {name}.il\n",
        text.top
    );
    yosys(folder, &format!("{name}.ys"), &script)?;
    let path = folder.join(format!("{name}.il"));
    let netlist = std::fs::read_to_string(&path).map_err(ToolError::file(&path))?;
    Netlist::read(text.top, netlist)
}

/// Reads the answer of the solver.
fn verdict(said: &str, emitted: &Netlist) -> Verdict {
    if said.contains("no model found: SUCCESS!") {
        return Verdict::Equal;
    }
    if !said.contains("model found: FAIL!") {
        return Verdict::Open;
    }
    let unequal = |line: &str| {
        let mut words = line.split_whitespace();
        let port = words.next()?.strip_prefix("\\cmp_")?;
        (words.next_back()? == "0").then(|| port.to_owned())
    };
    let ports: Vec<String> = said.lines().filter_map(unequal).collect();
    Verdict::Differs(names_of_registers(&ports, emitted).join(", "))
}

#[cfg(test)]
mod tests {
    use super::with_ranges;

    #[test]
    fn only_signed_constants_get_a_range() {
        let text = "    localparam signed low = 26'h3800001;\n    localparam signed two = 3'b10;\n    localparam one = 24'h1;\n    wire signed [3:0] a;\n";
        let ranged = "    localparam signed [25:0] low = 26'h3800001;\n    localparam signed [2:0] two = 3'b10;\n    localparam one = 24'h1;\n    wire signed [3:0] a;\n";
        assert_eq!(with_ranges(text), ranged);
    }
}
