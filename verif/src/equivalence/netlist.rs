//! An elaborated text: its ports, and its registers by the emitter's names.

use super::EquivalenceError;
use crate::yosys::cut::{cut, registers};
use std::collections::{BTreeMap, HashMap};

/// What two registers must have in common.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Register {
    width: usize,
    rising: bool,
    /// Initial bits, none if it has no initial value.
    initial: Option<String>,
}

/// Direction and name of a port.
type Port = (String, String);

pub(super) struct Netlist {
    text: String,
    ports: BTreeMap<usize, Port>,
    /// By name.
    pub registers: BTreeMap<String, Register>,
    /// Names in the order of the text.
    order: Vec<String>,
}

impl Netlist {
    /// Reads the text of a flat netlist.
    pub fn read(top: &str, text: String) -> Result<Netlist, EquivalenceError> {
        let refused = |problem: String| EquivalenceError::Netlist {
            top: top.to_owned(),
            problem,
        };
        if text
            .lines()
            .filter(|line| line.starts_with("module "))
            .count()
            != 1
        {
            return Err(refused("it is not one flat module".into()));
        }
        let (ports, initial) = wires(&text);
        let mut found = BTreeMap::new();
        let mut order = Vec::new();
        for register in registers(&text) {
            let name = name(register.value)
                .ok_or_else(|| refused(format!("{} is no whole register", register.value)))?;
            let entry = Register {
                width: register.width.parse().unwrap_or(0),
                rising: register.edge == "1'1",
                initial: initial.get(register.value).cloned(),
            };
            if found.insert(name.clone(), entry).is_some() {
                return Err(refused(format!("two registers are called `{name}`")));
            }
            order.push(name);
        }
        Ok(Netlist {
            text,
            ports,
            registers: found,
            order,
        })
    }

    /// Bits of all registers.
    pub fn bits(&self) -> usize {
        self.registers.values().map(|register| register.width).sum()
    }

    /// Renames the ports to those of the other netlist at the same places; says what does not go together.
    pub fn adopt_ports(&mut self, other: &Netlist) -> Option<String> {
        if self.ports.len() != other.ports.len() {
            let (here, there) = (self.ports.len(), other.ports.len());
            return Some(format!("{here} ports and {there}"));
        }
        let mut names = HashMap::new();
        for ((direction, port), (of_other, other)) in self.ports.values().zip(other.ports.values())
        {
            if direction != of_other {
                return Some(format!("port {other} is {direction} and {of_other}"));
            }
            names.insert(port.clone(), other.clone());
        }
        let line = |line: &str| renamed(line, &names);
        self.text = self.text.lines().map(line).collect();
        self.ports.clone_from(&other.ports);
        None
    }

    /// The first register that the other netlist lacks, has alone, or has with another width, edge or initial value.
    pub fn difference(&self, other: &Netlist) -> Option<String> {
        let names = self.registers.keys().chain(other.registers.keys());
        let place = |name: &&String| self.registers.get(*name) != other.registers.get(*name);
        let without = |name: &&String| self.registers[*name].initial.is_none();
        let name = names.clone().find(place);
        if let Some(name) = name {
            let [here, there] = [self, other].map(|netlist| match netlist.registers.get(name) {
                Some(Register {
                    width,
                    rising,
                    initial,
                }) => {
                    let edge = if *rising { "rising" } else { "falling" };
                    let initial = initial.as_deref().unwrap_or("unknown");
                    format!("{width} bits, {edge} edge, initially {initial}")
                }
                None => "no register".to_owned(),
            });
            return Some(format!("register {name}: {here}; {there}"));
        }
        let unknown = self.registers.keys().find(without);
        unknown.map(|name| format!("register {name} has no initial value"))
    }

    /// The text with its registers cut, each numbered by the place of its name.
    pub fn cut(&self) -> String {
        let numbers: HashMap<&String, usize> = self.registers.keys().zip(0..).collect();
        cut(&self.text, |place| numbers[&self.order[place]])
    }
}

/// A line with some names replaced; in a netlist every name stands between spaces.
fn renamed(line: &str, names: &HashMap<String, String>) -> String {
    let word = |word| names.get(word).map_or(word, String::as_str);
    let words: Vec<&str> = line.split(' ').map(word).collect();
    words.join(" ") + "\n"
}

/// Ports by their places, and initial values by the names of wires.
fn wires(text: &str) -> (BTreeMap<usize, Port>, HashMap<String, String>) {
    let mut ports = BTreeMap::new();
    let mut initial = HashMap::new();
    let mut pending = None;
    for line in text.lines().map(str::trim) {
        if let Some(bits) = line.strip_prefix("attribute \\init ") {
            pending = Some(bits.to_owned());
        }
        let Some(options) = line.strip_prefix("wire ") else {
            continue;
        };
        let words: Vec<&str> = options.split(' ').collect();
        let wire = words.last().copied().unwrap_or_default();
        if let Some(bits) = pending.take() {
            initial.insert(wire.to_owned(), bits);
        }
        let is_direction = |word: &&str| matches!(*word, "input" | "output" | "inout");
        let at = words.iter().position(is_direction);
        let place = at.and_then(|at| words.get(at + 1)?.parse().ok());
        if let (Some(at), Some(place)) = (at, place) {
            ports.insert(place, (words[at].to_owned(), wire.to_owned()));
        }
    }
    (ports, initial)
}

/// The emitter's name of a register, from the signal of its value. In rust-hdl's text a register is a module with an output `q`.
fn name(value: &str) -> Option<String> {
    let path = value
        .strip_prefix('\\')
        .filter(|path| !path.contains(' '))?;
    let path = path.strip_suffix(".q").unwrap_or(path);
    Some(path.replace('$', "_"))
}

/// Ports of a comparison with the numbers of cut registers replaced by their names.
pub(super) fn names_of_registers(ports: &[String], netlist: &Netlist) -> Vec<String> {
    let named = |port: &String| {
        let parts = [("cut_d_", "next value of "), ("cut_c_", "clock of ")];
        let register = parts.into_iter().find_map(|(prefix, what)| {
            let number: usize = port.strip_prefix(prefix)?.parse().ok()?;
            let name = netlist.registers.keys().nth(number)?;
            Some(format!("{what}{name}"))
        });
        register.unwrap_or_else(|| port.clone())
    };
    ports.iter().map(named).collect()
}
