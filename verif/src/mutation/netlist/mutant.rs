//! Mutants of a netlist: the elaborated unit, the list in which Yosys names them, and all of them in one design.

use crate::mutation::score::{MutationError, Options};
use crate::signal::Signal;
use imogene_tools::{read, yosys};
use std::fmt::Write as _;
use std::path::Path;

/// The input that selects a mutant; 0 selects none.
pub(super) fn selector(mutants: usize) -> Signal {
    Signal::new("mutant_select", (mutants as u64).ilog2() + 1, false)
}

/// One small change of a netlist.
#[derive(Clone, Debug)]
pub struct Mutant {
    /// Number, from 1.
    pub number: usize,
    /// Cell of the netlist.
    pub cell: String,
    /// Port of the cell.
    pub port: String,
    /// Options of Yosys that make it, without module and control.
    pub command: String,
    /// What is done to which bit of the port. `inv` inverts it, `const0` and `const1` hold it, `cnot0` and `cnot1`
    /// invert it when another bit of the same port is 0 or 1. Behind it stand the signal on the bit and the line of the
    /// Verilog that the cell comes from, where they are known.
    pub text: String,
}

/// The port of a register that no mutant changes: no proof knows a clock that is made by logic.
const CLOCK: &str = "CLK";

/// The mutants of a list, with the lines of the Verilog `text` they come from, without those of clocks; refuses a line
/// without mode, cell, port or bit.
pub fn parse(list: &str, text: &str) -> Result<Vec<Mutant>, MutationError> {
    let lines: Vec<&str> = text.lines().collect();
    let listed = list.lines().filter(|line| line.starts_with("mutate "));
    let mutant = |line: &str| one(line, &lines).ok_or_else(|| MutationError::List(line.to_owned()));
    let mut mutants = listed.map(mutant).collect::<Result<Vec<_>, _>>()?;
    mutants.retain(|mutant| mutant.port != CLOCK);
    for (mutant, number) in mutants.iter_mut().zip(1..) {
        mutant.number = number;
    }
    Ok(mutants)
}

fn one(line: &str, lines: &[&str]) -> Option<Mutant> {
    let words: Vec<&str> = line.split_whitespace().skip(1).collect();
    let pairs: Vec<(&str, &str)> = words.chunks(2).map(|p| (p[0], p[1])).collect();
    let all = |option: &str| {
        let matching = pairs.iter().filter(move |(name, _)| *name == option);
        matching.map(|(_, value)| *value).collect::<Vec<_>>()
    };
    let value = |option: &str| all(option).first().copied();
    let made_by = ["-mode", "-cell", "-port", "-portbit", "-ctrlbit"];
    let command = pairs.iter().filter(|(name, _)| made_by.contains(name));
    let command = command.map(|(name, value)| format!("{name} {value}"));
    let (mode, cell, port) = (value("-mode")?, value("-cell")?, value("-port")?);
    let mut text = format!("{mode} of {port}[{}]", value("-portbit")?);
    if let Some(bit) = value("-ctrlbit") {
        text += &format!(" by [{bit}]");
    }
    if let Some((wire, bit)) = value("-wire").zip(value("-wirebit")) {
        text += &format!(" ({wire}[{bit}])");
    }
    text += &format!(" at {cell}");
    // The cell's own place comes last, after that of the wire.
    if let Some(line) = all("-src").last().and_then(|place| first_line(place)) {
        let source = lines.get(line - 1).map_or("", |text| text.trim());
        text += &format!(", line {line}: {source}");
    }
    Some(Mutant {
        number: 0,
        cell: cell.to_owned(),
        port: port.to_owned(),
        command: command.collect::<Vec<_>>().join(" "),
        text,
    })
}

/// The line in `file.v:12.3-14.5`.
fn first_line(place: &str) -> Option<usize> {
    let (_, range) = place.rsplit_once(':')?;
    range.split(['.', '-']).next()?.parse().ok()
}

/// The unit's Verilog in the working folder.
pub const SOURCE: &str = "unit.v";
/// The elaborated unit.
pub const NETLIST: &str = "unit.il";

/// Elaborates the unit, flat, and lists mutants; returns them and how many were possible. The Verilog is in the folder
/// as [`SOURCE`] already, and `text` is the same.
pub fn elaborate(
    folder: &Path,
    top: &str,
    text: &str,
    options: &Options,
) -> Result<(Vec<Mutant>, usize), MutationError> {
    let script = format!(
        "read_verilog {SOURCE}\nhierarchy -check -top {top}\nproc\nflatten\nopt -full\nwreduce\n\
         opt -full\ndffunmap\nopt_expr -fine\nopt_clean\nstat\nwrite_rtlil {NETLIST}\n\
         mutate -list {} -seed {} -o mutants.txt\n",
        options.mutants, options.seed
    );
    let said = yosys(folder, "elaborate.ys", &script)?;
    let mut lines = said.lines();
    let size = lines.find_map(|line| line.strip_prefix("Raw database size: "));
    let candidates = size.and_then(|count| count.trim().parse().ok());
    let unread = || MutationError::List("no size of the database".into());
    let list = read(&folder.join("mutants.txt"))?;
    Ok((parse(&list, text)?, candidates.ok_or_else(unread)?))
}

/// The Verilog of all mutants in one module, with an input that selects one.
pub(super) fn all_mutants(
    folder: &Path,
    top: &str,
    mutants: &[Mutant],
) -> Result<String, MutationError> {
    let selector = selector(mutants.len());
    let mut script = format!("read_rtlil {NETLIST}\n");
    for mutant in mutants {
        let control = format!("{} {}", selector.name, selector.width);
        let (command, number) = (&mutant.command, mutant.number);
        let _ = writeln!(
            script,
            "mutate -module {top} {command} -ctrl {control} {number}"
        );
    }
    script += "write_verilog -noattr mutants.v\n";
    yosys(folder, "mutants.ys", &script)?;
    Ok(read(&folder.join("mutants.v"))?)
}
