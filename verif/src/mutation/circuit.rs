//! Every mutant of the circuit itself: each bit of each net stuck or inverted, each operator exchanged, each enable
//! and each initial value of a register changed, in every instance.
//!
//! Sites are compiled in groups into one program of the built-in engine; a mutant is an upset of it. What no stimulus
//! kills goes to the solver.

use super::contract::{contract, counts_with, states};
use super::score::{Fate, Kill, MutationError, MutationReport, Options};
use super::vectors::{Vectors, vectors};
use crate::subject::Subject;
use imogene_compiled::{Program, Simulation};
use imogene_faults::{
    Contract, Controls, Judge, Key, Known, Mutant, Site, Upset, Verdict, power_up, sites,
};
use imogene_hdl::Design;
use rayon::prelude::*;
use std::collections::HashSet;
use std::ops::Range;
use std::sync::{Arc, OnceLock};
use std::time::Instant;

/// Sites of a group: as few as let one compilation serve thousands of mutants, so that they hardly slow it.
const GROUP: usize = 24;

/// Stimuli before the first proofs.
const FIRST: u64 = 150;

/// Stimuli before the proofs of words that are held.
const SECOND: u64 = 3_000;

/// Bits of words of which all are run before the rest of the stimuli.
const SHORT: u32 = 24;

/// Words that one instance runs on.
const PIECE: u64 = 1 << 20;

/// Stimuli between two looks at what is left.
const BATCH: usize = 600;

/// How many mutants a circuit has.
pub fn count(design: &Design) -> u64 {
    let all = [sites(design), power_up(design)].concat();
    Controls::new(design, &all).mutants().len() as u64
}

/// Runs every mutant of a unit's circuit on the unit's stimulus, and judges those that nothing killed; those that
/// differ in some state run on, as long as there are stimuli.
///
/// `on_done` is called once for each mutant, from any thread.
pub fn run(
    subject: &Subject,
    design: &Design,
    options: &Options,
    on_done: impl Fn() + Sync,
) -> Result<MutationReport, MutationError> {
    let started = Instant::now();
    let options = &options.reaching(subject);
    let contract = Contract {
        seen: states(subject, design, options),
        counts_with: counts_with(subject, options),
        ..contract(subject, design)
    };
    let known = Known::new(design, &contract).with_effort(options.effort);
    let mut report = MutationReport::of(&subject.name, &subject.options);
    let campaign = Campaign {
        subject,
        clocks: options.clocks,
        effort: options.effort,
        bare: Arc::new(Program::on_one_stimulus(design, &[])),
        on_done: &on_done,
    };
    let end = options.stimuli;
    let vectors = campaign.stimuli(0..FIRST.min(end))?;
    let (sites, power_up) = (sites(design), power_up(design));
    let groups: Vec<&[Site]> = sites.chunks(GROUP).chain([&power_up[..]]).collect();
    let first = groups.into_par_iter().map(|sites| {
        let group = Group::of(design, sites, |_| true);
        let killed = group.kills(&vectors, &on_done);
        let judge = group.judge(&known);
        let fates = group.mutants.par_iter().zip(killed).map(|(mutant, kill)| {
            let fate = match (kill, &judge) {
                (Some(kill), _) => return Ok(Fate::Killed(kill)),
                (None, Some(judge)) if judge.is_soon_same(&mutant.upsets) => Fate::Equivalent,
                (None, None) if is_forgotten(&known, mutant) => Fate::Forgotten,
                _ => return Err(group.controls.key(mutant)),
            };
            on_done();
            Ok(fate)
        });
        fates.collect::<Vec<_>>()
    });
    let first: Vec<Vec<_>> = first.collect();
    let mut alive = vec![];
    for fate in first.into_iter().flatten() {
        match fate {
            Ok(fate) => report.count(fate, options.clocks, String::new),
            Err(key) => alive.push(key),
        }
    }
    let mut groups = regrouped(design, alive);
    campaign.kill(&mut groups, FIRST..SECOND.min(end), &mut report)?;
    campaign.prove(&mut groups, &known, &mut report);
    campaign.exhaust(&mut groups, &known, SHORT, &mut report)?;
    campaign.kill(&mut groups, SECOND..end, &mut report)?;
    if options.word_bits > SHORT {
        campaign.exhaust(&mut groups, &known, options.word_bits, &mut report)?;
    }
    for group in groups {
        for (mutant, reason) in group.mutants.iter().zip(group.reasons) {
            on_done();
            let mutant = || group.controls.describe(mutant);
            report.count(Fate::Survived(reason), options.clocks, mutant);
        }
    }
    Ok(report.ended(started))
}

