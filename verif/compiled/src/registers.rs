//! The steps of a line in registers: straight-line code, so what is wanted last leaves first (Belady's rule).

mod steps;

use crate::assemble::{
    Assembler, BLOCK, CONSTANTS, MASKS, Operand, REGISTERS, ROWS, SPILLED, TO_MASK,
};
use crate::lanes::Lanes;
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
            // Into every lane there is no way from memory alone.
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
}
