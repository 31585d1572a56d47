//! All modules of a design as one list of operations.

use super::code::{Code, Kind};
use super::{Flop, ONE, Port, Store};
use crate::build::{described, refuse};
use crate::tree::{Binary, Direction, Module, Net, Op};
use crate::value::mask;
use std::rc::Rc;

/// All modules of a design, one behind the other.
#[derive(Default)]
pub(super) struct Flat {
    pub(super) words: Vec<u64>,
    pub(super) code: Vec<Code>,
    pub(super) flops: Vec<Flop>,
    pub(super) stores: Vec<Store>,
    /// Words of constants.
    literals: Vec<u32>,
    /// Words that are the same as others.
    copies: Vec<(u32, u32)>,
    /// Names of the words that operations write, for messages.
    described: Vec<(u32, Rc<Module>, Net)>,
    /// Points inside, by their paths.
    pub(super) points: Vec<(String, Port)>,
}

impl Flat {
    pub(super) fn word(&mut self, value: u64) -> u32 {
        self.words.push(value);
        self.words.len() as u32 - 1
    }

    /// Adds a module whose inputs are these words, and gives those of its outputs; `path` stands before the names inside.
    pub(super) fn place(&mut self, module: &Rc<Module>, path: &str, inputs: &[u32]) -> Vec<u32> {
        // Words first, so that operations may refer forward.
        let mut places = vec![u32::MAX; module.nodes.len()];
        for (port, place) in module.ports_of(Direction::In).zip(inputs) {
            places[port.net.0 as usize] = *place;
        }
        for (place, node) in places.iter_mut().zip(&module.nodes) {
            match &node.op {
                Op::Input | Op::Same(_) | Op::Forward(_) => {}
                Op::Literal(value) => {
                    *place = self.word(*value);
                    self.literals.push(*place);
                }
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
                    _ => return places[net.0 as usize],
                }
            }
            refuse(format!("{} is a loop", described(module, net)));
        };
        for instance in &module.instances {
            let inputs: Vec<u32> = instance.inputs.iter().map(|net| at(*net)).collect();
            let path = format!("{path}{}.", instance.name);
            let inner = self.place(&instance.module, &path, &inputs);
            for (net, word) in instance.outputs.iter().zip(&inner) {
                self.copies.push((places[net.0 as usize], *word));
            }
            let words = inputs.iter().chain(&inner);
            for (port, place) in instance.module.ports.iter().zip(words) {
                let (place, width) = (*place, port.width);
                let name = format!("{path}{}", port.name);
                self.points.push((name, Port { place, width }));
            }
        }
        for (index, node) in module.nodes.iter().enumerate() {
            if let (Some(name), false) = (&node.name, node.op == Op::Input) {
                let (place, width) = (at(Net(index as u32)), node.width);
                self.points
                    .push((format!("{path}{name}"), Port { place, width }));
            }
        }
        for (index, node) in module.nodes.iter().enumerate() {
            self.operation(module, Net(index as u32), &node.op, &at);
        }
        for register in &module.registers {
            self.flops.push(Flop {
                output: at(register.net),
                next: at(register.next.expect("a closed module has all inputs")),
                enable: register.enable.map_or(ONE, at),
            });
        }
        for memory in &module.memories {
            self.stores.push(Store {
                words: memory.words,
                write: memory.write.map(at),
                address: at(memory.address),
                output: at(memory.net),
            });
        }
        module
            .ports_of(Direction::Out)
            .map(|port| at(port.net))
            .collect()
    }

    fn operation(&mut self, module: &Rc<Module>, net: Net, op: &Op, at: &impl Fn(Net) -> u32) {
        let (node, to) = (module.node(net), at(net));
        let mask = mask(node.width);
        let front = |net: Net| 64 - module.node(net).width;
        let is_signed = |net: Net| module.node(net).signed;
        let (kind, from, count) = match op {
            Op::Not(a) => (Kind::Not, vec![*a], 0),
            Op::Binary(binary, a, b) => {
                let (kind, count) = match binary {
                    Binary::Add => (Kind::Add, 0),
                    Binary::Sub => (Kind::Sub, 0),
                    Binary::Mul => (Kind::Mul, 0),
                    Binary::And => (Kind::And, 0),
                    Binary::Or => (Kind::Or, 0),
                    Binary::Xor => (Kind::Xor, 0),
                    Binary::Left => (Kind::Left, 0),
                    Binary::Right if is_signed(*a) => (Kind::RightSigned, front(*a)),
                    Binary::Right => (Kind::Right, 0),
                    Binary::Equal => (Kind::Equal, 0),
                    Binary::Less if is_signed(*a) => (Kind::LessSigned, 63 - front(*a)),
                    Binary::Less => (Kind::Less, 0),
                };
                (kind, vec![*a, *b], count)
            }
            Op::Select(which, a, b) => (Kind::Select, vec![*which, *a, *b], 0),
            Op::Slice(a, low) => (Kind::Slice, vec![*a], *low),
            Op::Extend(a) if is_signed(*a) => (Kind::Sign, vec![*a], front(*a)),
            Op::Extend(a) => return self.copies.push((to, at(*a))),
            Op::Join(parts) => return self.join(module, net, parts, at),
            _ => return,
        };
        let mut words = [ONE; 3];
        for (word, operand) in words.iter_mut().zip(from) {
            *word = at(operand);
            if kind == Kind::Mul && is_signed(operand) {
                // The factors of a product with all bits of their sign.
                let code = Code {
                    kind: Kind::Sign,
                    from: [*word, ONE, ONE],
                    count: front(operand),
                    to: self.word(0),
                    mask: u64::MAX,
                };
                self.push(module, net, code);
                *word = code.to;
            }
        }
        let code = Code {
            kind,
            from: words,
            count,
            to,
            mask,
        };
        self.push(module, net, code);
    }

    /// Parts one behind the other, two by two; all but the last pair need a word between.
    fn join(&mut self, module: &Rc<Module>, net: Net, parts: &[Net], at: &impl Fn(Net) -> u32) {
        let mut above = at(parts[0]);
        for (index, part) in parts.iter().enumerate().skip(1) {
            let to = match index + 1 == parts.len() {
                true => at(net),
                false => self.word(0),
            };
            let code = Code {
                kind: Kind::Above,
                from: [above, at(*part), ONE],
                count: module.node(*part).width,
                to,
                mask: u64::MAX,
            };
            self.push(module, net, code);
            above = to;
        }
        if parts.len() == 1 {
            self.copies.push((at(net), above));
        }
    }

    fn push(&mut self, module: &Rc<Module>, net: Net, code: Code) {
        self.code.push(code);
        self.described.push((code.to, module.clone(), net));
    }

    /// One word in the place of all that are the same.
    pub(super) fn without_copies(&mut self, ports: &mut [u32]) {
        let mut same: Vec<u32> = (0..self.words.len() as u32).collect();
        for (to, from) in &self.copies {
            same[*to as usize] = *from;
        }
        let first = |mut place: u32| {
            while same[place as usize] != place {
                place = same[place as usize];
            }
            place
        };
        self.renumber(ports, first);
    }

    /// Puts the words in the order in which a clock goes through them: state, results of operations, the others.
    pub(super) fn in_order(&mut self, words: Vec<[u64; 1]>, ports: &mut [u32]) -> Vec<[u64; 1]> {
        let results = self.code.iter().map(|code| code.to);
        let first = [ONE].into_iter().chain(self.state()).chain(results);
        let mut number = vec![u32::MAX; words.len()];
        let mut order = vec![];
        for place in first.chain(0..words.len() as u32) {
            if number[place as usize] == u32::MAX {
                number[place as usize] = order.len() as u32;
                order.push(place);
            }
        }
        self.renumber(ports, |place| number[place as usize]);
        order
            .into_iter()
            .map(|place| words[place as usize])
            .collect()
    }

    /// The words that a clock writes.
    pub(super) fn state(&self) -> impl Iterator<Item = u32> {
        let flops = self.flops.iter().map(|flop| flop.output);
        flops.chain(self.stores.iter().map(|store| store.output))
    }

    fn renumber(&mut self, ports: &mut [u32], number: impl Fn(u32) -> u32) {
        let renumber = |place: &mut u32| *place = number(*place);
        for Code { from, to, .. } in &mut self.code {
            from.iter_mut().chain([to]).for_each(renumber);
        }
        for flop in &mut self.flops {
            let Flop {
                output,
                next,
                enable,
            } = flop;
            [output, next, enable].into_iter().for_each(renumber);
        }
        for store in &mut self.stores {
            let places = [&mut store.address, &mut store.output];
            store.write.iter_mut().chain(places).for_each(renumber);
        }
        let points = self.points.iter_mut().map(|(_, point)| &mut point.place);
        ports.iter_mut().chain(points).for_each(renumber);
    }

    /// Operations behind those whose results they read.
    pub(super) fn sorted(&self) -> Vec<Code> {
        let mut writer = vec![usize::MAX; self.words.len()];
        for (index, code) in self.code.iter().enumerate() {
            writer[code.to as usize] = index;
        }
        let mut order = Vec::with_capacity(self.code.len());
        // 0 not seen, 1 open, 2 done.
        let mut state = vec![0u8; self.code.len()];
        for start in 0..self.code.len() {
            let mut open = vec![start];
            while let Some(&index) = open.last() {
                if state[index] != 0 {
                    open.pop();
                    if state[index] == 1 {
                        state[index] = 2;
                        order.push(self.code[index]);
                    }
                    continue;
                }
                state[index] = 1;
                let code = self.code[index];
                for place in &code.from[..code.kind.reads()] {
                    let before = writer[*place as usize];
                    match state.get(before) {
                        Some(0) => open.push(before),
                        Some(1) => self.refuse_loop(self.code[before].to),
                        _ => {}
                    }
                }
            }
        }
        order
    }

    /// Leaves the operations that do not follow from constants alone; the words after the others.
    pub(super) fn without_constants(&mut self) -> Vec<[u64; 1]> {
        let mut words: Vec<[u64; 1]> = self.words.iter().map(|word| [*word]).collect();
        let mut is_constant = vec![false; words.len()];
        is_constant[ONE as usize] = true;
        for place in &self.literals {
            is_constant[*place as usize] = true;
        }
        self.code.retain(|code| {
            let mut reads = code.from[..code.kind.reads()].iter();
            let follows = reads.all(|place| is_constant[*place as usize]);
            if follows {
                code.kind.run(&[*code], &mut words);
                is_constant[code.to as usize] = true;
            }
            !follows
        });
        words
    }

    fn refuse_loop(&self, place: u32) -> ! {
        let found = self.described.iter().find(|(to, ..)| *to == place);
        match found {
            Some((_, module, net)) => refuse(format!(
                "{} depends on itself within one clock",
                described(module, *net)
            )),
            None => refuse("an output depends on itself within one clock".to_owned()),
        }
    }
}
