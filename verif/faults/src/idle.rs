//! What a circuit is before its work begins, and what is left of that once the work began.

use crate::frame::{Begin, CONTROL, End, Word, constant};
use crate::gates::{Bit, Gates, NO};
use imogene_hdl::Levels;
use rayon::prelude::*;
use std::collections::HashSet;
use std::sync::Arc;

/// Gates of all clocks of all beginnings that are looked at, at most.
const GATES: usize = 400_000_000;

/// The value of each bit of each register that never changes.
pub(crate) type Constants = Vec<Vec<Option<bool>>>;

/// Bits of registers; behind the registers are the memories, of which all that is read counts as one bit.
type Bits = HashSet<(usize, usize)>;

/// Gives the bits that never change their values; `registers` are those without controls.
pub(crate) fn fix(constants: &Constants, begin: &mut Begin, registers: &[usize]) {
    for (register, constants) in registers.iter().zip(constants) {
        let bits = begin.register_mut(*register).iter_mut();
        for (bit, constant) in bits.zip(constants) {
            *bit = constant.map_or(*bit, Bit::of);
        }
    }
}

/// How the work of a circuit begins.
#[derive(Clone, Default)]
pub(crate) struct Idle {
    /// Inputs that are 0 before.
    pub(crate) quiet: Vec<usize>,
    /// Inputs that have these words in the clocks with which it begins, one after the other.
    pub(crate) begins: Vec<Vec<(usize, u64)>>,
    /// Bits of registers that do not change before. Registers are counted without controls.
    pub(crate) constants: Constants,
}

impl Idle {
    /// What never changes from power-up on while these inputs are quiet: all that is held at power-up but for what one
    /// clock may change, until there is none.
    pub(crate) fn of(levels: &Arc<Levels>, zeros: &[(usize, u32)], quiet: &[usize]) -> Idle {
        let registers: Vec<usize> = (0..levels.flops.len()).collect();
        let mut idle = Idle {
            quiet: quiet.to_vec(),
            constants: initial(levels),
            ..Idle::default()
        };
        loop {
            let mut gates = Gates::new();
            let mut begin = Begin::any(levels, &mut gates);
            for (index, bit) in zeros {
                begin.input_mut(*index)[*bit as usize] = NO;
            }
            let end = idle.begin(begin, &registers).clock(&mut gates).end;
            if !idle.drop_changing(&end, &registers) {
                return idle;
            }
        }
    }

    /// The state before the work, with no input but those that are free; `registers` are those without controls.
    pub(crate) fn begin(&self, mut begin: Begin, registers: &[usize]) -> Begin {
        fix(&self.constants, &mut begin, registers);
        self.hush(&mut begin);
        begin
    }

    /// Drops what is not so after a clock. Was there any?
    pub(crate) fn drop_changing(&mut self, end: &End, registers: &[usize]) -> bool {
        let mut is_dropped = false;
        for (register, constants) in registers.iter().zip(&mut self.constants) {
            for (constant, next) in constants.iter_mut().zip(&end.registers[*register]) {
                if constant.is_some_and(|value| *next != Bit::of(value)) {
                    *constant = None;
                    is_dropped = true;
                }
            }
        }
        is_dropped
    }

    /// The same with nothing known of registers that hold data, not control.
    pub(crate) fn of_control(&self) -> Idle {
        let mut own = self.clone();
        let long = own.constants.iter_mut();
        let long = long.filter(|constants| constants.len() > CONTROL as usize);
        long.for_each(|constants| constants.fill(None));
        own
    }

    /// Makes the inputs 0 that are so before the work.
    fn hush(&self, begin: &mut Begin) {
        for input in &self.quiet {
            *begin.input_mut(*input) = constant(0);
        }
    }

    /// Gives inputs their words in a clock of the beginning; those that were quiet before are so without one.
    pub(crate) fn fix(&self, clock: usize, begin: &mut Begin) {
        let Some(words) = self.begins.get(clock) else {
            return;
        };
        self.hush(begin);
        for (input, word) in words {
            *begin.input_mut(*input) = constant(*word);
        }
    }

