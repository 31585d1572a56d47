//! All modules of a design as one list of operations.

use super::code::{Code, Kind};
use crate::build::Design;
use crate::scope::{described, refuse};
use crate::tree::{Binary, Direction, Module, Net, Op, PortRecord, in_order};
use crate::value::mask;
use std::sync::Arc;

/// A port of the design's top module, or a point inside, by its place in a simulator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Port {
    /// Of its word.
    pub place: u32,
    /// Bits.
    pub width: u32,
}

/// A register, by the places of its words.
#[derive(Clone, Copy, Debug)]
pub struct Flop {
    /// What it holds.
    pub output: u32,
    /// Its bits.
    pub width: u32,
    /// What it takes.
    pub next: u32,
    /// A word that is 1 where there is none.
    pub enable: u32,
}

/// A memory, by the places of its words.
#[derive(Clone, Debug)]
pub struct Store {
    /// Words that it holds at power-up.
    pub words: Vec<u64>,
    /// Enable, address and word of a write.
    pub write: [u32; 3],
    /// Of what is read.
    pub address: u32,
    /// What was read.
    pub output: u32,
    /// Bits of a word.
    pub width: u32,
}

/// The word that is always 1.
pub(super) const ONE: u32 = 0;

/// All modules of a design as one list of operations on words.
#[derive(Default)]
pub struct Levels {
    /// What each word is at power-up.
    pub words: Vec<u64>,
    /// Operations, none before those whose results it reads.
    pub code: Vec<Code>,
    /// Registers: those of the instances in a module, then its own.
    pub flops: Vec<Flop>,
    /// Memories, in the same order.
    pub stores: Vec<Store>,
    /// Inputs of the top module in their order, then its outputs.
    ports: Vec<Port>,
    inputs: usize,
    /// Ports of the instances and nets with names, behind the names of the instances around them, as in
    /// `processors_0.quadric.near_sum`.
    pub points: Vec<(String, Port)>,
}

impl Levels {
    /// Sorts the operations of a design.
    ///
    /// # Panics
    ///
    /// With the name of a value in a loop without a register.
    pub fn of(design: &Design) -> Levels {
        let mut flat = Flat::default();
        flat.word(1);
        let inputs = design.top.ports_of(Direction::In);
        let inputs: Vec<u32> = inputs.map(|_| flat.word(0)).collect();
        let outputs = flat.place(&design.top, "", &inputs);
        flat.call_ports(&design.top.ports, "", inputs.iter().chain(&outputs));
        flat.without_copies();
        flat.sort();
        let points = &flat.levels.points;
        let ports = points[points.len() - design.top.ports.len()..].iter();
        Levels {
            ports: ports.map(|(_, port)| *port).collect(),
            inputs: inputs.len(),
            ..flat.levels
        }
    }

    /// The inputs of the top module, in their order.
    pub fn inputs(&self) -> &[Port] {
        &self.ports[..self.inputs]
    }

    /// The outputs of the top module, in their order.
    pub fn outputs(&self) -> &[Port] {
        &self.ports[self.inputs..]
    }
}

/// The modules that were placed, one behind the other.
#[derive(Default)]
struct Flat {
    levels: Levels,
    /// Words that are the same as others.
    copies: Vec<(u32, u32)>,
    /// The net that each operation writes, for messages.
    described: Vec<(Arc<Module>, Net)>,
}

impl Flat {
    fn word(&mut self, value: u64) -> u32 {
        self.levels.words.push(value);
        self.levels.words.len() as u32 - 1
    }

