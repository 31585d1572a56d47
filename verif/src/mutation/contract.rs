//! What a unit may rely on, and what the proofs of its mutants may: its inputs, how its work begins, the states that it
//! comes to, and where its outputs count.

use super::score::Options;
use crate::signal::Signal;
use crate::subject::Subject;
use imogene_contract::video::MERGED;
use imogene_faults::Contract;
use imogene_hdl::{Design, Levels, Port, Simulator};
use rayon::prelude::*;
use std::collections::HashSet;
use std::ops::Range;

/// Stimuli from which facts of the states are guessed.
const SEEN: u64 = 30;

/// Inputs that are 0 before, and the words of inputs in the clocks with which it begins.
type Beginning = (Vec<String>, Vec<Vec<(String, u64)>>);

/// Inputs that are 1 in the clock with which the work of most units begins.
const BEGINS: [&str; 4] = ["pixel", "start", "go", "valid"];

/// Words of the memory of a PE2 with one.
const WORDS: u64 = 9;

/// Words of the view of a shading processor, and addresses of those of its first light.
const VIEW_WORDS: u64 = 5;
const LIGHT_WORDS: Range<u64> = 16..26;

/// What a unit may rely on, and what the proofs may: the second differences of a PE2 are even; a margin is at most
/// half the depths; a line to be smoothed has fewer than 2048 pixels; behind a row of a root
/// stand a remainder and its root.
pub fn contract(subject: &Subject, design: &Design) -> Contract {
    let zero = |signal: &Signal| {
        let last = signal.name.rsplit('_').next().unwrap_or_default();
        let bit = match last {
            "a2" | "b2" => 0,
            "margin" => signal.width - 1,
            // Of a smooth picture, below 2048.
            "x" if subject.name == "post_filter" => signal.width - 1,
            _ => return None,
        };
        Some((signal.name.clone(), bit))
    };
    let points = Levels::of(design).points;
    let (quiet, begins) = beginning(subject);
    let even = |address| (("load_address".into(), address), ("load_data".into(), 0));
    let remainders = points
        .iter()
        .filter_map(|(path, _)| Some((path, path.strip_suffix(".next_remainder")?)));
    let pairs = remainders.map(|(path, stage)| [path.clone(), format!("{stage}.next_root")]);
    Contract {
        zeros: subject.inputs.iter().filter_map(zero).collect(),
        quiet,
        begins,
        // The second differences that a PE2 with a memory is loaded with are even.
        zeros_beside: match &subject.name[..] {
            "memory_pe2" => [0, 1].map(even).to_vec(),
            _ => vec![],
        },
        held: held(subject),
        remainders: pairs.collect(),
        restores: subject.name != "square_root_non_restoring",
        latency: subject.latency + usize::from(subject.name == "programmable_pe"),
        ..Contract::default()
    }
}

/// States that the circuit comes to.
pub(super) fn states(subject: &Subject, design: &Design, options: &Options) -> Vec<Vec<u64>> {
    let seeds = (0..SEEN.min(options.stimuli)).into_par_iter();
    let states = seeds.flat_map_iter(|seed| {
        let mut simulator = Simulator::new(design);
        let ports = subject.inputs.iter();
        let ports: Vec<Port> = ports.map(|signal| simulator.port(&signal.name)).collect();
        let stimulus = subject.seeded_stimulus(options.clocks, seed);
        let states = stimulus.into_iter().map(move |inputs| {
            for ((port, signal), value) in ports.iter().zip(&subject.inputs).zip(inputs) {
                simulator.set(*port, signal.bits(value));
            }
            simulator.clock();
            simulator.registers().collect::<Vec<u64>>()
        });
        states.collect::<HashSet<_>>()
    });
    let states: HashSet<Vec<u64>> = states.collect();
    states.into_iter().collect()
}

