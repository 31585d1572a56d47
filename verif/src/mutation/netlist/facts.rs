//! What a unit may rely on, for judging its mutants: legal inputs, and invariants of its registers.
//!
//! Inputs come from the contract. The invariants are proven before they are used: from any state where all hold, they
//! hold after a clock. If that fails they are dropped, so that they can make a proof succeed sooner but never wrongly.
//! They hold where registers begin, at 0, but for the network that does not restore; there they hold once the pipeline
//! is filled, for it has no feedback, and nothing is stated of a result before.

use super::elaborate::NETLIST;
use imogene_tools::{ToolError, read, write, yosys};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

/// The netlist with the facts as assumptions.
pub(super) const ASSUMED: &str = "assumed.il";

/// Verilog conditions; a wire of the netlist stands in braces.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Facts {
    inputs: Vec<String>,
    registers: Vec<String>,
}

impl Facts {
    /// The facts of a unit.
    ///
    /// Root rows: `remainder <= 2 root` after each row; with a row that does not restore, the remainder is less by `2
    /// root + 1` where the last digit is 0. Second differences of a PE2 are even.
    fn of(unit: &str, wires: &BTreeMap<String, usize>) -> Facts {
        let last = |name: &str| name.rsplit('.').next().unwrap_or_default().to_owned();
        let even = |name: &String| format!("!({{{name}}} & 1)");
        let inputs = ["a2", "b2", "f2_a2", "f2_b2"].map(String::from);
        let registers = ["kept_a2", "kept_b2"].map(String::from);
        let second_differences = wires.keys().filter(|name| registers.contains(&last(name)));
        let stages = wires.keys().filter_map(|name| {
            let stage = name.strip_suffix(".kept_remainder")?;
            let root = format!("{stage}.kept_root");
            wires.contains_key(&root).then_some((stage, name, root))
        });
        let rows = stages.map(|(stage, remainder, root)| {
            if unit == "square_root_non_restoring" {
                unrestored(stage, remainder, &root)
            } else {
                format!("{{{remainder}}} <= 2 * {{{root}}}")
            }
        });
        Facts {
            inputs: wires
                .keys()
                .filter(|name| inputs.contains(name))
                .map(even)
                .collect(),
            registers: second_differences.map(even).chain(rows).collect(),
        }
    }

    /// Verilog of a module that states the facts, and its connections in the netlist.
    fn module(&self, keyword: &str, wires: &BTreeMap<String, usize>) -> (String, String) {
        let mut ports: Vec<String> = Vec::new();
        let mut body = String::new();
        let kinds = [("assume", &self.inputs), (keyword, &self.registers)];
        for (keyword, conditions) in kinds {
            for condition in conditions {
                let mut text = String::new();
                for part in condition.split('{') {
                    let Some((wire, rest)) = part.split_once('}') else {
                        text += part;
                        continue;
                    };
                    let known = ports.iter().position(|port| port == wire);
                    let place = known.unwrap_or_else(|| {
                        ports.push(wire.to_owned());
                        ports.len() - 1
                    });
                    // As wide as no sum of it can leave.
                    let _ = write!(text, "{{64'd0, p{place}}}{rest}");
                }
                let _ = writeln!(body, "  always @* {keyword}({text});");
            }
        }
        let mut header = Vec::new();
        let mut connections = String::new();
        for (place, wire) in ports.iter().enumerate() {
            header.push(format!("input [{}:0] p{place}", wires[wire] - 1));
            let _ = writeln!(connections, "    connect \\p{place} \\{wire}");
        }
        let verilog = format!("module facts({});\n{body}endmodule\n", header.join(", "));
        (verilog, connections)
    }

    /// Writes the netlist with the facts, the registers' after `keyword`.
    fn insert(
        &self,
        keyword: &str,
        folder: &Path,
        netlist: &str,
        wires: &BTreeMap<String, usize>,
    ) -> Result<(), ToolError> {
        let (verilog, connections) = self.module(keyword, wires);
        write(&folder.join("facts.v"), &verilog)?;
        let end = netlist.trim_end().strip_suffix("end").unwrap_or(netlist);
        let text = format!("{end}  cell \\facts \\facts_of_unit\n{connections}  end\nend\n");
        Ok(write(&folder.join("stated.il"), &text)?)
    }
}

/// The invariant of a row that does not restore. Row k, from 0, leaves a remainder of `k + 3` bits.
fn unrestored(stage: &str, remainder: &str, root: &str) -> String {
    let row = stage.rsplit('_').next().and_then(|row| row.parse().ok());
    let mask = (1u64 << (row.unwrap_or(0u32) + 3).min(63)) - 1;
    let restored =
        format!("({{{root}}} & 1) ? {{{remainder}}} : {{{remainder}}} + 2 * {{{root}}} + 1");
    format!("(({restored}) & 64'd{mask}) <= 2 * {{{root}}}")
}

/// Names and widths of the named wires in the text of a netlist.
pub(super) fn wires(netlist: &str) -> BTreeMap<String, usize> {
    let mut found = BTreeMap::new();
    for line in netlist.lines() {
        let mut words = line.split_whitespace();
        if words.next() != Some("wire") {
            continue;
        }
        let words: Vec<&str> = words.collect();
        let width = words.windows(2).find(|pair| pair[0] == "width");
        let width = width.and_then(|pair| pair[1].parse().ok()).unwrap_or(1);
        if let Some(name) = words.last().and_then(|name| name.strip_prefix('\\')) {
            found.insert(name.to_owned(), width);
        }
    }
    found
}

/// Writes [`ASSUMED`]: the netlist with the facts that hold.
pub(super) fn assume(folder: &Path, top: &str, unit: &str) -> Result<(), ToolError> {
    let netlist = read(&folder.join(NETLIST))?;
    let wires = wires(&netlist);
    let mut facts = Facts::of(unit, &wires);
    if facts == Facts::default() {
        return Ok(write(&folder.join(ASSUMED), &netlist)?);
    }
    let build = format!(
        "read_rtlil stated.il\nread_verilog -formal facts.v\nproc facts\nflatten {top}\ndelete facts\nselect -clear\n"
    );
    if !facts.registers.is_empty() {
        facts.insert("assert", folder, &netlist, &wires)?;
        let proof = "sat -tempinduct -tempinduct-inductonly -prove-asserts -set-assumes -maxsteps 1 -timeout 120";
        let said = yosys(folder, "facts.ys", &format!("{build}{proof} {top}\n"))?;
        if !said.contains("SUCCESS") {
            facts.registers.clear();
        }
    }
    facts.insert("assume", folder, &netlist, &wires)?;
    yosys(
        folder,
        "assume.ys",
        &format!("{build}write_rtlil {ASSUMED}\n"),
    )?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn facts_name_wires_of_the_netlist() {
        let text = "module \\m\n  wire width 4 input 2 \\a2\n  wire width 5 \\s_0.kept_remainder\n  wire width 4 \\s_0.kept_root\n  \
                    wire $1\nend\n";
        let wires = wires(text);
        assert_eq!(wires.get("a2"), Some(&4));
        assert_eq!(wires.len(), 3);
        let facts = Facts::of("square_root", &wires);
        assert_eq!(facts.inputs, ["!({a2} & 1)"]);
        assert_eq!(
            facts.registers,
            ["{s_0.kept_remainder} <= 2 * {s_0.kept_root}"]
        );
        let (verilog, connections) = facts.module("assert", &wires);
        assert!(
            verilog.contains("assert({64'd0, p1} <= 2 * {64'd0, p2});"),
            "{verilog}"
        );
        assert!(connections.contains("connect \\p2 \\s_0.kept_root"));
    }
}