    /// Those of some registers of which what they hold at power-up has no meaning: two circuits that differ in it alone
    /// hold the same once the work began and the latency passed. Of all of them at once, then of halves where not.
    pub(crate) fn forgotten(
        &self,
        levels: &Arc<Levels>,
        registers: Vec<usize>,
        latency: usize,
    ) -> Vec<usize> {
        let clocks = self.begins.len() + latency.max(1) - 1;
        let mut left = match self.begins.is_empty() || registers.is_empty() {
            true => 0,
            false => GATES / (clocks * levels.code.len() * 16).max(1),
        };
        let (mut open, mut forgotten) = (vec![registers], vec![]);
        while !open.is_empty() {
            open.truncate(left);
            left -= open.len();
            let is_forgotten = open.par_iter().map(|registers| {
                let differs = self.spread(levels, bits(levels, registers));
                differs.is_some_and(|differs| self.is_gone(levels, &differs, clocks))
            });
            let is_forgotten: Vec<bool> = is_forgotten.collect();
            let mut halves = vec![];
            for (mut registers, is_forgotten) in open.into_iter().zip(is_forgotten) {
                if is_forgotten {
                    forgotten.extend(registers);
                } else if registers.len() > 1 {
                    halves.push(registers.split_off(registers.len() / 2));
                    halves.push(registers);
                }
            }
            open = halves;
        }
        forgotten
    }

    /// What differs before the work if these bits do; `None` if that is written into a memory.
    fn spread(&self, levels: &Arc<Levels>, mut differs: Bits) -> Option<Bits> {
        loop {
            let mut gates = Gates::new();
            let (begin, sources) = self.differing(levels, &differs, &mut gates);
            let clock = begin.clock(&mut gates);
            let depends = gates.depending(&sources);
            if clock.written().any(|bit| depends[bit.gate()]) {
                return None;
            }
            let before = differs.len();
            for (memory, address) in clock.read().enumerate() {
                if is_any(address, &depends) {
                    differs.insert((levels.flops.len() + memory, 0));
                }
            }
            for (register, word) in clock.end.registers.iter().enumerate() {
                let bits = word.iter().enumerate();
                let reached = bits.filter(|(_, bit)| depends[bit.gate()]);
                differs.extend(reached.map(|(place, _)| (register, place)));
            }
            if differs.len() == before {
                return Some(differs);
            }
        }
    }

    /// Is a difference of these bits gone after the clocks of the beginning and those after it?
    fn is_gone(&self, levels: &Arc<Levels>, differs: &Bits, clocks: usize) -> bool {
        let mut gates = Gates::new();
        let (mut begin, mut sources) = self.differing(levels, differs, &mut gates);
        let mut kept: Vec<Bit> = vec![];
        for index in 0..clocks {
            self.fix(index, &mut begin);
            let clock = begin.clock(&mut gates);
            kept.extend(clock.written());
            if index + 1 == clocks {
                kept.extend(clock.end.registers.iter().flatten());
                kept.extend(clock.read().flatten());
            }
            begin = begin.after(&clock.end, &mut gates);
            // What is read where the addresses differ.
            let depends = gates.depending(&sources);
            for (store, address) in levels.stores.iter().zip(clock.read()) {
                if is_any(address, &depends) {
                    sources.extend(begin.at(store.output).iter().map(|bit| bit.gate()));
                }
            }
        }
        let depends = gates.depending(&sources);
        kept.iter().all(|bit| !depends[bit.gate()])
    }

    /// A clock before the work in which these bits may be anything, and the gates of these bits.
    fn differing(
        &self,
        levels: &Arc<Levels>,
        differs: &Bits,
        gates: &mut Gates,
    ) -> (Begin, Vec<usize>) {
        let any = Begin::any(levels, gates);
        let registers: Vec<usize> = (0..levels.flops.len()).collect();
        let mut begin = self.begin(any.clone(), &registers);
        let mut sources = vec![];
        for (register, place) in differs {
            match register.checked_sub(levels.flops.len()) {
                Some(memory) => {
                    let read = begin.at(levels.stores[memory].output);
                    sources.extend(read.iter().map(|bit| bit.gate()));
                }
                None => {
                    let bit = any.register(*register)[*place];
                    begin.register_mut(*register)[*place] = bit;
                    sources.push(bit.gate());
                }
            }
        }
        (begin, sources)
    }
}

/// All bits of some registers.
fn bits(levels: &Levels, registers: &[usize]) -> Bits {
    let of = |register: &usize| {
        let register = *register;
        let bits = 0..levels.flops[register].width as usize;
        bits.map(move |bit| (register, bit))
    };
    registers.iter().flat_map(of).collect()
}

/// Does a bit of a word depend on something?
fn is_any(word: &Word, depends: &[bool]) -> bool {
    word.iter().any(|bit| depends[bit.gate()])
}

/// What every register holds at power-up.
fn initial(levels: &Levels) -> Constants {
    let flops = levels.flops.iter().map(|flop| {
        let word = levels.words[flop.output as usize];
        let bits = (0..flop.width).map(|bit| Some(word >> bit & 1 == 1));
        bits.collect()
    });
    flops.collect()
}
