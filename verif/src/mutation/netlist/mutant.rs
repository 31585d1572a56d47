//! Mutants of a netlist, and the list in which Yosys names them.

use crate::mutation::score::MutationError;
use crate::signal::Signal;

/// The input that selects a mutant; 0 selects none.
pub(super) fn selector(mutants: usize) -> Signal {
    Signal::new("mutant_select", (mutants as u64).ilog2() + 1, false)
}

/// One small change of a netlist.
#[derive(Clone, Debug)]
pub(super) struct Mutant {
    /// Number, from 1.
    pub(super) number: usize,
    /// Cell of the netlist.
    pub(super) cell: String,
    /// Port of the cell.
    pub(super) port: String,
    /// Options of Yosys that make it, without module and control.
    pub(super) command: String,
    /// What is done to which bit of the port. `inv` inverts it, `const0` and `const1` hold it, `cnot0` and `cnot1`
    /// invert it when another bit of the same port is 0 or 1. Behind it stand the signal on the bit and the line of the
    /// Verilog that the cell comes from, where they are known.
    pub(super) text: String,
}

/// The mutants of a list, with the lines of the Verilog `text` they come from.
pub(super) fn parse(list: &str, text: &str) -> Result<Vec<Mutant>, MutationError> {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_yosys_is_understood() {
        let list = "mutate -mode cnot1 -module pe1 -cell $add$unit.v:2$1 -port B -portbit 18 -ctrlbit 23 -wire kept_b -wirebit 18 \
                    -src unit.v:1.23-1.29 -src unit.v:2.24-2.43\n";
        let found = parse(list, "reg b;\n  assign next = a + b;\n").expect("a legal list");
        let [mutant] = found.as_slice() else {
            panic!("one mutant, not {}", found.len())
        };
        assert_eq!(
            mutant.command,
            "-mode cnot1 -cell $add$unit.v:2$1 -port B -portbit 18 -ctrlbit 23"
        );
        assert_eq!(
            mutant.text,
            "cnot1 of B[18] by [23] (kept_b[18]) at $add$unit.v:2$1, line 2: assign next = a + b;"
        );
    }

    #[test]
    fn a_line_without_a_cell_is_refused() {
        let outcome = parse("mutate -mode inv -port A -portbit 0", "");
        assert!(outcome.is_err_and(|error| error.to_string().contains("-port A")));
    }
}
