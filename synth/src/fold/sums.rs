//! Choices before and behind a sum become part of it.
//!
//! A bit of a sum is a look-up table of four inputs, of which Yosys uses two: the terms. Its value is exclusive-or with
//! the carry into it; where it is 0, the carry out of it is a second table, of the inputs A and B alone, which has the
//! entries that the first one has for C and D of 0. So a bit can also
//!
//! * give a third bit in place of the sum, when a fourth one says so: B stops the carry, and
//! * form one of its terms from up to three inputs, as long as the term is 0 where two of them are.
//!
//! A register that loads or adds is then one cell for each of its bits, not two.

use super::{Cells, Readers, TABLE};
use serde_json::{Value, json};
use std::collections::HashMap;

/// Two bits of a sum.
const SUM: &str = "CCU2C";
/// Entries of a bit of a sum whose input C is 0 or, where the second term is inverted, 1, and D is 1.
const ADDS: u16 = 0x96aa;
/// Inputs of a look-up table, and of a bit of a sum before its number.
const INPUTS: [&str; 4] = ["A", "B", "C", "D"];

/// A net, or a constant.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Net {
    Wire(u64),
    Constant(bool),
}

impl Net {
    /// None if it is neither, such as a bit of any value.
    fn of(bit: &Value) -> Option<Net> {
        match (bit.as_u64(), bit.as_str()) {
            (Some(wire), _) => Some(Net::Wire(wire)),
            (None, Some("0")) => Some(Net::Constant(false)),
            (None, Some("1")) => Some(Net::Constant(true)),
            _ => None,
        }
    }

    fn bits(self) -> Value {
        match self {
            Net::Wire(wire) => json!([wire]),
            Net::Constant(value) => json!([if value { "1" } else { "0" }]),
        }
    }
}

/// A bit of a sum: the cell, and which of its two bits.
#[derive(Clone, Copy)]
struct Bit<'a> {
    cell: &'a str,
    half: usize,
}

impl Bit<'_> {
    fn port(self, input: &str) -> String {
        format!("{input}{}", self.half)
    }

    fn net(self, cells: &Cells, input: &str) -> Option<Net> {
        net(&cells[self.cell], &self.port(input))
    }
}

/// What a port of one bit is connected to.
fn net(cell: &Value, port: &str) -> Option<Net> {
    Net::of(&cell["connections"][port][0])
}

/// The entries of a look-up table.
fn entries(cell: &Value, parameter: &str) -> Option<u16> {
    u16::from_str_radix(cell["parameters"][parameter].as_str()?, 2).ok()
}

/// Entries of a table of four inputs whose value is this.
fn table(value: impl Fn([bool; 4]) -> bool) -> u16 {
    let inputs = |index: u16| [0, 1, 2, 3].map(|input| index >> input & 1 == 1);
    let entry = |index| u16::from(value(inputs(index))) << index;
    (0..16).map(entry).sum()
}

/// A bit of a sum as Yosys writes it: both terms, and whether the second one is inverted.
struct Terms {
    terms: [Net; 2],
    inverted: bool,
}

impl Terms {
    fn of(cells: &Cells, bit: Bit) -> Option<Terms> {
        let cell = &cells[bit.cell];
        let takes_carries = cell["parameters"][bit.port("INJECT1_")] == "NO";
        let is_sum = takes_carries && entries(cell, &bit.port("INIT"))? == ADDS;
        let [first, second, control, last] = INPUTS.map(|input| bit.net(cells, input));
        let Some(Net::Constant(inverted)) = control else {
            return None;
        };
        let is_plain = is_sum && last == Some(Net::Constant(true));
        let terms = [first?, second?];
        is_plain.then_some(Terms { terms, inverted })
    }
}

/// A function of nets, as a look-up table.
struct Function {
    inputs: Vec<Net>,
    entries: u16,
}

impl Function {
    fn of(cell: &Value) -> Option<Function> {
        let nets = INPUTS.map(|input| net(cell, input));
        let inputs = nets.into_iter().collect::<Option<Vec<Net>>>()?;
        let entries = entries(cell, "INIT")?;
        Some(Function { inputs, entries })
    }

    /// The nets among its inputs, each once.
    fn wires(&self) -> Vec<Net> {
        let mut wires: Vec<Net> = vec![];
        for input in &self.inputs {
            if matches!(input, Net::Wire(_)) && !wires.contains(input) {
                wires.push(*input);
            }
        }
        wires
    }

