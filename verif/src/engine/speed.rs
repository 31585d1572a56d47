//! How fast the engines run a unit: clocks per second of the hardware alone, with the scoreboard, and with waveforms.

use crate::random;
use crate::subject::{Inputs, Subject};
use imogene_studies::picture::WriteError;
use serde::Serialize;
use std::time::{Duration, Instant};

/// The frame that a raster unit is driven through.
pub const FRAME: (usize, usize) = (640, 480);

/// Rounds of measuring; the engines take turns, so that a machine that slows down slows all of them.
const ROUNDS: usize = 3;

/// Clocks between two looks at the time.
const CHUNK: usize = 250;

/// Most clocks of which the waveforms are kept: they lie in memory until they are written.
const MOST_TRACED: usize = 20_000;

/// Clocks of random stimulus before it is repeated.
const RANDOM_CLOCKS: usize = 10_000;

/// What the unit is driven with. Little changes from clock to clock in a quiet picture, which suits some engines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drive {
    /// A whole frame from one set of random words, for a unit with raster flags; as [`Drive::Random`] for any other.
    Frame,
    /// The random stimulus of the co-simulation: new words in every clock, short lines, gaps.
    Random,
}

/// What runs besides the hardware.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Work {
    /// Nothing: the engine alone.
    Hardware,
    /// The golden model and the comparison of every output.
    Scoreboard,
    /// Those and the waveforms of all ports, written to a file.
    Waveforms,
}

/// Speed of one engine doing one kind of work; the keys are stable.
#[derive(Clone, Debug, Serialize)]
pub struct Speed {
    /// Engine.
    pub engine: String,
    /// What it did.
    pub work: Work,
    /// Clocks per second, single-threaded, median of the rounds.
    pub clocks_per_second: f64,
    /// Times the speed of the first engine at the same work.
    pub ratio: f64,
    /// Seconds for a frame of 640x480 pixels, a pixel per clock.
    pub frame_seconds: f64,
    /// Seconds from the request to the end of the first clock: what is made of the circuit before anything runs.
    pub first_clock_seconds: f64,
    /// Bytes of the waveform file per clock.
    pub vcd_bytes_per_clock: Option<f64>,
}

/// A unit in an engine, and how long it took to make.
pub struct Entrant {
    subject: Subject,
    seconds: f64,
}

impl Entrant {
    /// Makes one, and lets it do its first clock.
    ///
    /// # Errors
    ///
    /// Those of making it.
    pub fn new<E>(make: impl FnOnce() -> Result<Subject, E>) -> Result<Entrant, E> {
        let started = Instant::now();
        let subject = make()?;
        (subject.hardware)().run(&random::stimuli(&subject, 1, 1).concat());
        let seconds = started.elapsed().as_secs_f64();
        Ok(Entrant { subject, seconds })
    }

    /// What the unit was made with.
    pub fn options(&self) -> &str {
        &self.subject.options
    }
}

/// A measurement: clocks, seconds, bytes written.
type Sample = (usize, f64, u64);

/// Measures every kind of work in every engine, at most so long each; the first engine is the one that the ratios refer
/// to.
pub fn measure(
    engines: &[Entrant],
    drive: Drive,
    most: Duration,
) -> Result<Vec<Speed>, WriteError> {
    let stimulus = match (engines.first(), drive) {
        (None, _) => return Ok(Vec::new()),
        (Some(first), Drive::Frame) => frame_stimulus(&first.subject),
        (Some(first), Drive::Random) => random::stimuli(&first.subject, RANDOM_CLOCKS, 1).concat(),
    };
    let most = most / ROUNDS as u32;
    let mut speeds: Vec<Speed> = Vec::new();
    for work in [Work::Hardware, Work::Scoreboard, Work::Waveforms] {
        let mut samples = vec![Vec::new(); engines.len()];
        for _ in 0..ROUNDS {
            for (engine, samples) in engines.iter().zip(&mut samples) {
                samples.push(run(&engine.subject, work, &stimulus, most)?);
            }
        }
        let first = median(&samples[0]);
        let rows = engines.iter().zip(&samples);
        speeds.extend(rows.map(|(engine, samples)| {
            let rate = median(samples);
            let (clocks, _, bytes) = samples[0];
            Speed {
                engine: engine.subject.engine.to_owned(),
                work,
                clocks_per_second: rate,
                ratio: rate / first,
                frame_seconds: (FRAME.0 * FRAME.1) as f64 / rate,
                first_clock_seconds: engine.seconds,
                vcd_bytes_per_clock: (work == Work::Waveforms)
                    .then(|| bytes as f64 / clocks as f64),
            }
        }));
    }
    Ok(speeds)
}

