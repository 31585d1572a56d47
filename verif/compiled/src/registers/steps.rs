//! The instructions of each step.

use super::{Home, Writer, input_at};
use crate::assemble::{
    BLOCK, GIVEN, LEFT, LOAD_INDEX, LOAD_SCALAR, LOAD_WHERE, LOOKUP, Operand, PAIR, READ,
    REGISTERS, RIGHT, SELECT_BY_MASK, STORE_SCALAR, WRITE,
};
use crate::lanes::MOST_LANES;
use crate::line::{Step, Value};
use crate::size::Size;

impl Writer<'_> {
    pub(super) fn step(&mut self, index: usize, step: &Step, begins: &[usize]) {
        let value = Value(index as u32, step.size());
        if step.is_pure() && self.uses[index].is_empty() {
            return;
        }
        self.is_busy = [false; REGISTERS];
        self.free.append(&mut self.freed);
        self.to.lanes = self.lanes[index];
        match *step {
            Step::Constant(_, words) => {
                self.home[index] = Some(Home::Constant(self.constants.index(words)));
            }
            Step::Gather([a, b, c, d]) if [b, c, d] == [a; 3] => {
                let from = self.fetch(a);
                let into = self.result(index, step);
                let from = Operand::Register(from);
                self.to.spread(Size::Whole, into, from);
            }
            Step::Gather([a, b, c, d]) => {
                self.keep(step);
                let [a, c] = [a, c].map(|value| self.fetch(value));
                let [b, d] = [b, d].map(|value| self.operand(value));
                // Into what nothing lies in, since the pairs are there before all is read.
                let [pair, into] = [self.take(), self.take()];
                self.to.vex(PAIR, false, pair, a, b);
                self.to.vex(PAIR, false, into, c, d);
                self.to.halves(into, pair, into);
                self.release(index, step);
                self.hold(into, value);
            }
            Step::Input(size, input) => {
                self.home[index] = Some(Home::Input(size, input));
            }
            Step::Row(lane, first, 4) => self.home[index] = Some(Home::Row(lane, first)),
            Step::Row(lane, first, count) => {
                let words = std::array::from_fn(|word| if word < count { u64::MAX } else { 0 });
                let words = Home::Constant(self.constants.index(words));
                let words = self.place(words);
                let [mask, into] = [self.take(), self.take()];
                self.to.load(mask, words);
                (self.to).vex(LOAD_WHERE, true, into, mask, input_at(lane, first));
                self.hold(into, value);
            }
            Step::Shuffle(how, a, b) => {
                self.keep(step);
                let (a, b) = (self.fetch(a), self.operand(b));
                let into = self.result(index, step);
                self.to.shuffle(how, into, a, b);
            }
            Step::Patch(first, others) => {
                self.keep(step);
                let (others, first) = (self.fetch(others), self.fetch(first));
                let into = self.result(index, step);
                (self.to).blend(into, others, Operand::Register(first), 0b11);
            }
            Step::Blend(low, high) => {
                self.keep(step);
                let (low, high) = (self.fetch(low), self.operand(high));
                let into = self.result(index, step);
                self.to.blend(into, low, high, 0b1010_1010);
            }
            Step::Load(_, place) | Step::LoadFour(place) => {
                self.home[index] = Some(Home::State(place));
                self.loaded.entry(place).or_default().push(value);
            }
            Step::Two(how, a, b) => {
                let is_better = self.register_of(a).is_none() && self.register_of(b).is_some();
                let (a, b) = match how.commutes() && is_better {
                    true => (b, a),
                    false => (a, b),
                };
                self.keep(step);
                let (from, other) = (self.fetch(a), self.operand(b));
                let into = self.result(index, step);
                self.to.two(how, a.1, into, from, other);
            }
            Step::Left(a, count) | Step::Right(a, count) => {
                let way = if matches!(step, Step::Left(..)) {
                    LEFT
                } else {
                    RIGHT
                };
                let from = self.fetch(a);
                let into = self.result(index, step);
                self.to.shift(way, a.1, into, from, count);
            }
            Step::Select(which, then, or) => {
                self.keep(step);
                let size = then.1;
                let has_masks = self.to.has_masks && size == Size::Whole;
                let mask = has_masks.then(|| self.mask(which));
                let which = mask.unwrap_or_else(|| self.fetch(which));
                let (or, then) = (self.fetch(or), self.operand(then));
                let into = self.result(index, step);
                match mask {
                    Some(mask) => self.to.evex(SELECT_BY_MASK, into, or, then, mask),
                    None => self.to.select(size, into, which, then, or),
                }
            }
            Step::Lookup(table, at) => {
                let table = Home::Constant(self.constants.index(table));
                let (from, table) = (self.fetch(at), self.place(table));
                let into = self.result(index, step);
                self.to.vex(LOOKUP, true, into, from, table);
            }
            Step::Read(place, at) => self.read(index, step, place, at),
            Step::Write(place, at, word) => {
                self.keep(step);
                for (slot, value) in [at, word].into_iter().enumerate() {
                    let from = self.fetch(value);
                    self.to.store(from, self.spill_at(slot));
                }
                for lane in 0..self.to.lanes.count() {
                    self.to.general(LOAD_INDEX, self.bytes(0, lane));
                    self.to.general(LOAD_SCALAR, self.bytes(1, lane));
                    self.to.general(WRITE, 8 * (place + lane) as i32);
                }
                self.release(index, step);
            }
            Step::Store(from, place) => self.store(index, step, from, place),
            Step::Give(value, place) => {
                let from = self.fetch(value);
                let to = Operand::Memory(GIVEN, 8 * place as i32);
                self.to.store_words(self.lanes[index], from, to);
                self.release(index, step);
            }
            Step::Call(function, place) => self.to.call(begins[function], 8 * place as i32),
            Step::OnlyIf(..) => unreachable!("it looks at the steps behind it"),
            Step::Widen(..) | Step::Narrow(..) => unreachable!("it was split"),
        }
    }

    /// Ends what is only done if, when its steps are over: whether they were done or not, all lies in its home.
    pub(super) fn come_to(&mut self, index: usize) {
        let Some((jump, _)) = self.jump.filter(|(_, end)| *end == index) else {
            return;
        };
        self.jump = None;
        self.to.land(jump);
        self.masks.clear();
        for register in &mut self.held {
            if let Some(value) = register.take() {
                self.register[value.0 as usize] = None;
            }
        }
    }

    /// Jumps over the steps behind `index`, the last of which are handed over, unless a bit is 1.
    pub(super) fn only_if(&mut self, index: usize, which: Value, steps: &[Step]) {
        self.is_busy = [false; REGISTERS];
        self.free.append(&mut self.freed);
        self.to.lanes = self.lanes[index];
        let register = self.fetch(which);
        let end = steps.len();
        let is_wanted = |writer: &Self, value: Value| {
            let last = writer.uses[value.0 as usize].first();
            last.is_some_and(|last| *last >= end)
        };
        for step in &steps[index + 1..] {
            let Step::Store(value, place) = *step else {
                continue;
            };
            for (place, loaded) in self.loaded_at(place, value) {
                if is_wanted(self, loaded) {
                    self.move_home(loaded, Some(Home::State(place)));
                }
            }
        }
        for held in self.held.into_iter().flatten() {
            if is_wanted(self, held) {
                self.move_home(held, None);
            }
        }
        let jump = self.to.jump_unless(which.1, register);
        self.jump = Some((jump, end));
        self.release(index, &steps[index]);
    }

    /// Spills a value whose home is this.
    fn move_home(&mut self, value: Value, from: Option<Home>) {
        if self.home[value.0 as usize] == from {
            let busy = self.is_busy;
            let register = self.fetch(value) as usize;
            self.home[value.0 as usize] = None;
            self.spill(register, value.0 as usize);
            self.is_busy = busy;
        }
    }

    /// Word by word: there is no better way without AVX-512.
    fn read(&mut self, index: usize, step: &Step, place: usize, at: Value) {
        let from = self.fetch(at);
        self.to.store(from, self.spill_at(0));
        for lane in 0..self.to.lanes.count() {
            self.to.general(LOAD_INDEX, self.bytes(0, lane));
            self.to.general(READ, 8 * (place + lane) as i32);
            self.to.general(STORE_SCALAR, self.bytes(1, lane));
        }
        let into = self.result(index, step);
        let from = self.spill_at(1);
        self.to.load_words(self.lanes[index], into, from);
    }

    /// The values that were loaded from places to which this one is stored.
    fn loaded_at(&self, place: usize, stored: Value) -> Vec<(usize, Value)> {
        let words = |value: Value| self.lanes[value.0 as usize].count();
        let most = MOST_LANES - 1;
        let places = place.saturating_sub(most)..place + words(stored);
        let loaded = self.loaded.range(places);
        let loaded = loaded.flat_map(|(place, values)| values.iter().map(move |v| (*place, *v)));
        let reaching = loaded.filter(|(begin, loaded)| begin + words(*loaded) > place);
        reaching.collect()
    }

    fn store(&mut self, index: usize, step: &Step, value: Value, place: usize) {
        let from = self.fetch(value);
        // What was loaded from there and is wanted yet lies there no longer.
        for (begin, loaded) in self.loaded_at(place, value) {
            let is_there = self.home[loaded.0 as usize] == Some(Home::State(begin));
            let is_the_same = (begin, loaded.0) == (place, value.0);
            if is_there && !is_the_same && !self.uses[loaded.0 as usize].is_empty() {
                self.fetch(loaded);
                self.home[loaded.0 as usize] = None;
            }
        }
        let to = Operand::Memory(BLOCK, 8 * place as i32);
        self.to.store_words(self.lanes[index], from, to);
        self.home[value.0 as usize].get_or_insert(Home::State(place));
        self.release(index, step);
    }
}