    /// Its value where its nets have these.
    fn at(&self, value: impl Fn(Net) -> bool) -> bool {
        let bit = |(place, net): (usize, &Net)| {
            let is_set = match *net {
                Net::Constant(value) => value,
                wire => value(wire),
            };
            u16::from(is_set) << place
        };
        let index: u16 = self.inputs.iter().enumerate().map(bit).sum();
        self.entries >> index & 1 == 1
    }
}

/// Moves the choices of a module; how many look-up tables there were.
pub(super) fn fold(cells: &mut Cells, readers: &Readers) -> u64 {
    let sums: Vec<String> = names(cells, SUM);
    let chains = sums.iter().filter_map(|first| chain(cells, readers, first));
    let chains: Vec<Vec<String>> = chains.collect();
    let behind: u64 = chains
        .iter()
        .map(|chain| fold_behind(cells, readers, chain))
        .sum();
    let writers = writers(cells);
    let halves = sums
        .iter()
        .flat_map(|cell| [0, 1].map(|half| Bit { cell, half }));
    let before = halves.filter(|bit| fold_before(cells, readers, &writers, *bit));
    behind + before.count() as u64
}

fn names(cells: &Cells, kind: &str) -> Vec<String> {
    let cells = cells.iter().filter(|(_, cell)| cell["type"] == kind);
    cells.map(|(name, _)| name.clone()).collect()
}

/// The look-up table that drives a net.
fn writers(cells: &Cells) -> HashMap<u64, String> {
    let tables = names(cells, TABLE).into_iter();
    let written =
        tables.filter_map(|name| Some((cells[&name]["connections"]["Z"][0].as_u64()?, name)));
    written.collect()
}

/// The cells of a sum from one into which no carry goes, if its last carry goes nowhere.
fn chain(cells: &Cells, readers: &Readers, first: &str) -> Option<Vec<String>> {
    let mut chain = vec![first.to_owned()];
    if net(&cells[first], "CIN")? != Net::Constant(false) {
        return None;
    }
    loop {
        let carry = &cells[chain.last()?]["connections"]["COUT"][0];
        let readers = carry.as_u64().and_then(|carry| readers.get(&carry));
        match readers.map(Vec::as_slice) {
            None | Some([]) => return Some(chain),
            Some([(Some(next), port)]) if port == "CIN" => chain.push(next.clone()),
            _ => return None,
        }
    }
}

/// What follows a bit of a sum: the look-up table, what it gives in place of the sum, and the net that says so, with
/// its value where it does.
struct Choice {
    table: String,
    chosen: Net,
    steered: (Net, bool),
}

/// Moves choices behind a sum into it: every bit must go to one or nowhere, and one net steer all, for where it
/// chooses there are no carries.
fn fold_behind(cells: &mut Cells, readers: &Readers, chain: &[String]) -> u64 {
    let bits = chain
        .iter()
        .flat_map(|cell| [0, 1].map(|half| Bit { cell, half }));
    let found = bits.map(|bit| {
        let terms = Terms::of(cells, bit).filter(|terms| !terms.inverted)?;
        Some((bit, terms.terms, follower(cells, readers, bit).ok()?))
    });
    let found: Vec<_> = found.collect::<Option<_>>().unwrap_or_default();
    let mut steering = found
        .iter()
        .filter_map(|(_, _, choice)| Some(choice.as_ref()?.steered));
    let Some(steered) = steering
        .next()
        .filter(|first| steering.all(|other| other == *first))
    else {
        return 0;
    };
    let mut folded = 0;
    for (bit, terms, choice) in found {
        let chosen = choice
            .as_ref()
            .map_or(Net::Constant(true), |choice| choice.chosen);
        load_or_add(cells, bit, terms, chosen, steered);
        if let Some(Choice { table, .. }) = choice {
            let table = cells.remove(&table).unwrap_or_default();
            cells[bit.cell]["connections"][bit.port("S")] = table["connections"]["Z"].clone();
            folded += 1;
        }
    }
    folded
}

/// A bit of a sum is read by something that is no choice, or by more.
struct NoChoice;

/// The choice that follows a bit of a sum; none if nothing reads it.
fn follower(cells: &Cells, readers: &Readers, bit: Bit) -> Result<Option<Choice>, NoChoice> {
    let Some(Net::Wire(sum)) = bit.net(cells, "S") else {
        return Ok(None);
    };
    let is_table = |cell: &&Value| cell["type"] == TABLE;
    match readers.get(&sum).map_or(&[][..], Vec::as_slice) {
        [] => Ok(None),
        [(Some(table), _)] => {
            // A choice between two sums is part of the first one by now.
            let read = cells.get(table).filter(is_table).ok_or(NoChoice)?;
            let function = Function::of(read).ok_or(NoChoice)?;
            let (chosen, steered) = choice(&function, Net::Wire(sum)).ok_or(NoChoice)?;
            let table = table.clone();
            Ok(Some(Choice {
                table,
                chosen,
                steered,
            }))
        }
        _ => Err(NoChoice),
    }
}

