//! The steps of a line in registers: straight-line code, so what is wanted last leaves first (Belady's rule).

use crate::assemble::{
    Assembler, BLOCK, CONSTANTS, GIVEN, LEFT, LOAD_INDEX, LOAD_SCALAR, LOAD_WHERE, MASKS, Operand,
    PAIR, READ, REGISTERS, RIGHT, ROWS, SELECT_BY_MASK, SPILLED, STORE_SCALAR, TO_MASK, WRITE,
};
use crate::layout::{Lanes, MOST_LANES};
use crate::line::{Line, Step, Value};
use crate::size::Size;
use std::collections::{BTreeMap, HashMap};

/// Vectors in front of those that are spilled: what goes to and comes from memories word by word.
const PASSING: usize = 2;

/// Words that a value moves away from its register cost nothing if they lie elsewhere too.
const CHEAPER: usize = 40;

/// Where a value lies besides in a register.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Home {
    Constant(usize),
    /// In the block, at this word.
    State(usize),
    /// In the row of all lanes.
    Input(Size, usize),
    /// In the row of a lane, from an input on.
    Row(usize, usize),
    Spilled(usize),
}

/// The constants of a program, each once.
#[derive(Default)]
pub(crate) struct Constants {
    pub(crate) words: Vec<[u64; 4]>,
    known: HashMap<[u64; 4], usize>,
}

impl Constants {
    fn index(&mut self, words: [u64; 4]) -> usize {
        *self.known.entry(words).or_insert_with(|| {
            self.words.push(words);
            self.words.len() - 1
        })
    }
}

fn input_at(lane: usize, input: usize) -> Operand {
    Operand::Memory(ROWS + lane as u8, 8 * input as i32)
}

/// Writes the instructions of a line; gives how many vectors it spills to. `begins` are the functions that it may call.
pub(crate) fn write(
    line: &Line,
    to: &mut Assembler,
    constants: &mut Constants,
    begins: &[usize],
) -> usize {
    let count = line.steps.len();
    let (lanes, of_four) = (to.lanes, line.of_four());
    let lanes_of = |is_four: bool| if is_four { Lanes::Four } else { lanes };
    let mut writer = Writer {
        lanes: of_four.into_iter().map(lanes_of).collect(),
        to,
        constants,
        register: vec![None; count],
        home: vec![None; count],
        uses: uses(&line.steps),
        held: [None; REGISTERS],
        is_busy: [false; REGISTERS],
        loaded: BTreeMap::new(),
        masks: vec![],
        free: vec![],
        freed: vec![],
        spilled: PASSING,
        jump: None,
    };
    for (index, step) in line.steps.iter().enumerate() {
        writer.come_to(index);
        match *step {
            Step::OnlyIf(which, end) => writer.only_if(index, which, &line.steps[..end]),
            _ => writer.step(index, step, begins),
        }
    }
    writer.come_to(count);
    writer.spilled
}

/// The steps that read each value, the last first; a step that nothing needs reads none.
fn uses(steps: &[Step]) -> Vec<Vec<usize>> {
    let mut uses: Vec<Vec<usize>> = vec![vec![]; steps.len()];
    for (index, step) in steps.iter().enumerate().rev() {
        if !step.is_pure() || !uses[index].is_empty() {
            step.reads()
                .for_each(|value| uses[value.0 as usize].push(index));
        }
    }
    uses
}

struct Writer<'a> {
    to: &'a mut Assembler,
    constants: &'a mut Constants,
    /// Of each value.
    lanes: Vec<Lanes>,
    register: Vec<Option<u8>>,
    home: Vec<Option<Home>>,
    uses: Vec<Vec<usize>>,
    /// By each register.
    held: [Option<Value>; REGISTERS],
    /// This step needs what the register holds.
    is_busy: [bool; REGISTERS],
    /// The values that were loaded from a word of the block on, of one lane and of four.
    loaded: BTreeMap<usize, Vec<Value>>,
    /// The values whose top bits are in masks, the one that was found last in front.
    masks: Vec<(Value, u8)>,
    /// Spilled vectors that may be taken; those that were freed in this step may be read by it yet.
    free: Vec<usize>,
    freed: Vec<usize>,
    spilled: usize,
    /// Where a jump over the steps up to one is, and that step.
    jump: Option<(usize, usize)>,
}

