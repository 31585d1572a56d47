//! What a unit may rely on, for judging its mutants: legal inputs, and invariants of its registers.
//!
//! Inputs come from the contract. The invariants are proven before they are used: from any state where all hold, they
//! hold after a clock. If that fails they are dropped, so that they can make a proof succeed sooner but never wrongly,
//! and what then survives says so. They hold where registers begin, at 0, but for the network that does not restore.
//! There one state in which all hold is enough: it keeps nothing, so that its results are the same from any state, and
//! nothing is stated of a result before.

use super::mutant::NETLIST;
use imogene_tools::{ToolError, read, write, yosys};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

/// The netlist with the facts as assumptions.
pub const ASSUMED: &str = "assumed.il";

/// Verilog conditions; a wire of the netlist stands in braces.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Facts {
    /// Of inputs: the contract.
    pub inputs: Vec<String>,
    /// Of registers: what has to be proven.
    pub registers: Vec<String>,
}

impl Facts {
    /// The facts of a unit, whose netlist has wires of these widths.
    ///
    /// Root rows: `remainder <= 2 root` behind each row, where a row that does not restore would have restored. Second
    /// differences of a PE2 are even.
    pub fn of(unit: &str, wires: &BTreeMap<String, usize>) -> Facts {
        let even = |name: &String| format!("!({{{name}}} & 1)");
        let inputs = ["a2", "b2", "f2_a2", "f2_b2"].map(String::from);
        let rows = stages(wires).map(|stage| {
            let remainder = format!("{{{stage}.next_remainder}}");
            let root = format!("{{{stage}.next_root}}");
            match unit {
                "square_root_non_restoring" => unrestored(&remainder, &root, &live(stage, wires)),
                _ => format!("{remainder} <= 2 * {root}"),
            }
        });
        let even_inputs = wires.keys().filter(|name| inputs.contains(name)).map(even);
        Facts {
            inputs: even_inputs.collect(),
            registers: rows.collect(),
        }
    }

    /// Verilog of a module that states the facts, the registers' after `keyword`, and its connections in the netlist.
    pub fn module(&self, keyword: &str, wires: &BTreeMap<String, usize>) -> (String, String) {
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

/// The stages of a root: instances with rows inside, whose registers hold root and remainder.
fn stages(wires: &BTreeMap<String, usize>) -> impl Iterator<Item = &str> {
    let stages = wires.keys();
    let stages = stages.filter_map(|name| name.strip_suffix(".next_remainder"));
    stages.filter(|stage| within(wires, &format!("{stage}.rows")).next().is_some())
}

/// The wires whose names begin so.
fn within<'a>(
    wires: &'a BTreeMap<String, usize>,
    begin: &str,
) -> impl Iterator<Item = &'a String> + use<'a> {
    let begin = begin.to_owned();
    let wires = wires.range(begin.clone()..);
    wires
        .map(|(name, _)| name)
        .take_while(move |name| name.starts_with(&begin))
}

/// The bits that the remainder of a stage can have: those of its last row, which has those of the others too.
pub fn live(stage: &str, wires: &BTreeMap<String, usize>) -> String {
    let rows = within(wires, &format!("{stage}.rows"));
    let rows = rows.filter(|name| name.ends_with(".next_live"));
    let rows: Vec<String> = rows.map(|name| format!("{{{name}}}")).collect();
    rows.join(" | ")
}

/// The invariant of a row that does not restore: where the last digit is 0, the remainder is less than that of a row
/// that restores by `2 root + 1`, in two's complement of its live bits.
fn unrestored(remainder: &str, root: &str, live: &str) -> String {
    let restored = format!("({root} & 1) ? {remainder} : {remainder} + 2 * {root} + 1");
    format!("(({restored}) & ({live})) <= 2 * {root}")
}

/// Names and widths of the named wires in the text of a netlist.
pub fn wires(netlist: &str) -> BTreeMap<String, usize> {
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

/// What became of the facts of the registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Proof {
    /// So many are proven, which may be none.
    Proven(usize),
    /// They do not hold, or there was no proof in time.
    Failed,
}

/// Writes [`ASSUMED`]: the netlist in the folder with the facts that hold.
pub fn assume(folder: &Path, top: &str, unit: &str) -> Result<Proof, ToolError> {
    let netlist = read(&folder.join(NETLIST))?;
    let wires = wires(&netlist);
    let mut facts = Facts::of(unit, &wires);
    if facts == Facts::default() {
        write(&folder.join(ASSUMED), &netlist)?;
        return Ok(Proof::Proven(0));
    }
    let build = format!(
        "read_rtlil stated.il\nread_verilog -formal facts.v\nproc facts\nflatten {top}\ndelete facts\nselect -clear\n"
    );
    let mut outcome = Proof::Proven(facts.registers.len());
    if !facts.registers.is_empty() {
        facts.insert("assert", folder, &netlist, &wires)?;
        let proof = "sat -tempinduct -tempinduct-inductonly -prove-asserts -set-assumes -maxsteps 1 -timeout 120";
        let said = yosys(folder, "facts.ys", &format!("{build}{proof} {top}\n"))?;
        if !said.contains("SUCCESS") {
            facts.registers.clear();
            outcome = Proof::Failed;
        }
    }
    facts.insert("assume", folder, &netlist, &wires)?;
    let script = format!("{build}write_rtlil {ASSUMED}\n");
    yosys(folder, "assume.ys", &script)?;
    Ok(outcome)
}