    /// Adds a module whose inputs are these words, and gives those of its outputs; `path` stands before the names
    /// inside.
    fn place(&mut self, module: &Arc<Module>, path: &str, inputs: &[u32]) -> Vec<u32> {
        // Words first, so that operations may refer forward.
        let mut places = vec![u32::MAX; module.nodes.len()];
        for (port, place) in module.ports_of(Direction::In).zip(inputs) {
            places[port.net.0] = *place;
        }
        for (place, node) in places.iter_mut().zip(&module.nodes) {
            match &node.op {
                Op::Input | Op::Same(_) | Op::Forward(_) => {}
                Op::Literal(value) => *place = self.word(*value),
                Op::Register(index) => *place = self.word(module.registers[*index].initial),
                _ => *place = self.word(0),
            }
        }
        let at = |net: Net| {
            let mut net = net;
            // A ring of nothing but other names has no word; it is refused by its first.
            for _ in 0..module.nodes.len() {
                match &module.node(net).op {
                    Op::Same(other) | Op::Forward(Some(other)) => net = *other,
                    _ => return places[net.0],
                }
            }
            refuse!("{} is a loop", described(module, net));
        };
        for instance in &module.instances {
            let inputs: Vec<u32> = instance.inputs.iter().map(|net| at(*net)).collect();
            let path = format!("{path}{}.", instance.name);
            let inner = self.place(&instance.module, &path, &inputs);
            for (net, word) in instance.outputs.iter().zip(&inner) {
                self.copies.push((places[net.0], *word));
            }
            self.call_ports(&instance.module.ports, &path, inputs.iter().chain(&inner));
        }
        for (net, node) in module.nets() {
            if let (Some(name), false) = (&node.name, node.op == Op::Input) {
                let (place, width) = (at(net), node.width);
                let point = (format!("{path}{name}"), Port { place, width });
                self.levels.points.push(point);
            }
            self.operation(module, net, &node.op, &at);
        }
        for register in &module.registers {
            self.levels.flops.push(Flop {
                output: at(register.net),
                width: module.node(register.net).width,
                next: at(register.next.expect("a closed module has all inputs")),
                enable: register.enable.map_or(ONE, at),
            });
        }
        for memory in &module.memories {
            self.levels.stores.push(Store {
                words: memory.at_power_up(),
                write: memory.write.map(at),
                address: at(memory.address),
                output: at(memory.net),
                width: memory.width,
            });
        }
        let outputs = module.ports_of(Direction::Out);
        outputs.map(|port| at(port.net)).collect()
    }

