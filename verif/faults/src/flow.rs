//! Circuits that keep nothing: what comes out depends on the inputs of the last clocks alone, as many as the latency.
//!
//! Circuit and mutant begin in the same state, which may be any, and take the same inputs over the latency. If what
//! then comes out is equal, and both keep nothing, it is equal for ever.

use crate::controls::Upset;
use crate::frame::{Begin, End};
use crate::gates::{Bit, Gates, NO};
use crate::known::even_inputs;
use crate::solve::can_be;
use imogene_hdl::Levels;
use std::collections::HashMap;

/// A circuit over its latency.
pub(crate) struct Flow {
    gates: Gates,
    /// What each clock begins with.
    begins: Vec<Begin>,
    outputs: Vec<Bit>,
    /// Bits that are 1.
    assumed: Vec<Bit>,
}

/// A bit of a register, or what a memory gives.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum State {
    Register(usize, usize),
    Memory(usize),
}

impl State {
    /// Which state each input gate is, if it is one.
    pub(crate) fn of(levels: &Levels, begin: &Begin) -> HashMap<usize, State> {
        let mut state = HashMap::new();
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
    // Which gates depend on the state that the first clock began with.
    let mut is_old = vec![false; gates.len()];
    state.keys().for_each(|gate| is_old[*gate] = true);
    for clock in 0..=latency {
        for gate in 0..gates.len() {
            if let Some(operands) = gates.operands(gate) {
                is_old[gate] = operands.iter().any(|bit| is_old[bit.gate()]);
            }
        }
        if clock == latency {
            break;
        }
        let next = state.iter().map(|(gate, state)| match state {
            State::Register(index, place) => (*gate, is_old[end.registers[*index][*place].gate()]),
            State::Memory(_) => (*gate, true),
        });
        let next: Vec<(usize, bool)> = next.collect();
        next.into_iter().for_each(|(gate, is)| is_old[gate] = is);
    }
    end.outputs.iter().all(|bit| !is_old[bit.gate()])
}

impl Flow {
    /// Of a circuit that keeps nothing, from a clock on.
    pub(crate) fn of(
        levels: &Levels,
        mut gates: Gates,
        (first, end): (Begin, &End),
        latency: usize,
        even: &[usize],
    ) -> Flow {
        let mut end = end.clone();
        let mut begins = vec![first];
        for clock in 0..latency {
            let begin = begins[clock].clone().after(&end, levels, &mut gates);
            end = begin.clock(levels, &[], &mut gates);
            begins.push(begin);
        }
        let even = begins
            .iter()
            .flat_map(|begin| even_inputs(even, levels, begin));
        Flow {
            assumed: even.collect(),
            outputs: end.outputs,
            gates,
            begins,
        }
    }

    /// Has the mutant that upsets make the outputs of the circuit?
    pub(crate) fn is_same(&self, levels: &Levels, upsets: &[Upset]) -> bool {
        let mut gates = self.gates.clone();
        let mut end = self.begins[0].clock(levels, upsets, &mut gates);
        for begin in &self.begins[1..] {
            let begin = begin.clone().with_state(&end, levels);
            end = begin.clock(levels, upsets, &mut gates);
        }
        let pairs = self.outputs.iter().zip(&end.outputs);
        let differ = pairs.fold(NO, |any, (good, bad)| {
            let differ = gates.xor(*good, *bad);
            gates.or(any, differ)
        });
        can_be(&gates, differ, &self.assumed) == Some(false)
    }
}
