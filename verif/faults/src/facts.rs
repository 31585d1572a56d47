//! Facts of the states that a circuit comes to: guessed from some of these states, proven by induction.
//!
//! A counter ends at its last value, and two flags are never 1 together. Without such facts a proof over one clock
//! fails in states that are never reached.

use crate::frame::{CONTROL, Reached, Word, bit_of, constant, less};
use crate::gates::{Bit, Gates, NO, YES};
use crate::solve::{CONFLICTS, possible};
use imogene_hdl::Levels;
use std::collections::HashMap;

/// Bits of flags and short registers of all modules, at most: their pairs grow with the square.
const BITS: usize = 64;

/// Gates of a clock, at most: beyond, the proofs take minutes.
const GATES: usize = 60_000;

/// A bit of a register at a value. Registers are counted without controls.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Literal {
    register: usize,
    bit: u32,
    value: bool,
}

impl Literal {
    fn is<'a>(self, word: &impl Fn(usize) -> &'a Word) -> Bit {
        let bit = bit_of(word(self.register), self.bit);
        if self.value { bit } else { !bit }
    }

    fn is_in(self, state: &[u64]) -> bool {
        (state[self.register] >> self.bit & 1 == 1) == self.value
    }
}

/// What holds in every state.
#[derive(Clone)]
pub(crate) enum Fact {
    /// A register is at most this, always or where a flag has a value.
    AtMost(usize, u64, Option<Literal>),
    /// Two bits, which may be the same one, are never at these values together.
    Apart([Literal; 2]),
}

impl Fact {
    /// Does it hold, where registers hold these words?
    pub(crate) fn holds<'a>(&self, gates: &mut Gates, word: impl Fn(usize) -> &'a Word) -> Bit {
        match self {
            Fact::AtMost(register, greatest, flag) => {
                let (found, greatest) = (word(*register), constant(*greatest));
                let width = found.len().max(greatest.len()) as u32;
                let is_more = less(gates, &greatest, found, width);
                let is_so = flag.map_or(YES, |flag| flag.is(&word));
                !gates.and(is_so, is_more)
            }
            Fact::Apart(pair) => {
                let [a, b] = pair.map(|literal| literal.is(&word));
                !gates.and(a, b)
            }
        }
    }
}

/// The facts that hold in all of these states and at power-up, and are proven to hold after a clock before which they
/// and what else is known hold.
pub(crate) fn facts(mut of: Reached, seen: &[Vec<u64>]) -> Vec<Fact> {
    let levels = &of.begin.levels.clone();
    if of.gates.len() > GATES {
        return vec![];
    }
    let flops = levels.flops.iter();
    let initial = flops.map(|flop| levels.words[flop.output as usize]);
    let states: Vec<Vec<u64>> = seen.iter().cloned().chain([initial.collect()]).collect();
    let never = never(levels, &states);
    let pairs = pairs(levels, &states);
    let all = [greatest(levels, &states), never.clone(), pairs].concat();
    let mut proven = [all, never].into_iter().map(|facts| proven(&mut of, facts));
    proven.find_map(|facts| facts).unwrap_or_default()
}

/// Those of some facts that are proven; `None` if they are too much for the solver.
fn proven(of: &mut Reached, mut facts: Vec<Fact>) -> Option<Vec<Fact>> {
    loop {
        let before = |register: usize| of.begin.register(register);
        let assumed = facts.iter().map(|fact| fact.holds(&mut of.gates, before));
        let assumed: Vec<Bit> = assumed.chain(of.assumed.iter().copied()).collect();
        let after = |register: usize| &of.clock.end.registers[register];
        let broken = facts.iter().map(|fact| !fact.holds(&mut of.gates, after));
        let broken: Vec<Bit> = broken.collect();
        let is_broken = possible(&of.gates, CONFLICTS, NO, &broken, &assumed)?;
        if !is_broken.contains(&true) {
            return Some(facts);
        }
        let mut is_broken = is_broken.into_iter();
        facts.retain(|_| is_broken.next() == Some(false));
    }
}

/// The greatest word seen of each register where that is less than is possible, and where a flag has a value if that is
/// less.
fn greatest(levels: &Levels, states: &[Vec<u64>]) -> Vec<Fact> {
    let flags = literals(levels, 1, BITS);
    let mut facts = vec![];
    for (register, flop) in levels.flops.iter().enumerate() {
        let of = |is: &dyn Fn(&[u64]) -> bool| {
            let states = states.iter().filter(|state| is(state));
            states.map(|state| state[register]).max()
        };
        let Some(greatest) = of(&|_| true) else {
            continue;
        };
        if greatest < u64::MAX >> (64 - flop.width) {
            facts.push(Fact::AtMost(register, greatest, None));
        }
        facts.extend(flags.iter().filter_map(|flag| {
            let there = of(&|state| flag.is_in(state)).filter(|there| *there < greatest)?;
            Some(Fact::AtMost(register, there, Some(*flag)))
        }));
    }
    facts
}

/// Values at which bits of registers were never seen.
fn never(levels: &Levels, states: &[Vec<u64>]) -> Vec<Fact> {
    let literals = literals(levels, 64, usize::MAX).into_iter();
    let never = literals.filter(|literal| !states.iter().any(|state| literal.is_in(state)));
    never.map(|literal| Fact::Apart([literal; 2])).collect()
}

/// Pairs of bits of short registers, the first ones of all or two of one module, at values at which they were never
/// seen together.
fn pairs(levels: &Levels, states: &[Vec<u64>]) -> Vec<Fact> {
    let names = levels.points.iter();
    let names = names.map(|(name, point)| (point.place, name.rsplit_once('.')));
    let names: HashMap<u32, Option<(&str, &str)>> = names.collect();
    let module = |literal: &Literal| {
        let name = names.get(&levels.flops[literal.register].output);
        Some(name.copied().flatten()?.0)
    };
    let literals = literals(levels, CONTROL, usize::MAX);
    let modules: Vec<Option<&str>> = literals.iter().map(module).collect();
    let mut facts = vec![];
    for (index, a) in literals.iter().enumerate() {
        let is_near = |b: &usize| {
            *b < 2 * BITS || (modules[index].is_some() && modules[index] == modules[*b])
        };
        let others = (index + 1..literals.len()).filter(is_near);
        let others = others.map(|b| &literals[b]);
        let others = others.filter(|b| (a.register, a.bit) != (b.register, b.bit));
        let is_seen = |b: &Literal| states.iter().any(|state| a.is_in(state) && b.is_in(state));
        let apart = others.filter(|b| !is_seen(b));
        facts.extend(apart.map(|b| Fact::Apart([*a, *b])));
    }
    facts
}

/// Both values of so many bits of registers that are at most so long.
fn literals(levels: &Levels, longest: u32, count: usize) -> Vec<Literal> {
    let flops = levels.flops.iter().enumerate();
    let bits = flops.filter(|(_, flop)| flop.width <= longest);
    let bits = bits.flat_map(|(register, flop)| (0..flop.width).map(move |bit| (register, bit)));
    let literals = bits.take(count).flat_map(|(register, bit)| {
        [false, true].map(|value| Literal {
            register,
            bit,
            value,
        })
    });
    literals.collect()
}
