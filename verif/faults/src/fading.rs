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
use crate::solve::{Verdict, any_differs, equality, possible};
use std::collections::HashSet;
use std::sync::OnceLock;

/// Clocks from a difference to where it is gone.
pub(crate) const CLOCKS: usize = 10;

/// Attempts, at most: each follows what differs a clock further.
const ATTEMPTS: usize = CLOCKS;

/// A bit of a register.
pub(crate) type Place = (usize, usize);

/// What a mutant makes differ, where nothing that counts shows it.
#[derive(Default)]
pub(crate) struct Differing {
    /// Bits that may differ.
    pub(crate) bits: HashSet<Place>,
    /// Bits that are made of them, of which it is proven that they do not.
    near: HashSet<Place>,
}

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
    /// The circuit from power-up on, over these clocks, and over the latency and these.
    first: [OnceLock<Option<Unrolled>>; 2],
}

impl Fading {
    /// While inputs are held and registers hold them, or at any time; `None` if it is too large, or what is known of
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
            first: Default::default(),
        })
    }

    /// What a mutant makes differ, if nothing that counts shows it; it has to begin so.
    pub(crate) fn differing(&self, known: &Known, upsets: &[Upset]) -> Option<Differing> {
        let mut bits = HashSet::new();
        for _ in 0..ATTEMPTS {
            let made = self.made(known, upsets, &bits)?;
            let (more, near): (Vec<_>, Vec<_>) = made.into_iter().partition(|(_, can)| *can);
            if more.is_empty() {
                let near = near.into_iter().map(|(place, _)| place).collect();
                return Some(Differing { bits, near });
            }
            bits.extend(more.into_iter().map(|(place, _)| place));
        }
        None
    }

    /// The bits that the last clock makes of those that may differ, besides these, and whether they can; `None` if
    /// something that counts can, or if the solver gives up.
    fn made(
        &self,
        known: &Known,
        upsets: &[Upset],
        differing: &HashSet<Place>,
    ) -> Option<Vec<(Place, bool)>> {
        let first = self.begins(self.flow.begin(0), differing);
        let mut equal = vec![];
        // What has to be equal is, so that only what differs is looked at.
        let begins = |_: &mut Gates, register, words: [&Word; 2]| {
            let own = |place: &Place| differing.contains(place);
            // Controls are what makes the mutant: they are not equal.
            if self.registers.contains(&register) {
                let pairs = zip(words[0], words[1]).into_iter().enumerate();
                let pairs = pairs.filter(|(bit, _)| !own(&(register, *bit)));
                equal.extend(pairs.map(|(_, pair)| pair));
            }
            mixed(register, words, own)
        };
        let (mut gates, mut ends) = self.flow.with_state(upsets, &first, begins);
        let last = ends.pop().expect("there is a first clock");
        for end in &ends {
            equal.extend(self.shown(known, end, &mut gates));
        }
        let mut assumed = self.assumed.clone();
        let pairs = equal.into_iter().filter(|(good, bad)| good != bad);
        assumed.extend(pairs.map(|(good, bad)| !gates.xor(good, bad)));
        let shown = self.shown(known, &last, &mut gates);
        let shows = any_differs(shown, &mut gates);
        let state = state(&self.registers, &last, differing);
        let made = state.map(|(place, (good, bad))| (place, gates.xor(good, bad)));
        let made = made.filter(|(_, differs)| *differs != NO);
        let (places, differ): (Vec<Place>, Vec<Bit>) = made.unzip();
        let can = possible(&gates, known.effort, shows, &differ, &assumed)?;
        Some(places.into_iter().zip(can).collect())
    }

    /// The words that differ with which the mutant begins a clock, and their places.
    pub(crate) fn begins(&self, begin: &Begin, differing: &HashSet<Place>) -> Vec<(u32, Word)> {
        let registers: HashSet<usize> = differing.iter().map(|(register, _)| *register).collect();
        let words = registers.into_iter().map(|register| {
            let words = [begin.register(register), &self.others[register]];
            let place = begin.levels.flops[register].output;
            let word = mixed(register, words, |place| differing.contains(place));
            (place, word)
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

    /// From power-up on, is all equal but what may differ, in the first clocks or once the latency passed, and is
    /// nothing shown before?
    pub(crate) fn begins_alike(&self, known: &Known, upsets: &[Upset], found: &Differing) -> bool {
        let mut before = [0, known.latency].into_iter().zip(&self.first);
        before.any(|(clocks, first)| {
            let first = first.get_or_init(|| {
                let mut gates = Gates::new();
                let power_up = Begin::at_power_up(&self.flow.begin(0).levels, &mut gates);
                Unrolled::new(&gates, &power_up, clocks + CLOCKS, |_, _, _| ())
            });
            let first = first.as_ref();
            first.is_some_and(|first| self.is_same_behind(clocks, first, known, upsets, found))
        })
    }

    /// The same where all is equal from so many clocks behind power-up on.
    fn is_same_behind(
        &self,
        clocks: usize,
        first: &Unrolled,
        known: &Known,
        upsets: &[Upset],
        found: &Differing,
    ) -> bool {
        let zeros = first.zeros(&known.zeros);
        let begins = |gates: &mut Gates, register, words: [&Word; 2]| {
            found.settled((gates, known.effort), register, words, &zeros)
        };
        let (mut gates, ends) = first.with_state(upsets, &[], begins);
        let last = ends.iter().skip(clocks);
        let state = last.flat_map(|end| state(&self.registers, end, &found.bits));
        let mut pairs: Vec<(Bit, Bit)> = state.map(|(_, pair)| pair).collect();
        for end in &ends {
            pairs.extend(self.shown(known, end, &mut gates));
        }
        equality(pairs, &zeros, &mut gates, known.effort) == Verdict::Equivalent
    }
}

impl Differing {
    /// What a register of the mutant begins a clock with: its own word, but for bits of the circuit where they are made
    /// of others that differ and are proven to be equal, with a tenth of the effort: there are many of them.
    pub(crate) fn settled(
        &self,
        (gates, effort): (&mut Gates, u64),
        register: usize,
        words: [&Word; 2],
        assumed: &[Bit],
    ) -> Word {
        let pairs = zip(words[0], words[1]).into_iter().enumerate();
        let near = pairs.filter(|(bit, _)| self.near.contains(&(register, *bit)));
        let near = near.map(|(_, pair)| pair).collect();
        match equality(near, assumed, gates, effort / 10) {
            Verdict::Equivalent => mixed(register, words, |place| !self.near.contains(place)),
            _ => words[1].clone(),
        }
    }
}

/// What a register holds in the mutant: the first word, but for its own bits.
fn mixed(register: usize, [good, bad]: [&Word; 2], is_own: impl Fn(&Place) -> bool) -> Word {
    let bits = zip(good, bad).into_iter().enumerate();
    bits.map(|(place, (good, bad))| [good, bad][usize::from(is_own(&(register, place)))])
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
