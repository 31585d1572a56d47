//! From rest to rest.
//!
//! Of a circuit that rests until its work begins and rests again after its latency: circuit and mutant do the same in
//! between, and come to the same state.

use crate::controls::Upset;
use crate::flow::Unrolled;
use crate::frame::{Begin, Frame, Reached, Word, free, state_pairs, zip};
use crate::gates::{Gates, NO};
use crate::idle::Idle;
use crate::solve::{Verdict, equality};

/// A clock of rest, and the work from there.
pub(crate) struct Rest {
    gates: Gates,
    clock: Frame,
    work: Unrolled,
    /// What rests in registers that are loaded before they are read may be anything: their places, and any words.
    dead: Vec<(u32, Word)>,
    /// The other registers.
    kept: Vec<usize>,
}

impl Rest {
    /// Of a circuit without memories whose work begins with one bit and ends with the latency.
    pub(crate) fn of(of: &Reached, idle: &Idle, latency: usize) -> Option<Rest> {
        let levels = &of.begin.levels;
        let [input] = idle.quiet[..] else {
            return None;
        };
        if idle.begins != [[(input, 1)]] || !levels.stores.is_empty() {
            return None;
        }
        let mut idle = idle.of_control();
        loop {
            let begin = idle.begin(of.begin.clone(), &of.registers);
            let mut gates = of.gates.clone();
            let clock = begin.clock(&mut gates);
            let words = levels.flops.iter().map(|flop| free(flop.width, &mut gates));
            let words: Vec<Word> = words.collect();
            let gates = gates.frozen();
            let fix = |clock, begin: &mut Begin, _: &[(Begin, Frame)]| {
                if clock == 0 {
                    idle.fix(0, begin);
                }
            };
            let work = Unrolled::new(&gates, &begin, latency, fix)?;
            let ends = [&clock.end, work.end()];
            if ends.map(|end| idle.drop_changing(end, &of.registers)) != [false; 2] {
                continue;
            }
            let is_dead = |index: &usize| {
                let mut bits = begin.register(*index).iter();
                bits.all(|bit| bit.gate() != NO.gate())
                    && work.is_dead(*index)
                    && clock.is_dead(&begin, &gates, *index)
            };
            let registers = of.registers.iter().copied();
            let (dead, kept): (Vec<usize>, Vec<usize>) = registers.partition(is_dead);
            let place = |index: usize| (levels.flops[index].output, words[index].clone());
            return Some(Rest {
                dead: dead.into_iter().map(place).collect(),
                gates,
                clock,
                work,
                kept,
            });
        }
    }

    /// Does a mutant do the same, as far as so many conflicts tell?
    pub(crate) fn is_same(&self, conflicts: u64, upsets: &[Upset]) -> bool {
        let mut gates = self.gates.clone();
        let bad = (self.clock).with(upsets, self.dead.iter().cloned(), &mut gates);
        let pairs = state_pairs(&self.kept, &self.clock.end, &bad);
        let outputs = zip(&self.clock.end.outputs, &bad.outputs);
        let pairs = pairs.chain(outputs).collect();
        if equality(pairs, &[], &mut gates, conflicts) != Verdict::Equivalent {
            return false;
        }
        let (mut gates, ends) = self.work.with(upsets, &self.dead);
        let outputs = ends.iter();
        let outputs = outputs.flat_map(|[good, bad]| zip(&good.outputs, &bad.outputs));
        let [good, bad] = ends.last().expect("there is a first clock");
        let pairs = outputs.chain(state_pairs(&self.kept, good, bad)).collect();
        equality(pairs, &[], &mut gates, conflicts) == Verdict::Equivalent
    }
}
