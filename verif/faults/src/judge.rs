//! Proofs that a mutant is no mutant at all.
//!
//! Circuit and mutant begin a clock in the same state with the same inputs. If outputs and next states are then equal
//! for every beginning that the circuit can come to, they are equal for ever. Only state that can reach an output
//! counts. Where they differ in a circuit that keeps nothing, what comes out after the latency is compared. Where
//! inputs are held while a circuit works that forgets all else when the work begins, the clocks of the work are
//! compared alone. What else is tried has a file of its own: from rest to rest, the phases of the work, and differences
//! that fade.

use crate::controls::{Controls, Upset};
use crate::fading::{self, Differing, Fading};
use crate::flow::{State, Unrolled, keeps_nothing};
use crate::frame::{Begin, End, Frame, Reached, Word, constant, state_pairs, zip};
use crate::gates::{Bit, Gates, NO};
use crate::idle::fix;
use crate::known::Known;
use crate::phases::Phases;
use crate::rest::Rest;
use crate::solve::{Verdict, equality};
use imogene_hdl::Levels;
use std::collections::{HashMap, HashSet};
use std::sync::{Arc, OnceLock};

/// Bits of words that are few enough to be tried all.
const SHORT: [u32; 3] = [16, 20, 24];

/// Judges the mutants of a design with controls.
pub struct Judge {
    of: Reached,
    /// Which state each input gate is, if it is one.
    state: HashMap<usize, State>,
    known: Known,
    keeps_nothing: bool,
    /// The clock with all constants at their values, where there are any.
    fixed: Option<Frame>,
    /// A clock of the work, where inputs are held and registers hold them.
    work: Option<Frame>,
    /// The circuit over its latency, made when it is first wanted: from any clock, from the beginning of the work, the
    /// same with clocks behind it, and from rest to rest.
    flow: OnceLock<Option<Unrolled>>,
    start: [OnceLock<Option<Unrolled>>; 2],
    rest: OnceLock<Option<Rest>>,
    /// Some clocks, at any time and of the work.
    fading: [OnceLock<Option<Fading>>; 2],
}

impl Judge {
    /// Of a design with controls, of which this is known without them.
    pub fn new(controls: &Controls, known: &Known) -> Judge {
        let levels = Arc::new(Levels::of(&controls.design));
        let mut gates = Gates::new();
        let mut begin = Begin::any(&levels, &mut gates);
        let held: HashSet<usize> = controls.registers().collect();
        for register in &held {
            let place = levels.flops[*register].output;
            *begin.register_mut(*register) = constant(levels.words[place as usize]);
        }
        let registers = (0..levels.flops.len()).filter(|index| !held.contains(index));
        let registers: Vec<usize> = registers.collect();
        let mut of = known.clock(gates, begin, registers);
        let work = (!known.held.is_empty()).then(|| {
            let begin = known.held.work(of.begin.clone(), &of.registers);
            begin.clock(&mut of.gates)
        });
        let mut constants = known.constants.iter().flatten();
        let fixed = constants.any(Option::is_some).then(|| {
            let mut begin = of.begin.clone();
            fix(&known.constants, &mut begin, &of.registers);
            begin.clock(&mut of.gates)
        });
        let state = State::of(&of.begin);
        let keeps_nothing = keeps_nothing(&of.gates, &of.clock.end, &state, known.latency);
        of.gates = of.gates.frozen();
        Judge {
            of,
            state,
            known: known.clone(),
            keeps_nothing,
            fixed,
            work,
            rest: OnceLock::new(),
            fading: Default::default(),
            flow: OnceLock::new(),
            start: Default::default(),
        }
    }

    /// Is the mutant that upsets make proven to be none with half the effort? Where inputs are held while the
    /// circuit works, only one clock is tried.
    pub fn is_soon_same(&self, upsets: &[Upset]) -> bool {
        let few = self.known.effort / 2;
        if self.work.is_none() {
            return self.by_clocks(upsets, few) == Verdict::Equivalent;
        }
        let mut gates = self.of.gates.clone();
        let bad = self.of.clock.with(upsets, [], &mut gates);
        self.known.always_holds && self.of_a_clock(&bad, &mut gates, few) == Verdict::Equivalent
    }

    /// Is nothing of the state left once the latency passed, in circuit and mutant?
    fn forgets(&self, bad: &End, gates: &Gates) -> bool {
        self.keeps_nothing && keeps_nothing(gates, bad, &self.state, self.known.latency)
    }

    /// What is known of the mutant that upsets make.
    pub fn judge(&self, upsets: &[Upset]) -> Verdict {
        let verdict = self.by_clocks(upsets, self.known.effort);
        let phases = self.known.phases.as_ref();
        let is_same = |phases: &Phases| phases.are_same(&self.of, self.known.effort, upsets);
        let is_equivalent =
            verdict == Verdict::Equivalent || phases.is_some_and(is_same) || self.fades(upsets);
        match is_equivalent {
            true => Verdict::Equivalent,
            false => verdict,
        }
    }