/// All mutants of one unit.
struct Campaign<'a, F> {
    subject: &'a Subject,
    clocks: usize,
    effort: u64,
    /// The circuit as it is.
    bare: Arc<Program>,
    on_done: &'a F,
}

impl<F: Fn() + Sync> Campaign<'_, F> {
    /// Stimuli on which the circuit as it is does what the golden model states.
    fn stimuli(&self, seeds: Range<u64>) -> Result<Vec<Vectors>, MutationError> {
        let begin = seeds.start as usize;
        self.checked(vectors(self.subject, self.clocks, seeds), begin)
    }

    /// The same of these, the first of which has a number.
    fn checked(&self, vectors: Vec<Vectors>, begin: usize) -> Result<Vec<Vectors>, MutationError> {
        match kills(&self.bare, &[&[]], &vectors, &|| ())[..] {
            [Some((stimulus, clock))] => {
                let (unit, stimulus) = (self.subject.name.clone(), begin + stimulus);
                Err(MutationError::Baseline(unit, stimulus, clock))
            }
            _ => Ok(vectors),
        }
    }

    /// Drops what these stimuli kill.
    fn kill(
        &self,
        groups: &mut Vec<Group>,
        seeds: Range<u64>,
        report: &mut MutationReport,
    ) -> Result<(), MutationError> {
        for begin in seeds.clone().step_by(BATCH) {
            groups.retain(|group| !group.mutants.is_empty());
            if groups.is_empty() {
                break;
            }
            let vectors = self.stimuli(begin..seeds.end.min(begin + BATCH as u64))?;
            self.kill_by(groups, &vectors, begin as usize, report);
        }
        Ok(())
    }

    /// Drops what these stimuli kill, the first of which has a number.
    fn kill_by(
        &self,
        groups: &mut [Group],
        vectors: &[Vectors],
        begin: usize,
        report: &mut MutationReport,
    ) {
        let kills = groups.par_iter_mut().flat_map_iter(|group| {
            let kills = group.kills(vectors, self.on_done);
            group.keep(|place| kills[place].is_none());
            kills.into_iter().flatten()
        });
        for (stimulus, clock) in kills.collect::<Vec<_>>() {
            let kill = (begin + stimulus, clock);
            report.count(Fate::Killed(kill), self.clocks, String::new);
        }
    }

    /// Drops what is proven equivalent, and tells of all else what is known of it.
    fn prove(&self, groups: &mut [Group], known: &Known, report: &mut MutationReport) {
        let equivalent = groups.par_iter_mut().map(|group| {
            let judge = group.judge(known);
            let verdicts = group.mutants.par_iter().map(|mutant| {
                let judge = judge.as_ref();
                let verdict = judge.map_or(Verdict::Differs, |judge| judge.judge(&mutant.upsets));
                if verdict == Verdict::Equivalent {
                    (self.on_done)();
                }
                verdict
            });
            let verdicts: Vec<Verdict> = verdicts.collect();
            let reasons = verdicts.iter();
            let reasons = reasons.map(|verdict| reason(*verdict, self.effort));
            group.reasons = reasons.collect();
            group.keep(|place| verdicts[place] != Verdict::Equivalent);
            verdicts.len() - group.mutants.len()
        });
        self.are_equivalent(equivalent.sum(), report);
    }

    fn are_equivalent(&self, count: usize, report: &mut MutationReport) {
        for _ in 0..count {
            report.count(Fate::Equivalent, self.clocks, String::new);
        }
    }

    /// Decides what can only differ for words of so many bits, by all of these.
    fn exhaust(
        &self,
        groups: &mut [Group],
        known: &Known,
        longest: u32,
        report: &mut MutationReport,
    ) -> Result<(), MutationError> {
        let [input] = &self.subject.inputs[..] else {
            return Ok(());
        };
        let latency = self.subject.latency;
        let shown = groups.par_iter_mut().flat_map_iter(|group| {
            let judge = group.judge(known);
            let short = |mutant: &Mutant| judge.as_ref()?.short(&mutant.upsets, longest);
            group.shorts = group.mutants.par_iter().map(short).collect();
            let upsets = group.mutants.iter().map(|mutant| &mutant.upsets[..]);
            let are_distinct = judge.map(|judge| judge.are_distinct(upsets));
            group.words_that_show(latency, &are_distinct.unwrap_or_default())
        });
        let shown: Vec<u64> = shown.collect();
        let words = shown.into_iter().map(|word| vec![input.value(word)]);
        let stimulus: Vec<Vec<i64>> = words.chain(vec![vec![0]; latency]).collect();
        let vectors = self.checked(vec![Vectors::new(self.subject, &stimulus)], 0)?;
        self.kill_by(groups, &vectors, 0, report);
        let equivalent = groups.iter_mut().map(|group| {
            let shorts = group.shorts.clone();
            group.keep(|place| shorts[place].is_none());
            let equivalent = shorts.len() - group.mutants.len();
            (0..equivalent).for_each(|_| (self.on_done)());
            equivalent
        });
        self.are_equivalent(equivalent.sum(), report);
        Ok(())
    }
}

