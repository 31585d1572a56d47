//! Differences that fade: registers of circuit and mutant may differ where nothing that counts shows it in the end.
//!
//! Circuit and mutant are run over some clocks, from any state in which all bits are equal but some that may differ. If
//! everything that counts was equal so far, it has to be equal after the last clock. Which bits may differ is found
//! from below: none at first, then those too that a mutant can make differ.

use crate::controls::Upset;
use crate::flow::Unrolled;
use crate::frame::{Begin, End, Reached, Word, free, zip};
use crate::gates::{Bit, Gates, NO};
use crate::held::Held;
use crate::known::Known;
use crate::solve::{CONFLICTS, Verdict, equality, possible};
use std::collections::HashSet;

/// Clocks from a difference to where it is gone.
pub(crate) const CLOCKS: usize = 10;

/// Attempts, at most: each follows what differs a clock further.
const ATTEMPTS: usize = CLOCKS;

/// A bit of a register.
pub(crate) type Place = (usize, usize);

/// A circuit over some clocks, from any state that is reached.
pub(crate) struct Fading {
    /// With what registers may hold in the mutant where they differ.
    pub(crate) gates: Gates,
    others: Vec<Word>,
    flow: Unrolled,
    /// Bits that are 1.
    assumed: Vec<Bit>,
    /// Registers without controls.
    registers: Vec<usize>,
}

impl Fading {
    /// While inputs are held and registers hold them, or at any time; nothing if it is too large, or what is known of
    /// the states need not hold.
    pub(crate) fn of(of: &Reached, known: &Known, held: Option<&Held>) -> Option<Fading> {
        if !known.always_holds {
            return None;
        }
        let levels = &of.begin.levels;
        let mut gates = of.gates.clone();
        let others = levels.flops.iter().map(|flop| free(flop.width, &mut gates));
        let others = others.collect();
        let gates = gates.frozen();
        let begin = of.begin.clone();
        let begin = held.map_or(begin.clone(), |held| held.work(begin, &of.registers));
        let flow = Unrolled::new(&gates, &begin, CLOCKS, |_, begin, before| {
            if let (Some(held), Some((first, _))) = (held, before.first()) {
                held.hold(begin, first);
            }
        })?;
        let assumed = [flow.zeros(&known.zeros), of.assumed.clone()].concat();
        Some(Fading {
            gates,
            others,
            flow,
            assumed,
            registers: of.registers.clone(),
        })
    }

    /// The bits that a mutant makes differ, if nothing that counts shows it; it has to begin so.
    pub(crate) fn differing(&self, known: &Known, upsets: &[Upset]) -> Option<HashSet<Place>> {
        let mut differing = HashSet::new();
        for _ in 0..ATTEMPTS {
            let more = self.broken(known, upsets, &differing)?;
            if more.is_empty() {
                return Some(differing);
            }
            differing.extend(more);
        }
        None
    }

    /// The bits besides those that may differ that the last clock can make differ; nothing if something that counts
    /// can, or if the solver gives up.
    fn broken(
        &self,
        known: &Known,
        upsets: &[Upset],
        differing: &HashSet<Place>,
    ) -> Option<Vec<Place>> {
        let first = self.begins(self.flow.begin(0), differing);
        // What has to be equal is, so that only what differs is looked at.
        let begins = |register, words: [&Word; 2]| mixed(register, words, differing);
        let (mut gates, mut ends) = self.flow.with_state(upsets, &first, begins);
        let last = ends.pop().expect("there is a first clock");
        let mut assumed = self.assumed.clone();
        for end in &ends {
            let own = state(&self.registers, end, differing).map(|(_, pair)| pair);
            let shown = self.shown(known, end, &mut gates);
            for (good, bad) in own.chain(shown).filter(|(good, bad)| good != bad) {
                assumed.push(!gates.xor(good, bad));
            }
        }
        let shown = self.shown(known, &last, &mut gates);
        let shown = shown.into_iter().map(|pair| (None, pair));
        let state = state(&self.registers, &last, differing);
        let state = state.map(|(place, pair)| (Some(place), pair));
        let goals = shown.chain(state);
        let goals = goals.map(|(place, (good, bad))| (place, gates.xor(good, bad)));
        let goals = goals.filter(|(_, differs)| *differs != NO);
        let (places, differ): (Vec<Option<Place>>, Vec<Bit>) = goals.unzip();
        let can = possible(&gates, &differ, &assumed)?;
        let broken = places.into_iter().zip(can).filter(|(_, can)| *can);
        broken.map(|(place, _)| place).collect()
    }

    /// The words that differ with which the mutant begins a clock, and their places.
    pub(crate) fn begins(&self, begin: &Begin, differing: &HashSet<Place>) -> Vec<(u32, Word)> {
        let registers: HashSet<usize> = differing.iter().map(|(register, _)| *register).collect();
        let words = registers.into_iter().map(|register| {
            let words = [begin.register(register), &self.others[register]];
            let place = begin.levels.flops[register].output;
            (place, mixed(register, words, differing))
        });
        words.collect()
    }

    /// What counts in a clock: outputs, and what memories take.
    fn shown(&self, known: &Known, [good, bad]: &[End; 2], gates: &mut Gates) -> Vec<(Bit, Bit)> {
        let levels = &self.flow.begin(0).levels;
        let mut pairs = known.outputs(levels, [good, bad], gates);
        let memories = good.memories.iter().zip(&bad.memories);
        pairs.extend(memories.flat_map(|(good, bad)| zip(good, bad)));
        pairs
    }

    /// From power-up on, is all equal in the first clocks but what may differ?
    pub(crate) fn is_same_at_first(
        &self,
        known: &Known,
        upsets: &[Upset],
        differing: &HashSet<Place>,
    ) -> bool {
        let mut gates = Gates::new();
        let power_up = Begin::at_power_up(&self.flow.begin(0).levels, &mut gates);
        let Some(first) = Unrolled::new(&gates, &power_up, CLOCKS - 1, |_, _, _| ()) else {
            return false;
        };
        let (mut gates, ends) = first.with(upsets, &[]);
        let mut pairs = vec![];
        for end in &ends {
            pairs.extend(state(&self.registers, end, differing).map(|(_, pair)| pair));
            pairs.extend(self.shown(known, end, &mut gates));
        }
        let zeros = first.zeros(&known.zeros);
        equality(pairs, &zeros, &mut gates, CONFLICTS) == Verdict::Equivalent
    }
}

/// What a register holds in the mutant: the first word, but for bits that may differ.
fn mixed(register: usize, [good, bad]: [&Word; 2], differing: &HashSet<Place>) -> Word {
    let bits = zip(good, bad).into_iter().enumerate();
    let own = |place| differing.contains(&(register, place));
    bits.map(|(place, (good, bad))| if own(place) { bad } else { good })
        .collect()
}

/// What registers hold after a clock, but for bits that may differ.
pub(crate) fn state<'a>(
    registers: &'a [usize],
    [good, bad]: &'a [End; 2],
    differing: &'a HashSet<Place>,
) -> impl Iterator<Item = (Place, (Bit, Bit))> + 'a {
    let pairs = registers.iter().flat_map(move |register| {
        let pairs = zip(&good.registers[*register], &bad.registers[*register]);
        let pairs = pairs.into_iter().enumerate();
        pairs.map(move |(bit, pair)| ((*register, bit), pair))
    });
    pairs.filter(|(place, _)| !differing.contains(place))
}
