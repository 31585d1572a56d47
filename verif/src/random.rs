//! Random co-simulation of a unit over many stimuli, from one seed.

use crate::report::Report;
use crate::subject::{Inputs, Subject};
use crate::waveform::Trace;
use proptest::test_runner::{RngAlgorithm, TestRng};

/// The generator of a seed.
pub(crate) fn generator(seed: u64) -> TestRng {
    let mut bytes = [0u8; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    TestRng::from_seed(RngAlgorithm::ChaCha, &bytes)
}

/// Clocks of one stimulus: long enough for every pipeline to fill, short enough that a run sees many coefficient sets.
const STIMULUS_CLOCKS: usize = 500;

/// Stimuli that make up about `clocks` clocks.
pub fn stimuli(subject: &Subject, clocks: usize, seed: u64) -> Vec<Vec<Inputs>> {
    let count = clocks.div_ceil(STIMULUS_CLOCKS).max(1);
    let length = clocks.clamp(1, STIMULUS_CLOCKS);
    (0..count as u64)
        .map(|k| subject.seeded_stimulus(length, seed.wrapping_mul(1_000_003).wrapping_add(k)))
        .collect()
}

/// Runs the unit in the engine of the subject; each stimulus begins from reset. The waveforms, if wanted, are those of
/// the first stimulus that differs, or of the first.
pub fn run(subject: &Subject, clocks: usize, seed: u64, record: bool) -> (Report, Option<Trace>) {
    let mut total = Report {
        subject: subject.name.clone(),
        engine: subject.engine.into(),
        ..Report::default()
    };
    let mut kept: Option<(bool, Trace)> = None;
    let mut seconds = 0.0;
    for stimulus in stimuli(subject, clocks, seed) {
        let (report, trace) = subject.run(&stimulus, record);
        let differs = report.mismatches > 0;
        if let Some(trace) = trace
            && kept.as_ref().is_none_or(|(before, _)| differs && !before)
        {
            kept = Some((differs, trace));
        }
        seconds += report.seconds;
        total.absorb(report);
    }
    total.timed(seconds);
    (total, kept.map(|(_, trace)| trace))
}
