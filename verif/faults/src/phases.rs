//! Circuit and mutant in two states that need not be equal: some registers are alike only in some phases of the work.
//!
//! A register that is loaded before it is read may hold anything until then. What has to be alike in which phase is
//! found from above: all in every phase, less what a clock may break, until nothing is broken or an output differs.

use crate::controls::Upset;
use crate::frame::{CONTROL, Reached, Word, constant, differ, free};
use crate::gates::{Bit, Gates, NO, YES};
use crate::solve::{Answer, CONFLICTS, ask, possible};
use imogene_hdl::Levels;
use std::ops::Range;

/// Phases, at most.
const PHASES: usize = 256;

/// Gates of a clock, at most.
const GATES: usize = 60_000;

/// Attempts, at most: each drops something.
const ATTEMPTS: usize = 250;

/// The phases of a circuit: what its short registers hold. Registers are counted without controls.
#[derive(Clone, Default)]
pub(crate) struct Phases {
    registers: Vec<usize>,
    seen: Vec<Vec<u64>>,
    /// Of each output, the one without which it counts nothing.
    counts_with: Vec<Option<usize>>,
}

/// What a clock could break: that a register is alike in a phase, or in all of them.
type Goal = (usize, Option<usize>);

/// In which phases a register has to be alike; all of them where nothing is said.
type Alike = Vec<Option<Vec<bool>>>;

impl Phases {
    /// Of a circuit: all to which it comes from the first one, whatever is in its long registers. There are none if
    /// they are too many.
    pub(crate) fn of(mut of: Reached, counts_with: Vec<Option<usize>>) -> Option<Phases> {
        let (levels, end) = (&of.begin.levels, &of.clock.end);
        if of.gates.len() > GATES || !levels.stores.is_empty() {
            return None;
        }
        let all = of.registers.iter();
        let short = all.filter(|index| levels.flops[**index].width <= CONTROL);
        let initial = |index: &usize| levels.words[levels.flops[*index].output as usize];
        let registers: Vec<usize> = short.copied().collect();
        let mut phases = Phases {
            seen: vec![registers.iter().map(initial).collect()],
            registers,
            counts_with,
        };
        let after: Word = phases
            .registers
            .iter()
            .flat_map(|index| end.registers[*index].clone())
            .collect();
        while phases.seen.len() <= PHASES {
            let before = |index: usize| of.begin.register(index);
            let before = phases.phases(&mut of.gates, before);
            let is_before = before.iter().fold(NO, |any, is| of.gates.or(any, *is));
            let seen = phases.phases(&mut of.gates, |index: usize| &end.registers[index]);
            let is_seen = seen.iter().fold(NO, |any, is| of.gates.or(any, *is));
            let assumed = [&of.assumed[..], &[is_before]].concat();
            match ask(&of.gates, !is_seen, &assumed, CONFLICTS, &after) {
                Answer::Never => return Some(phases),
                Answer::Unknown => return None,
                Answer::When(bits) => {
                    let mut bits = bits.into_iter();
                    let widths = phases.registers.iter();
                    let widths = widths.map(|index| levels.flops[*index].width);
                    let mut word = |width: u32| {
                        let bits = bits.by_ref().take(width as usize).enumerate();
                        bits.fold(0, |word, (place, bit)| word | u64::from(bit) << place)
                    };
                    let phase = widths.map(&mut word).collect();
                    phases.seen.push(phase);
                }
            }
        }
        None
    }

    /// Does a mutant show nothing that counts, as far as so many conflicts tell?
    pub(crate) fn are_same(&self, of: &Reached, conflicts: u64, upsets: &[Upset]) -> bool {
        let mut alike: Alike = vec![None; of.registers.len()];
        for _ in 0..ATTEMPTS {
            let Some(broken) = self.broken(of, conflicts, upsets, &alike) else {
                return false;
            };
            if broken.is_empty() {
                return true;
            }
            for (register, phase) in broken {
                match (&mut alike[register], phase) {
                    (Some(phases), Some(phase)) => phases[phase] = false,
                    (phases, _) => *phases = Some(vec![true; self.seen.len()]),
                }
            }
        }
        false
    }

