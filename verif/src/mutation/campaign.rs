//! The killing: every mutant on the unit's stimulus against the golden model.

use super::netlist;
use super::score::{Mutant, MutationError, Options, selector};
use crate::engine::design::Source;
use crate::engine::verilator::{Model, VerilatedUnit};
use crate::subject::Subject;
use rayon::prelude::*;
use std::path::Path;

/// One stimulus and what the golden model states of it, as words on the ports.
struct Vectors {
    inputs: Vec<Vec<u64>>,
    expected: Vec<Vec<Option<u64>>>,
}

impl Vectors {
    fn new(subject: &Subject, clocks: usize, seed: u64) -> Vectors {
        let mut golden = (subject.golden)();
        let stimulus = subject.seeded_stimulus(clocks, seed);
        let expected = stimulus.iter().map(|inputs| {
            let stated = golden.clock(inputs).into_iter().zip(&subject.outputs);
            stated
                .map(|(value, signal)| Some(signal.bits(value?)))
                .collect()
        });
        let expected = expected.collect();
        let words = stimulus.iter().map(|inputs| {
            let values = inputs.iter().zip(&subject.inputs);
            // The last word selects the mutant.
            let bits = values.map(|(value, signal)| signal.bits(*value));
            bits.chain([0]).collect()
        });
        Vectors {
            inputs: words.collect(),
            expected,
        }
    }

    /// The first clock at which a mutant differs from what is stated.
    fn first_difference(&self, mut unit: VerilatedUnit, mutant: usize) -> Option<usize> {
        let mut found = vec![0; self.expected.first()?.len()];
        self.inputs
            .iter()
            .zip(&self.expected)
            .position(|(given, expected)| {
                let mut given = given.clone();
                *given.last_mut().expect("the selector") = mutant as u64;
                unit.clock_words(&given, &mut found);
                let mut stated = found.iter().zip(expected);
                stated.any(|(found, expected)| expected.is_some_and(|e| e != *found))
            })
    }
}

/// Where each mutant was killed: stimulus and clock.
pub(super) fn run(
    subject: &Subject,
    top: &str,
    folder: &Path,
    mutants: &[Mutant],
    options: &Options,
) -> Result<Vec<Option<(usize, usize)>>, MutationError> {
    let text = netlist::all_mutants(folder, top, mutants)?;
    let mut inputs = subject.inputs.clone();
    inputs.push(selector(mutants.len()));
    let model = Model::compile(&Source {
        top,
        text: &text,
        inputs: &inputs,
        outputs: &subject.outputs,
    })?;
    let vectors: Vec<Vectors> = (0..options.stimuli)
        .into_par_iter()
        .map(|seed| Vectors::new(subject, options.clocks, seed))
        .collect();
    let first = |mutant: usize| {
        vectors.iter().enumerate().find_map(|(stimulus, vectors)| {
            let clock = vectors.first_difference(model.instance(), mutant)?;
            Some((stimulus, clock))
        })
    };
    if let Some((stimulus, clock)) = first(0) {
        return Err(MutationError::Baseline {
            unit: subject.name.clone(),
            stimulus,
            clock,
        });
    }
    Ok(mutants
        .par_iter()
        .map(|mutant| first(mutant.number))
        .collect())
}