/// What a function gives in place of a sum, and the net that says so, if it is a choice.
fn choice(function: &Function, sum: Net) -> Option<(Net, (Net, bool))> {
    let wires = function.wires();
    let others: Vec<Net> = wires.into_iter().filter(|wire| *wire != sum).collect();
    let (wires, steering) = match others[..] {
        [steering] => ([false, true].map(Net::Constant), [steering, steering]),
        [a, b] => ([b, a], [a, b]),
        _ => return None,
    };
    let ways = wires.into_iter().zip(steering);
    let mut ways = ways.flat_map(|(chosen, net)| [false, true].map(|value| (chosen, (net, value))));
    ways.find(|(chosen, steered)| is_choice(function, sum, *chosen, *steered))
}

/// True if a function gives `chosen` where the steering net has its value, and else the sum.
fn is_choice(function: &Function, sum: Net, chosen: Net, (steering, value): (Net, bool)) -> bool {
    (0..8).all(|case: u8| {
        let nets = [sum, steering, chosen].into_iter();
        let at = |net| match net {
            Net::Constant(value) => value,
            wire => nets
                .clone()
                .position(|one| one == wire)
                .is_some_and(|place| case >> place & 1 == 1),
        };
        function.at(at) == at(if at(steering) == value { chosen } else { sum })
    })
}

/// A bit that gives `chosen` where the steering net has its value, and no carry then.
fn load_or_add(cells: &mut Cells, bit: Bit, terms: [Net; 2], chosen: Net, steered: (Net, bool)) {
    let (steering, value) = steered;
    let entries = table(|[a, b, c, d]| if b == value { c } else { a != d });
    put(cells, bit, [terms[0], steering, chosen, terms[1]], entries);
}

/// Moves the table that gives a term of a bit into it, if nothing else reads that; whether it did.
fn fold_before(
    cells: &mut Cells,
    readers: &Readers,
    writers: &HashMap<u64, String>,
    bit: Bit,
) -> bool {
    let Some(Terms { terms, inverted }) = Terms::of(cells, bit) else {
        return false;
    };
    let moved = [0, 1].into_iter().find_map(|which| {
        let Net::Wire(wire) = terms[which] else {
            return None;
        };
        let writer = writers.get(&wire).filter(|_| readers[&wire].len() == 1)?;
        let function = Function::of(&cells[writer])?;
        // The second term is the one that may be inverted.
        let (kept, own) = (inverted && which == 0, inverted && which == 1);
        let ([b, c, d], entries) = term_of(&function, own, kept)?;
        Some((writer.clone(), [terms[1 - which], b, c, d], entries))
    });
    let Some((writer, inputs, entries)) = moved else {
        return false;
    };
    cells.remove(&writer);
    put(cells, bit, inputs, entries);
    true
}

/// Inputs B, C and D, and the entries, of a bit that adds a function to input A. `own`, `kept`: the function, the other
/// term is inverted.
fn term_of(function: &Function, own: bool, kept: bool) -> Option<([Net; 3], u16)> {
    let wires = function.wires();
    let term = |values: [(Net, bool); 3]| {
        let of = |net| values.iter().any(|(wire, value)| *wire == net && *value);
        function.at(of) != own
    };
    let one = Net::Constant(true);
    let inputs = match wires[..] {
        [b] => [b, one, one],
        [b, c] => [b, c, one],
        [x, y, z] => [[x, y, z], [y, x, z], [z, x, y]]
            .into_iter()
            .find(|[b, c, d]| {
                let without = |free| term([(*b, free), (*c, false), (*d, false)]);
                !without(false) && !without(true)
            })?,
        _ => return None,
    };
    let [first, second, last] = inputs;
    let entries = table(|[a, b, c, d]| {
        let added = (d || last != one) && term([(first, b), (second, c), (last, d)]);
        (a != kept) != added
    });
    Some((inputs, entries))
}

fn put(cells: &mut Cells, bit: Bit, inputs: [Net; 4], entries: u16) {
    let cell = &mut cells[bit.cell];
    for (input, net) in INPUTS.iter().zip(inputs) {
        cell["connections"][bit.port(input)] = net.bits();
    }
    cell["parameters"][bit.port("INIT")] = format!("{entries:016b}").into();
}
