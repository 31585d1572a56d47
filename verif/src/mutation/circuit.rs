//! Every mutant of the circuit itself: each bit of each net stuck or inverted, each operator exchanged, each enable and
//! each initial value of a register changed, in every instance.
//!
//! Sites are compiled in groups into one program of the built-in engine; a mutant is an upset of it. What no stimulus
//! kills goes to the solver.

use super::score::{Fate, Kill, MutationError, MutationReport, Options};
use super::vectors::{Vectors, vectors};
use crate::subject::Subject;
use imogene_compiled::{Program, Simulation};
use imogene_faults::{CONFLICTS, Contract, Controls, Judge, Known, Mutant, Upset, Verdict, sites};
use imogene_hdl::{Design, Levels};
use rayon::prelude::*;
use std::sync::Arc;
use std::time::Instant;

/// Sites of a group: as few as let one compilation serve thousands of mutants, so that they hardly slow it.
const GROUP: usize = 24;

/// Inputs that are 1 in the clock with which the work of a unit begins.
const BEGINS: [&str; 4] = ["pixel", "start", "go", "valid"];

const DIFFERS: &str = "It differs in some state; no stimulus came to one whose outputs show it";

fn undecided() -> String {
    format!("Undecided: no stimulus found a difference, and no proof within {CONFLICTS} conflicts")
}

/// How many mutants a circuit has.
pub fn count(design: &Design) -> u64 {
    let all = Controls::new(design, &sites(design));
    let of_power_up = Controls::of_power_up(design);
    (all.mutants().len() + of_power_up.mutants().len()) as u64
}

/// Runs every mutant of a unit's circuit on the unit's stimulus, and judges those that nothing killed.
///
/// `on_done` is called once for each mutant, from any thread.
pub fn run(
    subject: &Subject,
    design: &Design,
    options: &Options,
    on_done: impl Fn() + Sync,
) -> Result<MutationReport, MutationError> {
    let started = Instant::now();
    let vectors = vectors(subject, options);
    let known = Known::new(design, &contract(subject, design));
    let mut report = MutationReport::new(subject);
    let mut run = |controls: &Controls, judge: &(dyn Fn(&Mutant) -> Fate + Sync)| {
        let program = Arc::new(Program::in_lanes(&controls.design, &[]));
        if let [Some((stimulus, clock))] = kills(&program, &[&[]], &vectors, &|| ())[..] {
            let unit = subject.name.clone();
            return Err(MutationError::Baseline(unit, stimulus, clock));
        }
        let mutants = controls.mutants();
        let upsets: Vec<&[Upset]> = mutants.iter().map(|mutant| &mutant.upsets[..]).collect();
        let kills = kills(&program, &upsets, &vectors, &on_done);
        let fates = mutants
            .par_iter()
            .zip(kills)
            .map(|(mutant, kill)| match kill {
                Some(kill) => Fate::Killed(kill),
                None => {
                    let fate = judge(mutant);
                    on_done();
                    fate
                }
            });
        let fates: Vec<Fate> = fates.collect();
        for (mutant, fate) in mutants.iter().zip(fates) {
            report.count(fate, options.clocks, || controls.describe(mutant));
        }
        Ok(())
    };
    for group in sites(design).chunks(GROUP) {
        let controls = Controls::new(design, group);
        let judge = Judge::new(&controls, &known);
        run(&controls, &|mutant| match judge.judge(&mutant.upsets) {
            Verdict::Equivalent => Fate::Equivalent,
            Verdict::Differs => Fate::Survived(DIFFERS.to_owned()),
            Verdict::Undecided => Fate::Survived(undecided()),
        })?;
    }
    run(&Controls::of_power_up(design), &|mutant| {
        let (register, _) = mutant.upsets[0];
        match known.is_forgotten(register, mutant.bit) {
            true => Fate::Forgotten,
            false => Fate::Survived(DIFFERS.to_owned()),
        }
    })?;
    Ok(report.ended(started))
}

/// What a unit may rely on, and what the proofs may: the second differences of a PE2 are even; behind a row of a root
/// stand a remainder and its root.
fn contract(subject: &Subject, design: &Design) -> Contract {
    let inputs = subject.inputs.iter().map(|signal| signal.name.clone());
    let is_even = |name: &String| {
        let last = name.rsplit('_').next().unwrap_or_default();
        last == "a2" || last == "b2"
    };
    let points = Levels::of(design).points;
    let remainders = points
        .iter()
        .filter_map(|(path, _)| Some((path, path.strip_suffix(".next_remainder")?)));
    let pairs = remainders.map(|(path, stage)| [path.clone(), format!("{stage}.next_root")]);
    Contract {
        even: inputs.filter(is_even).collect(),
        begins: BEGINS.map(str::to_owned).to_vec(),
        remainders: pairs.collect(),
        restores: subject.name != "square_root_non_restoring",
        latency: subject.latency,
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use imogene_contract::Request;

    /// Behind every row there is a remainder of a known size.
    #[test]
    fn what_is_known_of_roots_is_proven() {
        for unit in ["square_root", "square_root_non_restoring", "quadric_pe"] {
            let request = Request::given(unit, 16, &[]).expect("a unit of the catalogue");
            let subject = crate::unit::subject(&request).expect("its defaults are legal");
            let design = imogene_rtl::emit::design(&request).expect("a legal request");
            let known = Known::new(&design, &contract(&subject, &design));
            assert_eq!(known.proven_remainders(), 16, "{unit}");
        }
    }
}
