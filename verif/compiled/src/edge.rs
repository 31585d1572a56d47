//! The rising edge: what registers and memories take.
//!
//! What a register held is read before it is written, so the order of the registers is free; it decides how long words
//! live.

use crate::body::{Body, Place};
use crate::lanes::Lanes;
use crate::line::{Step, Two, Value};
use crate::size::Size;
use imogene_hdl::{Binary, Direction, Module, Net, Op};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// A register: its scope, and its number there.
type Flop = (usize, usize);

/// Fewer registers are no shorter to jump over than to do.
const FEW: usize = 3;

impl Body<'_> {
    /// All that a rising edge does: calls of what has a function of its own come last, for what it held is read before.
    /// In one lane these are not called from here, but behind it.
    pub(crate) fn update(&mut self, function: &dyn Fn(&Arc<Module>, Lanes) -> usize) {
        let (mut found, mut called) = (vec![0], vec![]);
        let mut next = 0;
        while let Some(&scope) = found.get(next) {
            next += 1;
            for (index, instance) in self.scopes[scope].module.instances.iter().enumerate() {
                if !instance.module.is_clocked() {
                    continue;
                }
                let part = self.part(scope, index);
                let own = &self.scopes[part];
                if self.layout.is_called(&instance.module) {
                    called.push(part);
                } else if own.is_own || own.spot.stride == 1 {
                    found.push(part);
                }
            }
            let own = &self.scopes[scope];
            if self.lanes == Lanes::One && own.rows.is_none() && own.is_own {
                let rows = self.layout.rows(own.spot.place);
                found.extend(rows.iter().map(|rows| self.rows(scope, *rows)));
            }
        }
        match self.lanes {
            Lanes::One => {
                self.hand_inputs_apart(&found);
                self.hand_inputs_side_by_side(&called);
            }
            _ => called.iter().for_each(|part| self.hand_inputs(*part)),
        }
        let owned: Vec<usize> = found
            .into_iter()
            .filter(|scope| self.scopes[*scope].is_own)
            .collect();
        for &scope in &owned {
            for index in 0..self.scopes[scope].module.memories.len() {
                self.memory(scope, index);
            }
        }
        self.registers(&owned);
        if self.lanes == Lanes::One {
            return;
        }
        for part in called {
            let own = &self.scopes[part];
            let function = function(own.module, self.lanes);
            self.to.add(Step::Call(function, own.spot.place));
        }
    }

    fn hand_inputs(&mut self, part: usize) {
        for input in 0..self.inputs(part) {
            let value = self.input(part, input);
            let place = self.at(part, self.block(part).input(input));
            self.to.add(Step::Store(value, place));
        }
    }

    /// Inputs of parts that run apart from the whole, and whether some are new.
    fn hand_inputs_apart(&mut self, found: &[usize]) {
        let layout = self.layout;
        for &part in found.iter().filter(|part| **part != 0) {
            let spot = self.scopes[part].spot;
            let Some(apart) = layout.apart(spot) else {
                continue;
            };
            let mut news = self.to.constant(Size::Whole, 0);
            for input in 0..self.inputs(part) {
                let value = self.input(part, input);
                let place = self.at(part, self.block(part).input(input));
                news = self.store_news(Step::Load(Size::Whole, place), value, place, news);
            }
            self.to.add(Step::Store(news, apart.news));
        }
    }

    /// Stores an input; with those before, the bits in which it is another than it was.
    fn store_news(&mut self, before: Step, value: Value, place: usize, news: Value) -> Value {
        let before = self.to.add(before);
        let differs = self.to.two(Two::Xor, before, value.read_as(Size::Whole));
        self.to.add(Step::Store(value, place));
        self.to.two(Two::Or, news, differs)
    }

    /// Inputs of parts that are in a group, of all its lanes at once, and whether some are new.
    fn hand_inputs_side_by_side(&mut self, called: &[usize]) {
        let (layout, own) = (self.layout, self.scopes[0].spot.place);
        for group in layout.groups_of(own) {
            let parts = called
                .iter()
                .copied()
                .filter(|part| self.scopes[*part].spot.place == group.place);
            let mut parts: Vec<usize> = parts.collect();
            parts.sort_by_key(|part| self.scopes[*part].spot.lane);
            let mut news = self.to.constant(Size::Whole, 0);
            for (input, port) in group.module.ports_of(Direction::In).enumerate() {
                let net = |lane: usize| (parts[lane.min(parts.len() - 1)], port.net);
                let place = self.at(parts[0], self.block(parts[0]).input(input));
                let (count, width) = (parts.len(), port.width);
                let words = match (count, group.lanes) {
                    (1, _) => vec![self.input(parts[0], input)],
                    (_, Lanes::Eight) => self.eight(std::array::from_fn(net), count, width),
                    _ => vec![self.four(std::array::from_fn(net), count, width)],
                };
                for (value, place) in words.into_iter().zip((place..).step_by(4)) {
                    let before = match count {
                        1 => Step::Load(Size::Whole, place),
                        _ => Step::LoadFour(place),
                    };
                    news = self.store_news(before, value, place, news);
                }
            }
            self.to.add(Step::Store(news, group.news));
        }
    }

    fn four(&mut self, nets: [Place; 4], count: usize, width: u32) -> Value {
        let word = self.side_by_side(nets, count, width);
        self.to.in_four(word.value)
    }

    /// The vectors of an input of eight parts, of which the first so many count.
    fn eight(&mut self, nets: [Place; 8], count: usize, width: u32) -> Vec<Value> {
        let size = Size::of(width, Lanes::Eight);
        if let (Size::Half, Some(from)) = (size, self.in_eight(&nets, count)) {
            return vec![self.to.add(Step::LoadFour(from))];
        }
        let first = self.four(std::array::from_fn(|lane| nets[lane]), 4, width);
        let last = self.four(std::array::from_fn(|lane| nets[lane + 4]), count - 4, width);
        match size {
            Size::Whole => vec![first, last],
            Size::Half => {
                let last = self.to.left(last, Size::Half.bits());
                vec![self.to.once(Step::Blend(first, last))]
            }
        }
    }

    fn inputs(&self, part: usize) -> usize {
        self.scopes[part].module.ports_of(Direction::In).count()
    }

    /// What an input of an instance gets.
    fn input(&mut self, part: usize, input: usize) -> Value {
        let (around, index) = self.scopes[part].around.expect("an instance");
        let net = self.scopes[around].module.instances[index].inputs[input];
        self.kept((around, net))
    }

    /// What all registers of these scopes take.
    fn registers(&mut self, owned: &[usize]) {
        let ordered = self.ordered(owned);
        for &(scope, index) in &ordered {
            // What it holds is read before any takes another word.
            let net = self.scopes[scope].module.registers[index].net;
            self.word((scope, net));
        }
        for &scope in owned {
            if let (Some(rows), None) = (self.scopes[scope].rows, self.scopes[scope].around) {
                let inputs = self.scopes[scope].module.ports_of(Direction::In);
                inputs.for_each(|port| _ = self.word((scope, port.net)));
                rows.into_iter().for_each(|row| self.read_registers(row));
            }
        }
        let (regions, others) = self.regions(&ordered);
        let moved = self.moved(&others);
        for at in others {
            match moved.get(&at) {
                None => self.register(at, None),
                Some(Some((words, place))) => _ = self.to.add(Step::Store(*words, *place)),
                Some(None) => {}
            }
        }
        for (enable, registers) in regions {
            let which = self.high(enable);
            self.only_if(which, |body| {
                for at in registers {
                    body.register(at, Some(enable));
                }
            });
        }
    }

    /// Registers that take what others hold, four at a time where both lie side by side: by the one that is the last to
    /// be written, the words of the others and where they go.
    fn moved(&mut self, registers: &[Flop]) -> HashMap<Flop, Option<(Value, usize)>> {
        let moves = registers.iter().enumerate();
        let moves = moves.filter_map(|(order, at)| Some((self.move_to(*at)?, (order, *at))));
        let mut moves: Vec<([usize; 2], (usize, Flop))> = moves.collect();
        moves.sort_unstable();
        let runs =
            moves.chunk_by(|(before, _), (places, _)| before.map(|place| place + 1) == *places);
        let mut moved = HashMap::new();
        for four in runs.flat_map(|run| run.rchunks_exact(4)) {
            let ([to, from], _) = four[0];
            let words = self.to.add(Step::LoadFour(from));
            let last = four.iter().map(|(_, register)| register).max();
            moved.extend(four.iter().map(|(_, (_, at))| (*at, None)));
            moved.extend(last.map(|(_, at)| (*at, Some((words, to)))));
        }
        moved
    }

    /// Where a register of one lane is that takes what another one holds, and that one.
    fn move_to(&mut self, (scope, index): Flop) -> Option<[usize; 2]> {
        let own = &self.scopes[scope];
        let register = &own.module.registers[index];
        let is_alone = self.lanes == Lanes::One && own.rows.is_none();
        if !is_alone || register.enable.is_some() {
            return None;
        }
        let (from, net) = self.origin((scope, register.next?));
        let Op::Register(source) = self.scopes[from].module.node(net).op else {
            return None;
        };
        let width = self.width((from, net));
        let place =
            |(scope, index)| self.whole_word(scope, self.block(scope).register(index), width);
        Some([place((scope, index))?, place((from, source))?])
    }

    /// What the registers of a scope hold, and of all parts in it.
    fn read_registers(&mut self, scope: usize) {
        let module = self.scopes[scope].module;
        for register in &module.registers {
            self.word((scope, register.net));
        }
        for (index, instance) in module.instances.iter().enumerate() {
            if instance.module.is_clocked() {
                let part = self.part(scope, index);
                self.read_registers(part);
            }
        }
    }

    /// Registers of which none takes a word unless the same net is 1, by this net, and the others.
    fn regions(&mut self, ordered: &[Flop]) -> (Vec<(Place, Vec<Flop>)>, Vec<Flop>) {
        let conditions: Vec<Vec<Place>> = ordered.iter().map(|at| self.conditions(*at)).collect();
        let mut count: HashMap<Place, usize> = HashMap::new();
        for condition in conditions.iter().flatten() {
            *count.entry(*condition).or_default() += 1;
        }
        let (mut regions, mut others): (Vec<(Place, Vec<Flop>)>, Vec<Flop>) = (vec![], vec![]);
        for (at, conditions) in ordered.iter().zip(&conditions) {
            let most = conditions.iter().max_by_key(|condition| count[condition]);
            let Some(enable) = most.filter(|condition| count[condition] >= FEW) else {
                others.push(*at);
                continue;
            };
            match regions.iter_mut().find(|(known, _)| known == enable) {
                Some((_, registers)) => registers.push(*at),
                None => regions.push((*enable, vec![*at])),
            }
        }
        (regions, others)
    }

    /// The nets that must be 1 for a register to take a word.
    fn conditions(&mut self, (scope, index): Flop) -> Vec<Place> {
        let register = &self.scopes[scope].module.registers[index];
        let mut open: Vec<Place> = register.enable.iter().map(|net| (scope, *net)).collect();
        let mut found = vec![];
        while let Some(at) = open.pop() {
            let at = self.origin(at);
            match self.scopes[at.0].module.node(at.1).op {
                Op::Binary(Binary::And, a, b) => open.extend([(at.0, a), (at.0, b)]),
                _ => found.push(at),
            }
        }
        found
    }

    /// What a register takes; `known` is 1 in some lane.
    fn register(&mut self, (scope, index): Flop, known: Option<Place>) {
        let module = self.scopes[scope].module;
        let place = self.at(scope, self.block(scope).register(index));
        let register = &module.registers[index];
        // It holds what it began with: nothing to store.
        let never = |net: Net| module.node(net).op == Op::Literal(0);
        if register.enable.is_some_and(never) {
            return;
        }
        let held = self.kept((scope, register.net));
        let next = register.next.expect("a closed module has all inputs");
        let mut next = self.kept((scope, next));
        if let Some(enable) = register.enable {
            let is_alone = self.lanes == Lanes::One && self.scopes[scope].rows.is_none();
            if !is_alone || known != Some(self.origin((scope, enable))) {
                let enable = self.high((scope, enable));
                next = self.to.select(enable, next, held);
            }
        }
        if self.scopes[scope].rows.is_some() {
            next = self.to.in_four(next);
        }
        self.to.add(Step::Store(next, place));
    }

    /// A memory reads before it writes.
    fn memory(&mut self, scope: usize, index: usize) {
        let module = self.scopes[scope].module;
        let place = self.at(scope, self.block(scope).memories[index]);
        let memory = &module.memories[index];
        // What was read before is wanted later.
        self.word((scope, memory.net));
        let [enable, at, data] = memory.write;
        let [address, at, data] =
            [memory.address, at, data].map(|net| self.zeros_to((scope, net), Size::Whole));
        let enable = self.high((scope, enable));
        let [words, nowhere] = [memory.words, memory.words + 1]
            .map(|count| self.to.constant(Size::Whole, count as u64));
        let read_at = self.index_or(address, words, words);
        let write_at = self.index_or(at, words, nowhere);
        let write_at = self.to.select(enable, write_at, nowhere);
        let lanes = self.lanes.count();
        let [read_at, write_at] = [read_at, write_at].map(|at| self.to.left(at, lanes.ilog2()));
        let first = place + lanes;
        let read = self.to.add(Step::Read(first, read_at));
        self.to.add(Step::Write(first, write_at, data));
        self.to.add(Step::Store(read, place));
    }

    /// An index below the number of words, or else another.
    fn index_or(&mut self, index: Value, words: Value, or: Value) -> Value {
        let is_there = self.to.two(Two::Greater, words, index);
        // An index of 64 bits is no number below zero.
        let is_number = self.to.select(index, or, index);
        self.to.select(is_there, is_number, or)
    }

    /// The registers of these scopes, those that read before those that are read, as far as they go in no ring.
    fn ordered(&mut self, scopes: &[usize]) -> Vec<Flop> {
        let mut seen: HashSet<Place> = HashSet::new();
        let mut order = vec![];
        for &scope in scopes {
            for register in &self.scopes[scope].module.registers {
                let mut open = vec![((scope, register.net), false)];
                while let Some((at, is_done)) = open.pop() {
                    let at = self.origin(at);
                    let own = &self.scopes[at.0];
                    let op = &own.module.node(at.1).op;
                    let register = match op {
                        Op::Register(index) if own.is_own => Some(*index),
                        _ => None,
                    };
                    if is_done {
                        order.extend(register.map(|index| (at.0, index)));
                    } else if seen.insert(at) {
                        open.push((at, true));
                        let reads = match register.map(|index| &own.module.registers[index]) {
                            Some(register) => {
                                register.next.into_iter().chain(register.enable).collect()
                            }
                            None => op.operands(),
                        };
                        open.extend(reads.into_iter().map(|net| ((at.0, net), false)));
                    }
                }
            }
        }
        order.reverse();
        order
    }
}