/// Outputs that the golden model does not always state, and of each a flag of one bit that is 1 whenever it does.
pub(super) fn counts_with(subject: &Subject, options: &Options) -> Vec<(String, String)> {
    let outputs = &subject.outputs;
    let flags = outputs.iter().enumerate();
    let flags: Vec<usize> = flags
        .filter(|(_, signal)| signal.width == 1)
        .map(|(flag, _)| flag)
        .collect();
    let none = || vec![(false, vec![false; flags.len()]); outputs.len()];
    let stimuli = (0..SEEN.min(options.stimuli)).into_par_iter();
    // Of each output whether it was not stated, and beside which flags that were not 1 it was.
    let seen = stimuli.fold(none, |mut seen, seed| {
        let mut golden = (subject.golden)();
        for inputs in subject.seeded_stimulus(options.clocks, seed) {
            let words = golden(&inputs);
            for (word, (is_open, without)) in words.iter().zip(&mut seen) {
                *is_open |= word.is_none();
                let flags = flags.iter().zip(without).filter(|_| word.is_some());
                flags.for_each(|(flag, without)| *without |= words[*flag] != Some(1));
            }
        }
        seen
    });
    let seen = seen.reduce(none, |mut all, one| {
        for ((is_open, without), (other, others)) in all.iter_mut().zip(one) {
            *is_open |= other;
            without.iter_mut().zip(others).for_each(|(a, b)| *a |= b);
        }
        all
    });
    let beside = outputs
        .iter()
        .zip(seen)
        .filter_map(|(output, (is_open, without))| {
            let mut flags = flags.iter().zip(without);
            let (flag, _) = flags.find(|(_, without)| is_open && !without)?;
            Some((output.name.clone(), outputs[*flag].name.clone()))
        });
    beside.collect()
}

/// Inputs that do not change while the unit works: the words of a zone, behind the raster of an object or a volume.
fn held(subject: &Subject) -> Vec<String> {
    let names = subject.inputs.iter().map(|signal| &signal.name[..]);
    match names.collect::<Vec<_>>()[..] {
        ["valid", "start", "line", "x", "y", ref words @ ..] => {
            let words = words.iter().filter(|name| **name != "depth");
            words.map(|name| (*name).to_owned()).collect()
        }
        _ => vec![],
    }
}

/// How the work of a unit begins.
fn beginning(subject: &Subject) -> Beginning {
    let named = |names: &[&str]| -> Vec<String> {
        let inputs = subject.inputs.iter().map(|signal| &signal.name[..]);
        let named = inputs.filter(|name| names.contains(name));
        named.map(str::to_owned).collect()
    };
    let own = |name: &str, word: u64| (name.to_owned(), word);
    match &subject.name[..] {
        // All words, then a picture, and the clocks of its first line.
        "memory_pe2" => {
            let quiet = "load_valid field_start picture_start line_start pixel";
            let quiet: Vec<&str> = quiet.split(' ').collect();
            let load = |word| vec![own("load_valid", 1), own("load_address", word)];
            let loads = (0..WORDS).map(load);
            let starts = ["picture_start", "line_start"].map(|name| vec![own(name, 1)]);
            let line = std::iter::repeat_n(vec![], 15);
            (named(&quiet), loads.chain(starts).chain(line).collect())
        }
        // A word of each module.
        "line_merger" => {
            let pixels = vec![own("s_tvalid", 1), own("s_tlast", 0)];
            (named(&["s_tvalid"]), vec![pixels; MERGED])
        }
        // The words of the view and of one light.
        "lit_sphere" | "lit_sphere_nearest" | "shading_processor" => {
            let load = |address| vec![own("load_valid", 1), own("load_address", address)];
            let words = (0..VIEW_WORDS).chain(LIGHT_WORDS).map(load);
            (named(&["valid", "load_valid"]), words.collect())
        }
        // Two clocks of blanking.
        "tmds_encoder" => (vec![], vec![vec![own("de", 0)]; 2]),
        _ => {
            let quiet = named(&BEGINS);
            let begins = quiet.iter().map(|name| (name.clone(), 1)).collect();
            (quiet, vec![begins])
        }
    }
}
