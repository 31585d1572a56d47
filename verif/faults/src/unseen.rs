//! What registers hold at power-up that nothing shows: two circuits that differ in it alone.

use crate::frame::{Begin, End, Frame, Reached, Word, bit_of, differ, free, zero_inputs, zip};
use crate::gates::{Bit, Gates};
use crate::known::Known;
use crate::phases::ports;
use crate::solve::{CONFLICTS, Verdict, equality};
use imogene_hdl::Levels;
use std::sync::Arc;

/// Gates of all clocks, at most: each register is looked at by itself.
const GATES: usize = 400_000;

impl Known {
    /// Is what a register holds at power-up seen nowhere? `of` is a clock from any state that is reached.
    pub(crate) fn is_unseen(&self, of: &Reached, register: usize) -> bool {
        let levels = &of.begin.levels;
        if self.clocks() * levels.code.len() * 16 > GATES {
            return false;
        }
        let mut flags = (0..levels.flops.len()).filter(|flag| levels.flops[*flag].width == 1);
        self.is_gone(levels, register) || flags.any(|flag| self.is_behind(of, register, flag))
    }

    /// In which a difference has to be gone.
    fn clocks(&self) -> usize {
        self.latency + 2
    }

    /// Is it gone soon after power-up?
    fn is_gone(&self, levels: &Arc<Levels>, register: usize) -> bool {
        let mut gates = Gates::new();
        let mut begin = Begin::at_power_up(levels, &mut gates);
        let flop = &levels.flops[register];
        let mut others = vec![(flop.output, free(flop.width, &mut gates))];
        let (mut pairs, mut assumed) = (vec![], vec![]);
        for _ in 0..self.clocks() {
            assumed.extend(zero_inputs(&self.zeros, &begin));
            let clock = begin.clock(&mut gates);
            let bad = clock.with(&[], others, &mut gates);
            pairs.extend(self.outputs(levels, [&clock.end, &bad], &mut gates));
            others = vec![];
            for (index, store) in levels.stores.iter().enumerate() {
                let [good, bad] = [&clock.end, &bad].map(|end| &end.memories[index]);
                let taken = good.len() - clock.at(store.address).len();
                pairs.extend(zip(&good[..taken].to_vec(), &bad[..taken].to_vec()));
                if good[taken..] != bad[taken..] {
                    others.push((store.output, free(store.width, &mut gates)));
                }
            }
            for (flop, words) in levels.flops.iter().zip(registers(&clock, &bad)) {
                if words[0] != words[1] {
                    others.push((flop.output, words[1].clone()));
                }
            }
            begin = begin.after(&clock.end, &mut gates);
        }
        // What is left has to be equal, whatever it looks like.
        let left = others.iter();
        pairs.extend(left.flat_map(|(place, bad)| zip(begin.at(*place), bad)));
        equality(pairs, &assumed, &mut gates, CONFLICTS) == Verdict::Equivalent
    }

    /// Does it differ only while a flag is as at power-up, and shows nothing then?
    fn is_behind(&self, of: &Reached, register: usize, flag: usize) -> bool {
        if flag == register {
            return false;
        }
        let levels = &of.begin.levels;
        let is_up = levels.words[levels.flops[flag].output as usize] == 1;
        let rest = |word: &Word| match bit_of(word, 0) {
            bit if is_up => bit,
            bit => !bit,
        };
        let mut gates = of.gates.clone();
        let flop = &levels.flops[register];
        let other = (flop.output, free(flop.width, &mut gates));
        let bad = of.clock.with(&[], [other], &mut gates);
        let at_rest = rest(of.begin.register(flag));
        let assumed = [&of.assumed[..], &[at_rest]].concat();
        let mut pairs = self.outputs(levels, [&of.clock.end, &bad], &mut gates);
        let memories = of.clock.end.memories.iter().zip(&bad.memories);
        pairs.extend(memories.flat_map(|(good, bad)| zip(good, bad)));
        for (index, [good, bad]) in registers(&of.clock, &bad).enumerate() {
            if index != register {
                pairs.extend(zip(good, bad));
                continue;
            }
            let differs = differ(&mut gates, good, bad);
            let is_shown = !rest(&of.clock.end.registers[flag]);
            pairs.push((gates.and(differs, is_shown), Bit::of(false)));
        }
        equality(pairs, &assumed, &mut gates, CONFLICTS) == Verdict::Equivalent
    }

    /// The bits of the outputs, where they count.
    pub(crate) fn outputs(
        &self,
        levels: &Levels,
        ends: [&End; 2],
        gates: &mut Gates,
    ) -> Vec<(Bit, Bit)> {
        let mut pairs = vec![];
        let ports = ports(levels);
        for (port, flag) in ports.iter().zip(&self.counts_with) {
            for place in port.clone() {
                let both = ends.map(|end| match flag {
                    Some(flag) => {
                        gates.and(ends[0].outputs[ports[*flag].start], end.outputs[place])
                    }
                    None => end.outputs[place],
                });
                pairs.push(both.into());
            }
        }
        pairs
    }
}

/// What each register holds after a clock of two circuits.
fn registers<'a>(good: &'a Frame, bad: &'a End) -> impl Iterator<Item = [&'a Word; 2]> {
    let pairs = good.end.registers.iter().zip(&bad.registers);
    pairs.map(|(good, bad)| [good, bad])
}