    /// Is nothing left in the end of what the mutant makes differ? Where inputs are held while the circuit works, that
    /// was asked with these.
    fn fades(&self, upsets: &[Upset]) -> bool {
        if self.work.is_some() {
            return false;
        }
        let make = || Fading::of(&self.of, &self.known, None);
        let Some(fading) = self.fading[0].get_or_init(make) else {
            return false;
        };
        let differing = fading.differing(&self.known, upsets);
        differing.is_some_and(|found| fading.begins_alike(&self.known, upsets, &found))
    }

    /// The same without a look at the phases of the work.
    fn by_clocks(&self, upsets: &[Upset], conflicts: u64) -> Verdict {
        let mut gates = self.of.gates.clone();
        let bad = self.of.clock.with(upsets, [], &mut gates);
        let of_a_clock = self.of_a_clock(&bad, &mut gates, conflicts);
        let is_same =
            of_a_clock == Verdict::Equivalent || self.is_same_by_constants(upsets, conflicts);
        if is_same && self.known.always_holds {
            return Verdict::Equivalent;
        }
        if self.is_same_at_work(upsets) || self.is_same_from_rest(upsets) {
            return Verdict::Equivalent;
        }
        let is_equal = of_a_clock == Verdict::Equivalent;
        if self.forgets(&bad, &gates) && (is_equal || self.is_same_in_the_end(upsets, conflicts)) {
            return Verdict::Equivalent;
        }
        match of_a_clock {
            Verdict::Equivalent => Verdict::Undecided,
            other => other,
        }
    }

    /// Bits of words, no more than `most`, where the mutant can differ for words of no more bits alone: what all of
    /// these show decides. The circuit has one input, and each result comes from one word of it.
    pub fn short(&self, upsets: &[Upset], most: u32) -> Option<u32> {
        let [input] = self.of.begin.levels.inputs() else {
            return None;
        };
        let mut gates = self.of.gates.clone();
        let bad = self.of.clock.with(upsets, [], &mut gates);
        if !self.forgets(&bad, &gates) {
            return None;
        }
        let flow = self.flow()?;
        let (all, ends) = flow.with(upsets, &[]);
        let later = (1..=self.known.latency).flat_map(|clock| flow.begin(clock).at(input.place));
        let later: Vec<usize> = later.map(|bit| bit.gate()).collect();
        let depends = all.depending(&later);
        let mut outputs = ends.last()?.iter().flat_map(|end| &end.outputs);
        if outputs.any(|bit| depends[bit.gate()]) {
            return None;
        }
        let pairs = self.pairs(&bad, &gates);
        let word = self.of.begin.at(input.place);
        let shorter = SHORT.into_iter().filter(|bits| *bits < most);
        shorter.chain([most]).find(|bits| {
            let beyond = word.iter().skip(*bits as usize);
            let is_long = beyond.fold(NO, |any, bit| gates.or(any, *bit));
            let assumed = [&self.of.assumed[..], &[is_long]].concat();
            let verdict = equality(pairs.clone(), &assumed, &mut gates, self.known.effort);
            verdict == Verdict::Equivalent
        })
    }

