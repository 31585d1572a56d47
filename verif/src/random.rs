//! Random co-simulation of a unit over many stimuli, from one seed, and random stalls of a stream.

use crate::subject::{Inputs, LANES, Outcome, Subject};
use crate::waveform::Trace;
use proptest::prelude::Rng;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use rayon::prelude::*;
use std::ops::Range;
use std::time::Instant;

pub(crate) fn generator(seed: u64) -> TestRng {
    let mut bytes = [0u8; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    TestRng::from_seed(RngAlgorithm::ChaCha, &bytes)
}

impl Subject {
    /// A stimulus of about `clocks` clocks, the same for the same seed.
    pub fn seeded_stimulus(&self, clocks: usize, seed: u64) -> Vec<Inputs> {
        let mut runner = TestRunner::new_with_rng(Config::default(), generator(seed));
        (self.stimulus)(self, clocks)
            .new_tree(&mut runner)
            .expect("stimulus strategies reject nothing")
            .current()
    }
}

/// Stalls of a stream: one clock in three, or never.
pub struct Stalls(Option<TestRng>);

impl Stalls {
    /// Stalls of a seed; without one there are none.
    pub fn new(seed: Option<u64>) -> Stalls {
        Stalls(seed.map(generator))
    }

    /// Does the stream stall on the next clock?
    pub fn stall(&mut self) -> bool {
        let random = self.0.as_mut();
        random.is_some_and(|random| random.next_u32().is_multiple_of(3))
    }
}

/// Clocks of one stimulus: long enough for every pipeline to fill, short enough that a run sees many coefficient sets.
const STIMULUS_CLOCKS: usize = 500;

/// Stimuli made and run at once, which then are forgotten.
const BATCH: usize = 16 * LANES;

/// Stimuli that make up about `clocks` clocks.
pub fn stimuli(subject: &Subject, clocks: usize, seed: u64) -> Vec<Vec<Inputs>> {
    made(subject, clocks, seed, 0..count(clocks))
}

/// How many stimuli there are.
fn count(clocks: usize) -> usize {
    clocks.div_ceil(STIMULUS_CLOCKS).max(1)
}

fn made(subject: &Subject, clocks: usize, seed: u64, which: Range<usize>) -> Vec<Vec<Inputs>> {
    let length = clocks.clamp(1, STIMULUS_CLOCKS);
    let first = seed.wrapping_mul(1_000_003);
    let seeds = which.into_par_iter().map(|k| first.wrapping_add(k as u64));
    seeds
        .map(|seed| subject.seeded_stimulus(length, seed))
        .collect()
}

/// Runs the unit, each stimulus from reset; waveforms are those of the first that differs, or of the first.
pub fn run(subject: &Subject, clocks: usize, seed: u64, record: bool) -> Outcome {
    let mut total = subject.report();
    let mut kept: Option<(bool, Trace)> = None;
    let mut seconds = 0.0;
    let all = count(clocks);
    for begin in (0..all).step_by(BATCH) {
        let stimuli = made(subject, clocks, seed, begin..all.min(begin + BATCH));
        let started = Instant::now();
        let outcomes = subject.run_all(&stimuli, record);
        seconds += started.elapsed().as_secs_f64();
        for (report, trace) in outcomes {
            let differs = report.mismatches > 0;
            if let Some(trace) = trace
                && kept.as_ref().is_none_or(|(before, _)| differs && !before)
            {
                kept = Some((differs, trace));
            }
            total.absorb(report);
        }
    }
    total.timed(seconds);
    (total, kept.map(|(_, trace)| trace))
}
