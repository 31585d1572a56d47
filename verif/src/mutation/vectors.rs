//! The stimuli of a unit, and what its golden model states of them.

use crate::subject::{Inputs, Subject};
use rayon::prelude::*;
use std::ops::Range;

/// One stimulus and what the golden model states of it, as words on the ports.
pub(super) struct Vectors {
    inputs: Vec<Vec<u64>>,
    expected: Vec<Vec<Option<u64>>>,
}

/// The stimuli of a unit of these seeds.
pub(super) fn vectors(subject: &Subject, clocks: usize, seeds: Range<u64>) -> Vec<Vectors> {
    let of = |seed| Vectors::new(subject, &subject.seeded_stimulus(clocks, seed));
    seeds.into_par_iter().map(of).collect()
}

impl Vectors {
    /// Of a stimulus.
    pub(super) fn new(subject: &Subject, stimulus: &[Inputs]) -> Vectors {
        let mut golden = (subject.golden)();
        let expected = stimulus.iter().map(|inputs| {
            let stated = golden(inputs).into_iter().zip(&subject.outputs);
            let bits = stated.map(|(value, signal)| Some(signal.bits(value?)));
            bits.collect()
        });
        let expected = expected.collect();
        let words = stimulus.iter().map(|inputs| {
            let values = inputs.iter().zip(&subject.inputs);
            values.map(|(value, signal)| signal.bits(*value)).collect()
        });
        Vectors {
            inputs: words.collect(),
            expected,
        }
    }

    /// The first clock at which `clock`, which is given its number, inputs and what is stated, says so.
    pub(super) fn first(
        &self,
        mut clock: impl FnMut(usize, &[u64], &Stated) -> bool,
    ) -> Option<usize> {
        let mut clocks = self.inputs.iter().zip(&self.expected).enumerate();
        let found =
            clocks.find(|(index, (inputs, expected))| clock(*index, inputs, &Stated(expected)));
        found.map(|(index, _)| index)
    }
}

/// What is stated of the outputs of a clock.
pub(super) struct Stated<'a>(&'a [Option<u64>]);

impl Stated<'_> {
    /// Is one of these words another than is stated?
    pub(super) fn differs<'f>(&self, found: impl IntoIterator<Item = &'f u64>) -> bool {
        let mut stated = self.0.iter().zip(found);
        stated.any(|(expected, found)| expected.is_some_and(|expected| expected != *found))
    }
}
