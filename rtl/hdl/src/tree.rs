//! The tree of a design: what simulation, Verilog and rust-hdl read.

use std::panic::Location;
use std::sync::Arc;

/// Widest word.
pub const WIDEST: u32 = 64;

/// A net of one module.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Net(pub usize);

/// An operation on two words. Sums and bitwise operations have the width of their operands, products that of both
/// together, comparisons one bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Binary {
    /// Sum, wrapped.
    Add,
    /// Difference, wrapped.
    Sub,
    /// The whole product.
    Mul,
    /// Bitwise and.
    And,
    /// Bitwise or.
    Or,
    /// Bitwise exclusive or.
    Xor,
    /// Shift to the left by a variable count; what leaves is lost.
    Left,
    /// Shift to the right by a variable count; the sign goes on in a number.
    Right,
    /// Equal.
    Equal,
    /// Less, as words or as numbers.
    Less,
}

/// What drives a net.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Op {
    /// A port of the module.
    Input,
    /// A constant.
    Literal(u64),
    /// Each bit inverted.
    Not(Net),
    /// Two words.
    Binary(Binary, Net, Net),
    /// The second where the first is 1, else the third.
    Select(Net, Net, Net),
    /// As many bits as the net has, from this one upwards.
    Slice(Net, u32),
    /// One behind the other, the highest first.
    Join(Vec<Net>),
    /// More bits in front: the sign of a number, else zeros.
    Extend(Net),
    /// The same bits as the other kind of value.
    Same(Net),
    /// The output of a register.
    Register(usize),
    /// A port of an instance, by the order of its outputs.
    Output(usize, usize),
    /// What is read from a memory.
    Read(usize),
    /// A net that is driven after it was used.
    Forward(Option<Net>),
}

impl Op {
    /// Its value follows from its operands alone, so that two of them are one.
    pub fn is_pure(&self) -> bool {
        !matches!(
            self,
            Op::Input | Op::Register(_) | Op::Output(..) | Op::Read(_) | Op::Forward(_)
        )
    }

    /// The nets that it reads within the same clock and module.
    pub fn operands(&self) -> Vec<Net> {
        match self {
            Op::Not(a) | Op::Slice(a, _) | Op::Extend(a) | Op::Same(a) | Op::Forward(Some(a)) => {
                vec![*a]
            }
            Op::Binary(_, a, b) => vec![*a, *b],
            Op::Select(a, b, c) => vec![*a, *b, *c],
            Op::Join(parts) => parts.clone(),
            _ => vec![],
        }
    }
}

/// A net with its width and what drives it.
#[derive(Clone, Debug)]
pub struct Node {
    /// What drives it.
    pub op: Op,
    /// Bits.
    pub width: u32,
    /// A two's complement number.
    pub signed: bool,
    /// Its name, if it has one.
    pub name: Option<String>,
    /// Where it was built.
    pub place: &'static Location<'static>,
}

impl PartialEq for Node {
    fn eq(&self, other: &Node) -> bool {
        (&self.op, self.width, self.signed, &self.name)
            == (&other.op, other.width, other.signed, &other.name)
    }
}

/// Way of a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Into the module.
    In,
    /// Out of it.
    Out,
}

impl Direction {
    /// What Verilog calls it: `input` or `output`.
    pub fn keyword(self) -> &'static str {
        match self {
            Direction::In => "input",
            Direction::Out => "output",
        }
    }
}

/// A port of a module.
#[derive(Clone, Debug)]
pub struct PortRecord {
    /// Name.
    pub name: String,
    /// What it carries; empty if nobody says so.
    pub meaning: String,
    /// Way.
    pub direction: Direction,
    /// Of an input the port itself, of an output what drives it.
    pub net: Net,
    /// Bits.
    pub width: u32,
    /// A two's complement number.
    pub signed: bool,
}

// Modules are equal whatever their ports are said to carry.
impl PartialEq for PortRecord {
    fn eq(&self, other: &PortRecord) -> bool {
        (&self.name, self.direction, self.net, self.signed)
            == (&other.name, other.direction, other.net, other.signed)
    }
}