impl Writer<'_> {
    fn step(&mut self, index: usize, step: &Step, begins: &[usize]) {
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
    fn come_to(&mut self, index: usize) {
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
    fn only_if(&mut self, index: usize, which: Value, steps: &[Step]) {
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

    /// The mask of a value's top bits, the one that was found first if all are taken.
    fn mask(&mut self, which: Value) -> u8 {
        if let Some((_, mask)) = self.masks.iter().find(|(value, _)| *value == which) {
            return *mask;
        }
        let mask = match self.masks.len() {
            MASKS => self.masks.pop().expect("there are some").1,
            taken => taken as u8 + 1,
        };
        let register = self.fetch(which);
        self.to
            .evex(TO_MASK, mask, 0, Operand::Register(register), 0);
        self.masks.insert(0, (which, mask));
        mask
    }

    fn register_of(&self, value: Value) -> Option<u8> {
        self.register[value.0 as usize]
    }

    /// Of a vector that is spilled, and a word in it.
    fn bytes(&self, slot: usize, lane: usize) -> i32 {
        (32 * slot + 8 * lane) as i32
    }

    fn spill_at(&self, slot: usize) -> Operand {
        Operand::Memory(SPILLED, self.bytes(slot, 0))
    }

    fn place(&self, home: Home) -> Operand {
        match home {
            Home::Constant(index) => Operand::Memory(CONSTANTS, (32 * index) as i32),
            Home::State(place) => Operand::Memory(BLOCK, 8 * place as i32),
            Home::Input(_, input) => input_at(0, input),
            Home::Row(lane, first) => input_at(lane, first),
            Home::Spilled(slot) => self.spill_at(slot),
        }
    }

    /// What a step reads stays where it is until the step is done.
    fn keep(&mut self, step: &Step) {
        for value in step.reads() {
            if let Some(register) = self.register_of(value) {
                self.is_busy[register as usize] = true;
            }
        }
    }

    /// A value in a register.
    fn fetch(&mut self, value: Value) -> u8 {
        if let Some(register) = self.register_of(value) {
            self.is_busy[register as usize] = true;
            return register;
        }
        let register = self.take();
        let home = self.home[value.0 as usize].expect("a value lies somewhere");
        let from = self.place(home);
        match home {
            Home::Input(size, _) if self.lanes[value.0 as usize] == Lanes::Four => {
                self.to.spread(size, register, from);
            }
            // A vector across two words that were stored one by one would wait for both.
            Home::State(_) | Home::Input(..) => {
                (self.to).load_words(self.lanes[value.0 as usize], register, from);
            }
            _ => self.to.load(register, from),
        }
        self.hold(register, value);
        register
    }

    fn hold(&mut self, register: u8, value: Value) {
        self.register[value.0 as usize] = Some(register);
        self.held[register as usize] = Some(value);
    }

    /// A value where it lies, if that is as good: a constant, or what is not wanted again.
    fn operand(&mut self, value: Value) -> Operand {
        let home = self.home[value.0 as usize];
        let lanes = self.lanes[value.0 as usize];
        let is_last = self.uses[value.0 as usize].len() == 1;
        match (self.register_of(value), home) {
            (None, Some(home @ Home::Constant(_))) => self.place(home),
            (None, Some(home @ Home::Spilled(_))) if is_last => self.place(home),
            // Into every lane there is no way from memory alone but of AVX-512.
            (None, Some(Home::Input(..))) if lanes == Lanes::Four => {
                Operand::Register(self.fetch(value))
            }
            (None, Some(home)) if is_last && lanes != Lanes::One => self.place(home),
            _ => Operand::Register(self.fetch(value)),
        }
    }

    /// A register for anything, which is busy from now on.
    fn take(&mut self) -> u8 {
        let all = 0..REGISTERS;
        let free = (all.clone()).find(|r| self.held[*r].is_none() && !self.is_busy[*r]);
        let register = free.unwrap_or_else(|| {
            let others = all.filter(|register| !self.is_busy[*register]);
            let last = others.max_by_key(|register| self.next_use(*register));
            let register = last.expect("a step reads less than there is");
            let value = self.held[register].take().expect("it holds a value").0 as usize;
            self.register[value] = None;
            self.spill(register, value);
            register
        });
        self.is_busy[register] = true;
        register as u8
    }

    /// How long what a register holds is not wanted.
    fn next_use(&self, register: usize) -> usize {
        let value = self.held[register].expect("no register is free").0 as usize;
        let next = *self.uses[value].last().expect("what is held is wanted");
        match self.home[value] {
            Some(_) => next + CHEAPER,
            None => next,
        }
    }

    /// Gives the value in a register a home if it has none.
    fn spill(&mut self, register: usize, value: usize) {
        if self.home[value].is_none() {
            let slot = self.free.pop().unwrap_or_else(|| {
                self.spilled += 1;
                self.spilled - 1
            });
            self.home[value] = Some(Home::Spilled(slot));
            self.to.store(register as u8, self.spill_at(slot));
        }
    }

    /// The register of a step's result, which may be that of what it reads for the last time.
    fn result(&mut self, index: usize, step: &Step) -> u8 {
        self.release(index, step);
        let register = self.take();
        self.hold(register, Value(index as u32, step.size()));
        register
    }

    /// The step is done with what it reads.
    fn release(&mut self, index: usize, step: &Step) {
        for value in step.reads() {
            let value = value.0 as usize;
            let uses = &mut self.uses[value];
            while uses.last() == Some(&index) {
                uses.pop();
            }
            if !uses.is_empty() {
                continue;
            }
            if let Some(register) = self.register[value].take() {
                self.held[register as usize] = None;
                self.is_busy[register as usize] = false;
            }
            if let Some(Home::Spilled(slot)) = self.home[value].take() {
                self.freed.push(slot);
            }
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