/// What is known of a mutant that no stimulus killed.
fn reason(verdict: Verdict, effort: u64) -> String {
    match verdict {
        Verdict::Undecided => format!(
            "Undecided: no stimulus found a difference, and no proof within {effort} conflicts"
        ),
        _ => "It differs in some state; no stimulus came to one whose outputs show it".into(),
    }
}

fn is_forgotten(known: &Known, mutant: &Mutant) -> bool {
    let (register, _) = mutant.upsets[0];
    known.is_forgotten(register, mutant.bit)
}

/// Mutants that one compilation serves.
struct Group {
    controls: Controls,
    program: Arc<Program>,
    mutants: Vec<Mutant>,
    is_of_power_up: bool,
    /// Why each survives so far, where that is known.
    reasons: Vec<String>,
    /// Bits of the only words for which each can differ, where they are few.
    shorts: Vec<Option<u32>>,
}

impl Group {
    /// Of some sites, all of what is held at power-up or none: the mutants that are wanted.
    fn of(design: &Design, sites: &[Site], wanted: impl Fn(&Key) -> bool) -> Group {
        let controls = Controls::new(design, sites);
        let mut mutants = controls.mutants();
        mutants.retain(|mutant| wanted(&controls.key(mutant)));
        Group {
            program: Arc::new(Program::on_one_stimulus(&controls.design, &[])),
            is_of_power_up: sites.iter().all(Site::is_of_power_up),
            controls,
            mutants,
            reasons: vec![],
            shorts: vec![],
        }
    }

    /// None of what is held at power-up.
    fn judge(&self, known: &Known) -> Option<Judge> {
        (!self.is_of_power_up).then(|| Judge::new(&self.controls, known))
    }

    fn kills(&self, vectors: &[Vectors], on_kill: &(impl Fn() + Sync)) -> Vec<Option<Kill>> {
        let upsets = self.mutants.iter().map(|mutant| &mutant.upsets[..]);
        let upsets: Vec<&[Upset]> = upsets.collect();
        kills(&self.program, &upsets, vectors, on_kill)
    }

    /// Words among which are some that show each mutant that differs for words of few bits, if it does: all of these
    /// are run beside the circuit as it is, of mutants that are the same one.
    fn words_that_show(&self, latency: usize, are_distinct: &[bool]) -> Vec<u64> {
        let mutants = self.mutants.iter().zip(&self.shorts).zip(are_distinct);
        let mutants: Vec<(&Mutant, u32)> = mutants
            .filter(|(_, is_distinct)| **is_distinct)
            .filter_map(|((mutant, bits), _)| Some((mutant, (*bits)?)))
            .collect();
        let lanes = self.program.lanes();
        let shown = mutants.par_chunks(lanes - 1).flat_map_iter(|mutants| {
            let bits = mutants.iter().map(|(_, bits)| *bits).max().unwrap_or(0);
            let found: Vec<OnceLock<u64>> = vec![OnceLock::new(); mutants.len()];
            let words = 1u64 << bits;
            let pieces = (0..words.div_ceil(PIECE) as u32).into_par_iter();
            pieces.for_each(|piece| {
                let first = u64::from(piece) * PIECE;
                let end = (first + PIECE).min(words) + latency as u64;
                self.run_words(first..end, latency, mutants, &found);
            });
            let found = found.into_iter().filter_map(OnceLock::into_inner);
            found.flat_map(move |word| word.saturating_sub(2 * latency as u64)..=word)
        });
        shown.collect()
    }

