//! Proofs that a mutant is no mutant at all.
//!
//! Circuit and mutant begin a clock in the same state with the same inputs. If outputs and next states are then equal
//! for every beginning that the circuit can come to, they are equal for ever. Only state that can reach an output
//! counts. Where they differ in a circuit that keeps nothing, what comes out after the latency is compared.

use crate::controls::{Controls, Upset};
use crate::flow::{Flow, State, keeps_nothing};
use crate::frame::{Begin, End, Word, constant};
use crate::gates::{Bit, Gates, NO};
use crate::known::Known;
use crate::solve::can_be;
use imogene_hdl::Levels;
use std::collections::{HashMap, HashSet};
use std::sync::OnceLock;

/// What is known of a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It behaves like the circuit on every input, from the first result on.
    Equivalent,
    /// In some state, which may be one that is never reached, outputs or next state differ.
    Differs,
    /// The solver gave up.
    Undecided,
}

/// Judges the mutants of a design with controls.
pub struct Judge {
    levels: Levels,
    gates: Gates,
    begin: Begin,
    good: End,
    /// Bits that are 1.
    assumed: Vec<Bit>,
    /// Which state each input gate is, if it is one.
    state: HashMap<usize, State>,
    latency: usize,
    even: Vec<usize>,
    keeps_nothing: bool,
    /// Does what is assumed hold from power-up on?
    always_holds: bool,
    /// The circuit over its latency, made when it is first wanted.
    flow: OnceLock<Flow>,
}

impl Judge {
    /// Of a design with controls, of which this is known without them.
    pub fn new(controls: &Controls, known: &Known) -> Judge {
        let levels = Levels::of(&controls.design);
        let mut gates = Gates::new();
        let mut begin = Begin::any(&levels, &mut gates);
        let held: HashSet<usize> = controls.registers().collect();
        for register in &held {
            let place = levels.flops[*register].output;
            *begin.at_mut(place) = constant(levels.words[place as usize]);
        }
        let registers = (0..levels.flops.len()).filter(|index| !held.contains(index));
        let registers: Vec<usize> = registers.collect();
        let assumed = known.bits(&levels, &begin, &registers, &mut gates);
        let good = begin.clock(&levels, &[], &mut gates);
        let state = State::of(&levels, &begin);
        let keeps_nothing = keeps_nothing(&gates, &good, &state, known.latency);
        Judge {
            levels,
            gates,
            begin,
            good,
            assumed,
            state,
            latency: known.latency,
            even: known.even.clone(),
            keeps_nothing,
            always_holds: known.always_holds,
            flow: OnceLock::new(),
        }
    }

    /// What is known of the mutant that upsets make.
    pub fn judge(&self, upsets: &[Upset]) -> Verdict {
        let mut gates = self.gates.clone();
        let bad = self.begin.clock(&self.levels, upsets, &mut gates);
        let keeps_nothing =
            self.keeps_nothing && keeps_nothing(&gates, &bad, &self.state, self.latency);
        match self.of_a_clock(&bad, &mut gates) {
            Verdict::Equivalent if self.always_holds || keeps_nothing => Verdict::Equivalent,
            _ if keeps_nothing && self.flow().is_same(&self.levels, upsets) => Verdict::Equivalent,
            Verdict::Equivalent => Verdict::Undecided,
            other => other,
        }
    }

    /// The circuit over its latency.
    fn flow(&self) -> &Flow {
        self.flow.get_or_init(|| {
            let begin = (self.begin.clone(), &self.good);
            let gates = self.gates.clone();
            Flow::of(&self.levels, gates, begin, self.latency, &self.even)
        })
    }

    /// What is known by outputs and next states of one clock.
    fn of_a_clock(&self, bad: &End, gates: &mut Gates) -> Verdict {
        let pairs = self.pairs(bad, gates);
        let differ = pairs.into_iter().filter(|(good, bad)| good != bad);
        let differ: Vec<Bit> = differ.map(|(good, bad)| gates.xor(good, bad)).collect();
        let any = differ.into_iter().fold(NO, |any, bit| gates.or(any, bit));
        match can_be(gates, any, &self.assumed) {
            Some(false) => Verdict::Equivalent,
            Some(true) => Verdict::Differs,
            None => Verdict::Undecided,
        }
    }

    /// Outputs of circuit and mutant, and next states of all bits that either of them reads for an output.
    fn pairs(&self, bad: &End, gates: &Gates) -> Vec<(Bit, Bit)> {
        let good = &self.good;
        let mut pairs: Vec<(Bit, Bit)> = zip(&good.outputs, &bad.outputs);
        let mut is_seen = vec![false; gates.len()];
        let mut is_taken = HashSet::new();
        let mut done = 0;
        while done < pairs.len() {
            let (a, b) = pairs[done];
            done += 1;
            let mut open = vec![a.gate(), b.gate()];
            while let Some(gate) = open.pop() {
                if std::mem::replace(&mut is_seen[gate], true) {
                    continue;
                }
                if let Some(operands) = gates.operands(gate) {
                    open.extend(operands.map(Bit::gate));
                } else if let Some(&state) = self.state.get(&gate)
                    && is_taken.insert(state)
                {
                    match state {
                        State::Register(index, bit) => {
                            pairs.push((good.registers[index][bit], bad.registers[index][bit]));
                        }
                        State::Memory(index) => {
                            pairs.extend(zip(&good.memories[index], &bad.memories[index]));
                        }
                    }
                }
            }
        }
        pairs
    }
}

/// Bits of the same places.
fn zip(good: &Word, bad: &Word) -> Vec<(Bit, Bit)> {
    let length = good.len().max(bad.len());
    let at = |word: &Word, index: usize| word.get(index).copied().unwrap_or(NO);
    (0..length)
        .map(|index| (at(good, index), at(bad, index)))
        .collect()
}
