//! What the registers of a circuit hold while it works, of inputs that are held so long and of constants.

use crate::flow::Unrolled;
use crate::frame::{Begin, constant};
use crate::gates::{Bit, Gates, NO};
use imogene_hdl::Levels;
use std::collections::HashMap;
use std::sync::Arc;

/// What bits of registers are once the latency passed after the beginning, whatever was before, and stay while the
/// circuit works. Registers are counted without controls.
#[derive(Clone, Default)]
pub(crate) struct Held {
    /// Inputs that are 1 in the clock with which the work begins.
    pub(crate) begins: Vec<usize>,
    /// Inputs that do not change between two such clocks.
    pub(crate) inputs: Vec<usize>,
    /// Register and bit, and what it is.
    bits: Vec<(usize, usize, Source)>,
}

#[derive(Clone, Copy)]
enum Source {
    Constant(Bit),
    /// A bit of an input, or its inverse.
    Input(usize, usize, bool),
}

impl Held {
    /// Of a design without controls.
    pub(crate) fn of(
        levels: &Arc<Levels>,
        begins: Vec<usize>,
        inputs: Vec<usize>,
        latency: usize,
    ) -> Held {
        let mut held = Held {
            begins,
            inputs,
            bits: vec![],
        };
        let mut gates = Gates::new();
        let any = Begin::any(levels, &mut gates);
        let Some(flow) = held.since_start(&gates, &any, latency, 0) else {
            return held;
        };
        let sources = held.sources(flow.begin(latency));
        for (register, word) in flow.end().registers.iter().enumerate() {
            for (place, bit) in word.iter().enumerate() {
                if let Some(source) = source(&sources, *bit) {
                    held.bits.push((register, place, source));
                }
            }
        }
        let registers: Vec<usize> = (0..levels.flops.len()).collect();
        loop {
            let work = held.work(any.clone(), &registers).clock(&mut gates);
            let count = held.bits.len();
            held.bits.retain(|(register, place, source)| {
                work.end.registers[*register].get(*place) == Some(&source.bit(&any))
            });
            if held.bits.len() == count {
                return held;
            }
        }
    }

    /// A circuit over its latency and more clocks, from the clock on with which the work begins, while inputs are held.
    /// Before it, as long as the latency, nothing was under way.
    pub(crate) fn since_start(
        &self,
        gates: &Gates,
        begin: &Begin,
        latency: usize,
        more: usize,
    ) -> Option<Unrolled> {
        let clocks = 2 * latency + 1 + more;
        Unrolled::new(gates, begin, clocks, |index, begin, before| {
            if index <= latency {
                let begins = u64::from(index == latency);
                for input in &self.begins {
                    *begin.input_mut(*input) = constant(begins);
                }
            }
            if let Some((start, _)) = before.get(latency) {
                self.hold(begin, start);
            }
        })
    }

    /// The inputs that are held are as another clock begins.
    pub(crate) fn hold(&self, begin: &mut Begin, start: &Begin) {
        for input in &self.inputs {
            *begin.input_mut(*input) = start.input(*input).clone();
        }
    }

    /// Which bit of an input each gate is, of those that are held.
    fn sources(&self, any: &Begin) -> HashMap<usize, (usize, usize)> {
        let inputs = self.inputs.iter().flat_map(|input| {
            let bits = any.input(*input).iter().enumerate();
            bits.map(|(place, bit)| (bit.gate(), (*input, place)))
        });
        inputs.collect()
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.bits.is_empty()
    }

    /// What a clock of the work begins with, of a design with controls beside these registers.
    pub(crate) fn work(&self, mut begin: Begin, registers: &[usize]) -> Begin {
        for (register, place, source) in &self.bits {
            begin.register_mut(registers[*register])[*place] = source.bit(&begin);
        }
        begin
    }
}

fn source(sources: &HashMap<usize, (usize, usize)>, bit: Bit) -> Option<Source> {
    if bit.gate() == NO.gate() {
        return Some(Source::Constant(bit));
    }
    let (input, place) = sources.get(&bit.gate())?;
    Some(Source::Input(*input, *place, bit.is_inverted()))
}

impl Source {
    fn bit(self, begin: &Begin) -> Bit {
        match self {
            Source::Constant(bit) => bit,
            Source::Input(input, place, is_inverted) => {
                let bit = begin.input(input)[place];
                if is_inverted { !bit } else { bit }
            }
        }
    }
}