    /// Notes of each mutant a word after which outputs are not those of the circuit as it is, which has the first lane.
    fn run_words(
        &self,
        words: Range<u64>,
        latency: usize,
        mutants: &[(&Mutant, u32)],
        found: &[OnceLock<u64>],
    ) {
        if found.iter().all(|word| word.get().is_some()) {
            return;
        }
        let mut simulation = Simulation::new(&self.program);
        for (lane, (mutant, _)) in mutants.iter().enumerate() {
            for (register, word) in &mutant.upsets {
                simulation.upset(lane + 1, *register, *word);
            }
        }
        let lanes = simulation.lanes();
        for (clock, word) in words.enumerate() {
            let given = simulation.step(&[&[word as i64]]);
            for port in given.chunks_exact(lanes) {
                let differs = |own: &u64| clock >= latency && *own != port[0];
                if port.iter().any(differs) {
                    let pairs = port[1..].iter().zip(found);
                    let shown = pairs.filter(|(own, _)| differs(own));
                    shown.for_each(|(_, found)| _ = found.set(word));
                }
            }
        }
    }

    /// Keeps the mutants at some places.
    fn keep(&mut self, is_kept: impl Fn(usize) -> bool) {
        let mut places = 0..;
        self.mutants.retain(|_| places.next().is_some_and(&is_kept));
        let mut places = 0..;
        self.reasons.retain(|_| places.next().is_some_and(&is_kept));
        let mut places = 0..;
        self.shorts.retain(|_| places.next().is_some_and(&is_kept));
    }
}

/// The mutants that are left, of many sites each, in groups as before.
fn regrouped(design: &Design, alive: Vec<Key>) -> Vec<Group> {
    let mut seen = HashSet::new();
    let sites = alive.iter().map(|key| key.site);
    let sites = sites.filter(|site| seen.insert(*site));
    let (power_up, sites): (Vec<Site>, Vec<Site>) = sites.partition(Site::is_of_power_up);
    let keys: HashSet<Key> = alive.into_iter().collect();
    let groups = sites.chunks(GROUP).chain(power_up.chunks(usize::MAX));
    let groups: Vec<&[Site]> = groups.collect();
    let group = |sites| Group::of(design, sites, |key| keys.contains(key));
    groups.into_par_iter().map(group).collect()
}

/// The first stimulus and clock that show each mutant, which these upsets make; `on_kill` is called for each that one
/// shows. Mutants run side by side, and those that a stimulus did not kill run together again with the next.
fn kills(
    program: &Arc<Program>,
    mutants: &[&[Upset]],
    vectors: &[Vectors],
    on_kill: &(impl Fn() + Sync),
) -> Vec<Option<Kill>> {
    let mut kills = vec![None; mutants.len()];
    let mut alive: Vec<usize> = (0..mutants.len()).collect();
    for (stimulus, vectors) in vectors.iter().enumerate() {
        let groups = alive.par_chunks(program.lanes());
        let clocks = groups.flat_map_iter(|group| {
            let upsets: Vec<&[Upset]> = group.iter().map(|mutant| mutants[*mutant]).collect();
            differences(program, &upsets, vectors)
        });
        let clocks: Vec<Option<usize>> = clocks.collect();
        for (mutant, clock) in alive.iter().zip(clocks) {
            kills[*mutant] = clock.map(|clock| (stimulus, clock));
            kills[*mutant].iter().for_each(|_| on_kill());
        }
        alive.retain(|mutant| kills[*mutant].is_none());
    }
    kills
}

/// The first clock of a stimulus that shows each of as many mutants as there are lanes, or fewer.
fn differences(
    program: &Arc<Program>,
    mutants: &[&[Upset]],
    vectors: &Vectors,
) -> Vec<Option<usize>> {
    let mut simulation = Simulation::new(program);
    for (lane, upsets) in mutants.iter().enumerate() {
        for (register, word) in *upsets {
            simulation.upset(lane, *register, *word);
        }
    }
    let mut found = vec![None; mutants.len()];
    vectors.first(|clock, inputs, stated| {
        simulation.set_all(inputs.iter().copied());
        simulation.clock();
        let words = simulation.outputs();
        for (lane, found) in found.iter_mut().enumerate() {
            let words = words[lane..].iter().step_by(program.lanes());
            if found.is_none() && stated.differs(words) {
                *found = Some(clock);
            }
        }
        found.iter().all(Option::is_some)
    });
    found
}