    /// Of each mutant, does none before it come to the same, gate by gate?
    pub fn are_distinct<'a>(&self, mutants: impl Iterator<Item = &'a [Upset]>) -> Vec<bool> {
        let mut gates = self.of.gates.clone();
        let mut seen = HashSet::new();
        let is_new = mutants.map(|upsets| {
            let end = self.of.clock.with(upsets, [], &mut gates);
            seen.insert((end.outputs, end.registers, end.memories))
        });
        is_new.collect()
    }

    /// The circuit over its latency.
    fn flow(&self) -> Option<&Unrolled> {
        let Reached { gates, begin, .. } = &self.of;
        let clocks = self.known.latency + 1;
        let make = || Unrolled::new(gates, begin, clocks, |_, _, _| ());
        self.flow.get_or_init(make).as_ref()
    }

    /// Is what comes out after the latency equal?
    fn is_same_in_the_end(&self, upsets: &[Upset], conflicts: u64) -> bool {
        let Some(flow) = self.flow() else {
            return false;
        };
        let (mut gates, ends) = flow.with(upsets, &[]);
        let last = ends.last().expect("there is a first clock");
        let pairs = zip(&last[0].outputs, &last[1].outputs);
        let zeros = flow.zeros(&self.known.zeros);
        equality(pairs, &zeros, &mut gates, conflicts) == Verdict::Equivalent
    }

    /// Are circuit and mutant the same while the work goes on, but for bits that nothing shows, and do they come to the
    /// same state when it begins, whatever was before?
    fn is_same_at_work(&self, upsets: &[Upset]) -> bool {
        let Some(work) = &self.work else {
            return false;
        };
        let mut gates = self.of.gates.clone();
        let bad = work.with(upsets, [], &mut gates);
        let pairs = state_pairs(&self.of.registers, &work.end, &bad);
        let pairs = pairs.chain(zip(&work.end.outputs, &bad.outputs)).collect();
        let verdict = equality(pairs, &self.of.assumed, &mut gates, self.known.effort);
        if verdict == Verdict::Equivalent {
            return self.begins_alike(upsets, None);
        }
        let make = || Fading::of(&self.of, &self.known, Some(&self.known.held));
        let Some(fading) = self.fading[1].get_or_init(make) else {
            return false;
        };
        let differing = fading.differing(&self.known, upsets);
        differing.is_some_and(|found| self.begins_alike(upsets, Some((fading, &found))))
    }

    /// Are the results of a work equal, and the state behind its latency but for bits that differed before?
    fn begins_alike(&self, upsets: &[Upset], faded: Option<(&Fading, &Differing)>) -> bool {
        let (gates, more) = match faded {
            None => (&self.of.gates, 0),
            Some((fading, _)) => (&fading.gates, fading::CLOCKS),
        };
        let start = self.start[usize::from(faded.is_some())].get_or_init(|| {
            let held = &self.known.held;
            held.since_start(gates, &self.of.begin, self.known.latency, more)
        });
        let Some(start) = start else { return false };
        let none = Differing::default();
        let differing = faded.map_or(&none, |(_, found)| found);
        let first = faded.map(|(fading, found)| fading.begins(start.begin(0), &found.bits));
        let zeros = start.zeros(&self.known.zeros);
        let begins = |gates: &mut Gates, register, words: [&Word; 2]| {
            differing.settled((gates, self.known.effort), register, words, &zeros)
        };
        let (mut gates, ends) = start.with_state(upsets, &first.unwrap_or_default(), begins);
        let last = ends.iter().rev().take(more + 1);
        let state = last.flat_map(|end| fading::state(&self.of.registers, end, &differing.bits));
        let state = state.map(|(_, pair)| pair);
        let pairs = self.results(&ends).chain(state).collect();
        let conflicts = self.known.effort / if faded.is_some() { 1 } else { 10 };
        equality(pairs, &zeros, &mut gates, conflicts) == Verdict::Equivalent
    }

    /// Does the mutant do what the circuit does from rest to rest?
    fn is_same_from_rest(&self, upsets: &[Upset]) -> bool {
        let make = || Rest::of(&self.of, &self.known.idle, self.known.latency);
        let rest = self.rest.get_or_init(make).as_ref();
        rest.is_some_and(|rest| rest.is_same(self.known.effort, upsets))
    }

    /// The outputs from the beginning of the work on: before the first result nothing counts but the first output,
    /// which tells that there is none.
    fn results<'a>(&self, ends: &'a [[End; 2]]) -> impl Iterator<Item = (Bit, Bit)> + use<'a> {
        let latency = self.known.latency;
        let from_start = ends.iter().skip(latency).enumerate();
        from_start.flat_map(move |(clock, [good, bad])| {
            let all = zip(&good.outputs, &bad.outputs);
            let count = if clock < latency { 1 } else { all.len() };
            all.into_iter().take(count)
        })
    }

    /// What is known by outputs and next states of one clock.
    fn of_a_clock(&self, bad: &End, gates: &mut Gates, conflicts: u64) -> Verdict {
        let pairs = self.pairs(bad, gates);
        equality(pairs, &self.of.assumed, gates, conflicts)
    }

    /// Are outputs and next states equal after a clock that begins with all constants at their values, constants among
    /// these states? Then nothing counts that is read beside a constant which hides it.
    fn is_same_by_constants(&self, upsets: &[Upset], conflicts: u64) -> bool {
        let Some(fixed) = &self.fixed else {
            return false;
        };
        let mut gates = self.of.gates.clone();
        let good = &fixed.end;
        let bad = fixed.with(upsets, [], &mut gates);
        let mut pairs = zip(&good.outputs, &bad.outputs);
        for (register, constants) in self.of.registers.iter().zip(&self.known.constants) {
            let words = zip(&good.registers[*register], &bad.registers[*register]);
            let constant = words.into_iter().zip(constants);
            let constant = constant.filter(|(_, constant)| constant.is_some());
            pairs.extend(constant.map(|(pair, _)| pair));
        }
        let pairs = self.with_read(pairs, [good, &bad], &gates);
        equality(pairs, &self.of.assumed, &mut gates, conflicts) == Verdict::Equivalent
    }

    /// Outputs of circuit and mutant, and next states of all bits that either of them reads for an output.
    fn pairs(&self, bad: &End, gates: &Gates) -> Vec<(Bit, Bit)> {
        let good = &self.of.clock.end;
        self.with_read(zip(&good.outputs, &bad.outputs), [good, bad], gates)
    }

    /// The same pairs, and the next states of all bits that are read for them.
    fn with_read(
        &self,
        mut pairs: Vec<(Bit, Bit)>,
        [good, bad]: [&End; 2],
        gates: &Gates,
    ) -> Vec<(Bit, Bit)> {
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
