//! A circuit over several clocks, in which circuit and mutant begin in the same state, which may be any, and take the
//! same inputs.
//!
//! Of circuits that keep nothing, what comes out depends on the inputs of the last clocks alone, as many as the
//! latency. If it is equal over these, it is equal for ever.

use crate::controls::Upset;
use crate::frame::{Begin, End, Frame, Word, zero_inputs};
use crate::gates::{Bit, Gates, NO};
use std::collections::HashMap;

/// Gates in all clocks, at most: beyond, a proof takes minutes.
const GATES: usize = 8_000_000;

/// A circuit over some clocks.
pub(crate) struct Unrolled {
    gates: Gates,
    /// Each clock, and what it begins with.
    clocks: Vec<(Begin, Frame)>,
}

/// A bit of a register, or what a memory gives.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum State {
    Register(usize, usize),
    Memory(usize),
}

impl State {
    /// Which state each input gate is, if it is one.
    pub(crate) fn of(begin: &Begin) -> HashMap<usize, State> {
        let (levels, mut state) = (&begin.levels, HashMap::new());
        for (index, flop) in levels.flops.iter().enumerate() {
            for (place, bit) in begin.at(flop.output).iter().enumerate() {
                state.insert(bit.gate(), State::Register(index, place));
            }
        }
        for (index, store) in levels.stores.iter().enumerate() {
            for bit in begin.at(store.output) {
                state.insert(bit.gate(), State::Memory(index));
            }
        }
        // What is held is no state.
        state.remove(&NO.gate());
        state
    }
}

/// Is nothing of the state in the outputs once the latency passed?
pub(crate) fn keeps_nothing(
    gates: &Gates,
    end: &End,
    state: &HashMap<usize, State>,
    latency: usize,
) -> bool {
    // What depends on the state that the first clock began with.
    let mut old: Vec<usize> = state.keys().copied().collect();
    for _ in 0..latency {
        let is_old = gates.depending(&old);
        let next = state.iter().filter(|(_, state)| match state {
            State::Register(index, place) => is_old[end.registers[*index][*place].gate()],
            State::Memory(_) => true,
        });
        old = next.map(|(gate, _)| *gate).collect();
    }
    let is_old = gates.depending(&old);
    end.outputs.iter().all(|bit| !is_old[bit.gate()])
}

impl Unrolled {
    /// So many clocks; `None` if that is too large. `fix` fixes inputs of a clock, by its number and the clocks
    /// before.
    pub(crate) fn new(
        gates: &Gates,
        begin: &Begin,
        clocks: usize,
        fix: impl Fn(usize, &mut Begin, &[(Begin, Frame)]),
    ) -> Option<Unrolled> {
        if gates.len().max(begin.levels.code.len() * 16) * clocks > GATES {
            return None;
        }
        let mut gates = gates.clone();
        let mut all: Vec<(Begin, Frame)> = vec![];
        for index in 0..clocks {
            let mut begin = match all.last() {
                None => begin.clone(),
                Some((begin, last)) => begin.clone().after(&last.end, &mut gates),
            };
            fix(index, &mut begin, &all);
            let clock = begin.clock(&mut gates);
            all.push((begin, clock));
        }
        Some(Unrolled {
            gates: gates.frozen(),
            clocks: all,
        })
    }

    /// What a clock begins with.
    pub(crate) fn begin(&self, clock: usize) -> &Begin {
        &self.clocks[clock].0
    }

    /// What the last clock comes to.
    pub(crate) fn end(&self) -> &End {
        let (_, last) = self.clocks.last().expect("there is a first clock");
        &last.end
    }

    /// Bits that are 1 where these inputs are 0 in every clock.
    pub(crate) fn zeros(&self, zeros: &[(usize, u32)]) -> Vec<Bit> {
        let clocks = self.clocks.iter();
        let zeros = clocks.flat_map(|(begin, _)| zero_inputs(zeros, begin));
        zeros.collect()
    }

    /// Does nothing that is seen, and nothing that is left, depend on what a register begins with?
    pub(crate) fn is_dead(&self, register: usize) -> bool {
        let depends = self.gates.depending_on(self.begin(0).register(register));
        let outputs = self.clocks.iter().flat_map(|(_, clock)| &clock.end.outputs);
        let mut seen = outputs.chain(self.end().registers.iter().flatten());
        !seen.any(|bit| depends[bit.gate()])
    }

    /// What the mutant that upsets make comes to in each clock, beside the circuit, and all gates; it begins with other
    /// words at some places.
    pub(crate) fn with(&self, upsets: &[Upset], first: &[(u32, Word)]) -> (Gates, Vec<[End; 2]>) {
        self.with_state(upsets, first, |_, _, [_, bad]| bad.clone())
    }

    /// The same, where each next clock begins with other words, to which the mutant came then: `begins` gives that of a
    /// register by what circuit and mutant hold in it after the clock before.
    pub(crate) fn with_state(
        &self,
        upsets: &[Upset],
        first: &[(u32, Word)],
        mut begins: impl FnMut(&mut Gates, usize, [&Word; 2]) -> Word,
    ) -> (Gates, Vec<[End; 2]>) {
        let mut gates = self.gates.clone();
        let mut ends: Vec<[End; 2]> = vec![];
        for (begin, clock) in &self.clocks {
            let mut others = vec![];
            match ends.last_mut() {
                None => others.extend(first.iter().cloned()),
                Some([good, bad]) => {
                    let words = good.registers.iter().zip(&mut bad.registers).enumerate();
                    for ((index, (good, bad)), flop) in words.zip(&begin.levels.flops) {
                        *bad = begins(&mut gates, index, [good, bad]);
                        if bad != begin.at(flop.output) {
                            others.push((flop.output, bad.clone()));
                        }
                    }
                }
            }
            let end = clock.with(upsets, others, &mut gates);
            ends.push([clock.end.clone(), end]);
        }
        (gates, ends)
    }
}