    /// Calls the words of ports after them.
    fn call_ports<'a>(
        &mut self,
        ports: &[PortRecord],
        path: &str,
        words: impl Iterator<Item = &'a u32>,
    ) {
        for (port, place) in ports.iter().zip(words) {
            let (place, width) = (*place, port.width);
            let name = format!("{path}{}", port.name);
            self.levels.points.push((name, Port { place, width }));
        }
    }

    fn operation(&mut self, module: &Arc<Module>, net: Net, op: &Op, at: &impl Fn(Net) -> u32) {
        let to = at(net);
        let front = |net: &Net| 64 - module.node(*net).width;
        let is_signed = |net: &Net| module.node(*net).signed;
        let (kind, count) = match op {
            Op::Not(_) => (Kind::Not, 0),
            Op::Binary(Binary::Add, ..) => (Kind::Add, 0),
            Op::Binary(Binary::Sub, ..) => (Kind::Sub, 0),
            Op::Binary(Binary::Mul, ..) => (Kind::Mul, 0),
            Op::Binary(Binary::And, ..) => (Kind::And, 0),
            Op::Binary(Binary::Or, ..) => (Kind::Or, 0),
            Op::Binary(Binary::Xor, ..) => (Kind::Xor, 0),
            Op::Binary(Binary::Left, ..) => (Kind::Left, 0),
            Op::Binary(Binary::Right, a, _) if is_signed(a) => (Kind::RightSigned, front(a)),
            Op::Binary(Binary::Right, ..) => (Kind::Right, 0),
            Op::Binary(Binary::Equal, ..) => (Kind::Equal, 0),
            Op::Binary(Binary::Less, a, _) if is_signed(a) => (Kind::LessSigned, 63 - front(a)),
            Op::Binary(Binary::Less, ..) => (Kind::Less, 0),
            Op::Select(..) => (Kind::Select, 0),
            Op::Slice(_, low) => (Kind::Slice, *low),
            Op::Extend(a) if is_signed(a) => (Kind::Sign, front(a)),
            Op::Extend(a) => return self.copies.push((to, at(*a))),
            Op::Join(parts) => return self.join(module, net, parts, at),
            _ => return,
        };
        let operands = op.operands().into_iter();
        let from = operands.map(|operand| match kind {
            // The factors of a product with all bits of their sign.
            Kind::Mul if is_signed(&operand) => {
                let front = front(&operand);
                self.push(module, net, Kind::Sign, &[at(operand)], front, None)
            }
            _ => at(operand),
        });
        let from: Vec<u32> = from.collect();
        self.push(module, net, kind, &from, count, Some(to));
    }

    /// Parts one behind the other, two by two; all but the last pair need a word between.
    fn join(&mut self, module: &Arc<Module>, net: Net, parts: &[Net], at: &impl Fn(Net) -> u32) {
        let mut above = at(parts[0]);
        for (index, part) in parts.iter().enumerate().skip(1) {
            let to = (index + 1 == parts.len()).then(|| at(net));
            let (from, count) = ([above, at(*part)], module.node(*part).width);
            above = self.push(module, net, Kind::Above, &from, count, to);
        }
        if parts.len() == 1 {
            self.copies.push((at(net), above));
        }
    }

    /// Adds an operation, one of those that a net needs, and gives the word that it writes: without `to` a new one.
    fn push(
        &mut self,
        module: &Arc<Module>,
        net: Net,
        kind: Kind,
        operands: &[u32],
        count: u32,
        to: Option<u32>,
    ) -> u32 {
        let mut from = [ONE; 3];
        from[..operands.len()].copy_from_slice(operands);
        let mask = to.map_or(u64::MAX, |_| mask(module.node(net).width));
        let to = to.unwrap_or_else(|| self.word(0));
        self.levels.code.push(Code {
            kind,
            from,
            count,
            to,
            mask,
        });
        self.described.push((module.clone(), net));
        to
    }

    /// One word in the place of all that are the same.
    fn without_copies(&mut self) {
        let mut same: Vec<u32> = (0..self.levels.words.len() as u32).collect();
        for (to, from) in &self.copies {
            same[*to as usize] = *from;
        }
        let first = |mut place: u32| {
            while same[place as usize] != place {
                place = same[place as usize];
            }
            place
        };
        self.renumber(first);
    }

    fn renumber(&mut self, number: impl Fn(u32) -> u32) {
        let renumber = |place: &mut u32| *place = number(*place);
        for Code { from, to, .. } in &mut self.levels.code {
            from.iter_mut().chain([to]).for_each(renumber);
        }
        for flop in &mut self.levels.flops {
            let places = [&mut flop.output, &mut flop.next, &mut flop.enable];
            places.into_iter().for_each(renumber);
        }
        for store in &mut self.levels.stores {
            let places = [&mut store.address, &mut store.output];
            store.write.iter_mut().chain(places).for_each(renumber);
        }
        let points = self.levels.points.iter_mut();
        points.map(|(_, point)| &mut point.place).for_each(renumber);
    }

    /// Puts operations behind those whose results they read.
    fn sort(&mut self) {
        let code = &self.levels.code;
        let mut writer = vec![usize::MAX; self.levels.words.len()];
        for (index, code) in code.iter().enumerate() {
            writer[code.to as usize] = index;
        }
        let reads = |index: usize| code[index].reads().iter();
        let order = in_order(code.len(), |index| {
            reads(index).map(|place| writer[*place as usize])
        });
        let order = order.unwrap_or_else(|index| {
            let (module, net) = &self.described[index];
            let value = described(module, *net);
            refuse!("{value} depends on itself within one clock")
        });
        self.levels.code = order.into_iter().map(|index| code[index]).collect();
    }
}
