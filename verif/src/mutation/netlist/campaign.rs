//! The killing: every mutant on the unit's stimulus against the golden model.

use super::elaborate::all_mutants;
use super::mutant::{Mutant, selector};
use crate::engine::design::Source;
use crate::engine::verilator::Model;
use crate::mutation::score::{Kill, MutationError, Options};
use crate::mutation::vectors::vectors;
use crate::subject::Subject;
use rayon::prelude::*;
use std::path::Path;

/// Where each mutant was killed: stimulus and clock.
pub(super) fn run(
    subject: &Subject,
    top: &str,
    folder: &Path,
    mutants: &[Mutant],
    options: &Options,
) -> Result<Vec<Option<Kill>>, MutationError> {
    let text = all_mutants(folder, top, mutants)?;
    let mut inputs = subject.inputs.clone();
    inputs.push(selector(mutants.len()));
    let model = Model::compile(&Source {
        top,
        text: &text,
        inputs: &inputs,
        outputs: &subject.outputs,
    })?;
    let vectors = vectors(subject, options.clocks, 0..options.stimuli);
    let first = |mutant: usize| {
        let mut all = vectors.iter().enumerate();
        all.find_map(|(stimulus, vectors)| {
            let mut unit = model.instance();
            let mut found = vec![0; subject.outputs.len()];
            let clock = vectors.first(|_, given, stated| {
                let given: Vec<u64> = given.iter().copied().chain([mutant as u64]).collect();
                unit.clock_words(&given, &mut found);
                stated.differs(&found)
            })?;
            Some((stimulus, clock))
        })
    };
    if let Some((stimulus, clock)) = first(0) {
        let unit = subject.name.clone();
        return Err(MutationError::Baseline(unit, stimulus, clock));
    }
    let kills = mutants.par_iter().map(|mutant| first(mutant.number));
    Ok(kills.collect())
}
