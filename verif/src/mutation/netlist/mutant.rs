//! Mutants of a netlist, and the list in which Yosys names them.

use crate::mutation::score::MutationError;
use crate::signal::Signal;

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

/// The mutants of a list, with the lines of the Verilog `text` they come from.
///
/// # Errors
///
/// When a line of the list lacks its mode, cell, port or bit.
pub fn parse(list: &str, text: &str) -> Result<Vec<Mutant>, MutationError> {
    let lines: Vec<&str> = text.lines().collect();
    list.lines()
        .filter(|line| line.starts_with("mutate "))
        .zip(1..)
        .map(|(line, number)| {
            one(line, number, &lines).ok_or_else(|| MutationError::List(line.to_owned()))
        })
        .collect()
}

fn one(line: &str, number: usize, lines: &[&str]) -> Option<Mutant> {
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
        number,
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