fn median(samples: &[Sample]) -> f64 {
    let mut rates: Vec<f64> = samples
        .iter()
        .map(|(clocks, seconds, _)| *clocks as f64 / seconds.max(1e-9))
        .collect();
    rates.sort_by(f64::total_cmp);
    rates[rates.len() / 2]
}

fn frame_stimulus(subject: &Subject) -> Vec<Inputs> {
    let names: Vec<&str> = subject.inputs.iter().map(|s| s.name.as_str()).collect();
    let random = random::stimuli(subject, RANDOM_CLOCKS, 1).concat();
    if !names.starts_with(&["valid", "start", "line"]) {
        return random;
    }
    let (width, height) = FRAME;
    let pixel = |index: usize| {
        let mut inputs = random[0].clone();
        let line_begins = index > 0 && index.is_multiple_of(width);
        inputs[..3].copy_from_slice(&[1, (index == 0).into(), line_begins.into()]);
        inputs
    };
    (0..width * height).map(pixel).collect()
}

fn run(
    subject: &Subject,
    work: Work,
    stimulus: &[Inputs],
    most: Duration,
) -> Result<Sample, WriteError> {
    match work {
        Work::Hardware => Ok(alone(subject, stimulus, most)),
        Work::Scoreboard => {
            let clocks = clocks_within(subject, stimulus, most);
            Ok(scored(subject, &stimulus[..clocks], most))
        }
        Work::Waveforms => {
            let clocks = clocks_within(subject, stimulus, most).min(MOST_TRACED);
            traced(subject, &stimulus[..clocks])
        }
    }
}

/// The hardware alone, through the stimulus again and again.
fn alone(subject: &Subject, stimulus: &[Inputs], most: Duration) -> Sample {
    let mut hardware = (subject.hardware)();
    let started = Instant::now();
    let mut clocks = 0;
    for chunk in stimulus.chunks(CHUNK).cycle() {
        hardware.run(chunk);
        clocks += chunk.len();
        if started.elapsed() >= most {
            break;
        }
    }
    (clocks, started.elapsed().as_secs_f64(), 0)
}

/// Clocks of the stimulus that the hardware alone does in the time.
fn clocks_within(subject: &Subject, stimulus: &[Inputs], most: Duration) -> usize {
    let (clocks, seconds, _) = alone(subject, stimulus, most / 10);
    let clocks = clocks as f64 / seconds.max(1e-9) * most.as_secs_f64();
    (clocks as usize).clamp(1, stimulus.len())
}

fn scored(subject: &Subject, stimulus: &[Inputs], most: Duration) -> Sample {
    let (mut clocks, mut seconds) = (0, 0.0);
    while clocks == 0 || seconds < most.as_secs_f64() {
        seconds += subject.run(stimulus, false).0.seconds;
        clocks += stimulus.len();
    }
    (clocks, seconds, 0)
}

fn traced(subject: &Subject, stimulus: &[Inputs]) -> Result<Sample, WriteError> {
    let folder = tempfile::tempdir().map_err(|source| WriteError {
        path: std::env::temp_dir(),
        source,
    })?;
    let path = folder.path().join("trace.vcd");
    let started = Instant::now();
    let (_, trace) = subject.run(stimulus, true);
    trace.expect("a trace was asked for").write(&path)?;
    let seconds = started.elapsed().as_secs_f64();
    let bytes = std::fs::metadata(&path).map_or(0, |file| file.len());
    Ok((stimulus.len(), seconds, bytes))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit::subject;
    use imogene_contract::{Request, Unit};

    #[test]
    fn every_kind_of_work_is_measured_and_the_first_engine_has_ratio_one() {
        let pe1 = || Entrant::new(|| subject(&Request::new(Unit::Pe1))).expect("a legal subject");
        for drive in [Drive::Frame, Drive::Random] {
            check(&measure(&[pe1(), pe1()], drive, Duration::from_millis(30)).expect("a trace"));
        }
    }

    fn check(speeds: &[Speed]) {
        assert_eq!(speeds.len(), 6);
        for pair in speeds.chunks(2) {
            assert_eq!(pair[0].ratio, 1.0);
            assert!(pair[0].clocks_per_second > 0.0 && pair[1].ratio > 0.0);
            assert!(pair[0].first_clock_seconds > 0.0);
            assert_eq!(
                pair[0].vcd_bytes_per_clock.is_some_and(|bytes| bytes > 1.0),
                pair[0].work == Work::Waveforms
            );
        }
    }

    #[test]
    fn a_frame_begins_each_line_once() {
        let pe1 = subject(&Request::new(Unit::Pe1)).expect("a legal subject");
        let frame = frame_stimulus(&pe1);
        assert_eq!(frame.len(), 640 * 480);
        assert_eq!(frame.iter().filter(|i| i[1] == 1).count(), 1);
        assert_eq!(frame.iter().filter(|i| i[2] == 1).count(), 479);
    }
}