    /// What a clock may break before which all is alike that has to be; `None` if an output may show it, or if the
    /// solver gives up.
    fn broken(
        &self,
        of: &Reached,
        conflicts: u64,
        upsets: &[Upset],
        alike: &Alike,
    ) -> Option<Vec<Goal>> {
        let (levels, mut gates) = (&of.begin.levels, of.gates.clone());
        let before = |index: usize| of.begin.register(of.registers[index]);
        let phases_before = self.phases(&mut gates, before);
        let mut assumed = of.assumed.clone();
        let mut others = vec![];
        for (index, phases) in alike.iter().enumerate() {
            let Some(phases) = phases else { continue };
            let flop = &levels.flops[of.registers[index]];
            let word = free(flop.width, &mut gates);
            let differs = differ(&mut gates, before(index), &word);
            let alike = phases_before.iter().zip(phases).filter(|(_, is)| **is);
            assumed.extend(alike.map(|(phase, _)| !gates.and(*phase, differs)));
            others.push((flop.output, word));
        }
        let bad = of.clock.with(upsets, others, &mut gates);
        let good = &of.clock.end;
        let after = |index: usize| &good.registers[of.registers[index]];
        let phases_after = self.phases(&mut gates, after);
        let any_phase = phases_before.iter().fold(NO, |any, is| gates.or(any, *is));
        assumed.push(any_phase);
        let shows = self.shows(levels, &good.outputs, &bad.outputs, &mut gates);
        let mut goals = vec![];
        for (index, phases) in alike.iter().enumerate() {
            let bad = &bad.registers[of.registers[index]];
            let differs = differ(&mut gates, after(index), bad);
            match phases {
                None => goals.push(((index, None), differs)),
                Some(phases) => {
                    let wanted = phases.iter().enumerate().filter(|(_, is)| **is);
                    goals.extend(wanted.map(|(phase, _)| {
                        let broken = gates.and(phases_after[phase], differs);
                        ((index, Some(phase)), broken)
                    }));
                }
            }
        }
        goals.retain(|(_, broken)| *broken != NO);
        let (goals, bits): (Vec<Goal>, Vec<Bit>) = goals.into_iter().unzip();
        let can = possible(&gates, conflicts, shows, &bits, &assumed)?;
        let broken = goals.into_iter().zip(can).filter(|(_, can)| *can);
        Some(broken.map(|(goal, _)| goal).collect())
    }

    /// Is each phase there?
    fn phases<'a>(&self, gates: &mut Gates, word: impl Fn(usize) -> &'a Word) -> Vec<Bit> {
        let phases = self.seen.iter().map(|values| {
            let pairs = self.registers.iter().zip(values);
            pairs.fold(YES, |all, (register, value)| {
                let differs = differ(gates, word(*register), &constant(*value));
                gates.and(all, !differs)
            })
        });
        phases.collect()
    }

    /// 1 where an output differs that counts.
    fn shows(&self, levels: &Levels, good: &[Bit], bad: &[Bit], gates: &mut Gates) -> Bit {
        let ports = ports(levels);
        ports.iter().enumerate().fold(NO, |any, (index, port)| {
            let [a, b] = [good, bad].map(|outputs| outputs[port.clone()].to_vec());
            let differs = differ(gates, &a, &b);
            let counts = self.counts_with.get(index).copied().flatten();
            let counts = counts.map_or(YES, |flag| good[ports[flag].start]);
            let shows = gates.and(counts, differs);
            gates.or(any, shows)
        })
    }
}

/// Where the bits of each output are.
pub(crate) fn ports(levels: &Levels) -> Vec<Range<usize>> {
    let mut first = 0;
    let ports = levels.outputs().iter().map(|port| {
        let place = first;
        first += port.width as usize;
        place..first
    });
    ports.collect()
}