/// A register.
#[derive(Clone, Debug, PartialEq)]
pub struct Register {
    /// Its output.
    pub net: Net,
    /// What it takes at the rising edge.
    pub next: Option<Net>,
    /// Where this is 0 it keeps its value.
    pub enable: Option<Net>,
    /// Its value at power-up.
    pub initial: u64,
    /// It holds a state, and is none that makes a value later.
    pub is_state: bool,
}

/// A block memory with one port to write and one to read: the word at the address of the last clock, as it was before
/// a write at that clock; nothing may depend on what is read of a word while it is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Memory {
    /// Name.
    pub name: String,
    /// Bits of a word.
    pub width: u32,
    /// Words.
    pub words: usize,
    /// What it holds at power-up and for ever, if it is never written; else none, and zeros at power-up.
    pub contents: Vec<u64>,
    /// Enable, address and data to write.
    pub write: [Net; 3],
    /// Address to read.
    pub address: Net,
    /// What is read, zero at power-up.
    pub net: Net,
}

impl Memory {
    /// Its words at power-up.
    pub fn at_power_up(&self) -> Vec<u64> {
        match self.contents.as_slice() {
            [] => vec![0; self.words],
            contents => contents.to_vec(),
        }
    }
}

/// A module within another.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// Its name.
    pub name: String,
    /// Its module.
    pub module: Arc<Module>,
    /// What its inputs are connected with, in their order.
    pub inputs: Vec<Net>,
    /// Its outputs, in their order.
    pub outputs: Vec<Net>,
}

/// A module.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Module {
    /// Name.
    pub name: String,
    /// Ports but for the clock, inputs first.
    pub ports: Vec<PortRecord>,
    /// Every net.
    pub nodes: Vec<Node>,
    /// Every register.
    pub registers: Vec<Register>,
    /// Every memory.
    pub memories: Vec<Memory>,
    /// Every instance.
    pub instances: Vec<Instance>,
}

impl Module {
    /// A net.
    pub fn node(&self, net: Net) -> &Node {
        &self.nodes[net.0]
    }

    /// Every net with its node.
    pub fn nets(&self) -> impl DoubleEndedIterator<Item = (Net, &Node)> {
        let nodes = self.nodes.iter().enumerate();
        nodes.map(|(index, node)| (Net(index), node))
    }

    /// Ports of one direction.
    pub fn ports_of(&self, direction: Direction) -> impl Iterator<Item = &PortRecord> {
        let ports = self.ports.iter();
        ports.filter(move |port| port.direction == direction)
    }

    /// Has it a register or a memory, or an instance that has one.
    pub fn is_clocked(&self) -> bool {
        !self.registers.is_empty()
            || !self.memories.is_empty()
            || self.instances.iter().any(|i| i.module.is_clocked())
    }

    /// It holds a state, or one of its instances does.
    pub fn has_state(&self) -> bool {
        self.registers.iter().any(|register| register.is_state)
            || self.instances.iter().any(|i| i.module.has_state())
    }

    /// It and all modules below it, each once, those without instances first.
    pub fn all(self: &Arc<Module>) -> Vec<Arc<Module>> {
        let mut found: Vec<Arc<Module>> = vec![];
        fn visit(module: &Arc<Module>, found: &mut Vec<Arc<Module>>) {
            for instance in &module.instances {
                visit(&instance.module, found);
            }
            if !found.iter().any(|other| Arc::ptr_eq(other, module)) {
                found.push(module.clone());
            }
        }
        visit(self, &mut found);
        found
    }
}

/// Numbers behind those that each of them reads, as far as these are below `count`; of a ring one that is in it.
pub(crate) fn in_order<I: Iterator<Item = usize>>(
    count: usize,
    reads: impl Fn(usize) -> I,
) -> Result<Vec<usize>, usize> {
    let mut order = Vec::with_capacity(count);
    let (mut is_open, mut is_done) = (vec![false; count], vec![false; count]);
    for start in 0..count {
        let mut open = vec![start];
        while let Some(&own) = open.last() {
            if is_open[own] {
                open.pop();
                if !std::mem::replace(&mut is_done[own], true) {
                    order.push(own);
                }
                continue;
            }
            is_open[own] = true;
            for before in reads(own).filter(|before| *before < count && !is_done[*before]) {
                if is_open[before] {
                    return Err(before);
                }
                open.push(before);
            }
        }
    }
    Ok(order)
}
