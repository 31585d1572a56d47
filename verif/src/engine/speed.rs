//! How fast the engines run a unit: clocks per second of the hardware alone, with the scoreboard, and with waveforms.

use super::design::{DesignError, Source};
use super::machine::driven;
use super::simulator::Simulator;
use super::verilator::Model;
use crate::random;
use crate::subject::{Inputs, LANES, Subject};
use crate::unit::{levelised, subject};
use imogene_contract::Request;
use imogene_rtl::emit::emit;
use imogene_studies::picture::WriteError;
use serde::Serialize;
use std::time::{Duration, Instant};

/// The frame whose time is told.
pub const FRAME: (usize, usize) = (640, 480);

/// Lines of it that are driven, again and again: of more the words come no longer from a cache.
const LINES: usize = 2;

/// Rounds of measuring; the engines take turns, so that a machine that slows down slows all of them.
const ROUNDS: usize = 15;

/// Clocks between two looks at the time.
const CHUNK: usize = 250;

/// Most clocks of which the waveforms are kept: they lie in memory until they are written.
const MOST_TRACED: usize = 20_000;

/// Options of the C++ compiler with which Verilator competes.
const FASTEST: &str = "-O3 -march=native";

/// Clocks of random stimulus before it is repeated.
const RANDOM_CLOCKS: usize = 500;

/// What the unit is driven with. Little changes from clock to clock in a quiet picture, which suits some engines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drive {
    /// Lines of a frame from one set of random words, for a unit with raster flags; as [`Drive::Random`] for any other.
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
    /// Runs side by side.
    pub lanes: usize,
    /// What it did.
    pub work: Work,
    /// Clocks per second of all lanes together, single-threaded, median of the rounds.
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

/// A unit in an engine, alone or in all its lanes, and how long it took to make.
pub struct Entrant {
    subject: Subject,
    lanes: usize,
    seconds: f64,
}

impl Entrant {
    /// A unit in every engine: built-in alone and in lanes, levelised, in Icarus Verilog and in Verilator, whose C++ is
    /// compiled for the processor that this runs on.
    pub fn all(request: &Request) -> Result<Vec<Entrant>, DesignError> {
        let verilog = |simulator: Simulator| {
            let (subject, emitted) = (subject(request)?, emit(request)?);
            let text = emitted.bundle();
            let source = Source::of(&subject, &emitted.top, &text);
            let design = match simulator {
                Simulator::Icarus => simulator.compile(&source)?,
                Simulator::Verilator => Model::compile(&source, ["", FASTEST])?.design(),
            };
            Ok(driven(subject, simulator.name(), design))
        };
        let built_in = || Ok(subject(request)?);
        let mut all = vec![
            Entrant::new(1, built_in)?,
            Entrant::new(LANES, built_in)?,
            Entrant::new(1, || Ok(levelised(request, false)?))?,
        ];
        for simulator in Simulator::ALL {
            all.push(Entrant::new(1, || verilog(simulator))?);
        }
        Ok(all)
    }

    /// Makes one in an engine of so many lanes, and lets it do its first clock.
    pub fn new(
        lanes: usize,
        make: impl FnOnce() -> Result<Subject, DesignError>,
    ) -> Result<Entrant, DesignError> {
        let started = Instant::now();
        let subject = make()?;
        let first = random::stimuli(&subject, 1, 1).concat();
        (subject.hardware)(lanes).clock(&vec![&first[0][..]; lanes]);
        Ok(Entrant {
            subject,
            lanes,
            seconds: started.elapsed().as_secs_f64(),
        })
    }

    /// What the unit was made with.
    pub fn options(&self) -> &str {
        &self.subject.options
    }

    /// What each lane is driven with, which is as long for each.
    fn stimuli<'a>(&self, stimuli: &'a [Vec<Inputs>]) -> Vec<&'a [Inputs]> {
        let length = stimuli.iter().map(Vec::len).min().unwrap_or(0);
        let stimuli = stimuli.iter().cycle().take(self.lanes);
        stimuli.map(|stimulus| &stimulus[..length]).collect()
    }
}

/// What a unit is driven with: one stimulus for all lanes, or one for each.
pub fn stimuli(engines: &[Entrant], drive: Drive) -> Vec<Vec<Inputs>> {
    let Some(Entrant { subject, .. }) = engines.first() else {
        return vec![];
    };
    let random = |seed: u64| random::stimuli(subject, RANDOM_CLOCKS, seed).concat();
    match drive {
        Drive::Frame => vec![frame_stimulus(subject, random(1))],
        Drive::Random => (1..=LANES as u64).map(random).collect(),
    }
}

/// A measurement: clocks, seconds, bytes written.
type Sample = (usize, f64, u64);

/// Measures every kind of work in every engine, at most so long each; ratios refer to the first engine.
pub fn measure(
    engines: &[Entrant],
    stimuli: &[Vec<Inputs>],
    most: Duration,
) -> Result<Vec<Speed>, WriteError> {
    let most = most / ROUNDS as u32;
    let mut speeds: Vec<Speed> = Vec::new();
    for work in [Work::Hardware, Work::Scoreboard, Work::Waveforms] {
        let mut samples = vec![Vec::new(); engines.len()];
        for _ in 0..ROUNDS {
            for (engine, samples) in engines.iter().zip(&mut samples) {
                samples.push(engine.run(work, &engine.stimuli(stimuli), most)?);
            }
        }
        let first = samples.first().map_or(1.0, |samples| median(samples));
        let rows = engines.iter().zip(&samples);
        speeds.extend(rows.map(|(engine, samples)| {
            let rate = median(samples);
            let (clocks, _, bytes) = samples[0];
            Speed {
                engine: engine.subject.engine.to_owned(),
                lanes: engine.lanes,
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
    let rate = |(clocks, seconds, _): &Sample| *clocks as f64 / seconds.max(1e-9);
    let mut rates: Vec<f64> = samples.iter().map(rate).collect();
    rates.sort_by(f64::total_cmp);
    rates[rates.len() / 2]
}

fn frame_stimulus(subject: &Subject, random: Vec<Inputs>) -> Vec<Inputs> {
    let names = subject.inputs.iter().map(|port| port.name.as_str());
    if !names.take(3).eq(["valid", "start", "line"]) {
        return random;
    }
    let width = FRAME.0;
    let pixel = |index: usize| {
        let mut inputs = random[0].clone();
        let line_begins = index > 0 && index.is_multiple_of(width);
        inputs[..3].copy_from_slice(&[1, (index == 0).into(), line_begins.into()]);
        inputs
    };
    (0..width * LINES).map(pixel).collect()
}

impl Entrant {
    fn run(&self, work: Work, stimuli: &[&[Inputs]], most: Duration) -> Result<Sample, WriteError> {
        // As many clocks of each stimulus as the hardware alone does in the time.
        let within = |at_most: usize| -> Vec<&[Inputs]> {
            let (clocks, seconds, _) = self.alone(stimuli, most / 10);
            let clocks = clocks as f64 / seconds.max(1e-9) * most.as_secs_f64() / self.lanes as f64;
            let clocks = (clocks as usize).clamp(1, stimuli[0].len()).min(at_most);
            stimuli.iter().map(|stimulus| &stimulus[..clocks]).collect()
        };
        match work {
            Work::Hardware => Ok(self.alone(stimuli, most)),
            Work::Scoreboard => Ok(self.scored(&within(usize::MAX), most)),
            Work::Waveforms => self.traced(&within(MOST_TRACED / self.lanes)),
        }
    }

    /// The hardware alone, through the stimuli again and again.
    fn alone(&self, stimuli: &[&[Inputs]], most: Duration) -> Sample {
        let mut hardware = (self.subject.hardware)(self.lanes);
        let length = stimuli[0].len();
        let mut rows: [&[i64]; LANES] = [&[]; LANES];
        let rows = &mut rows[..self.lanes];
        let started = Instant::now();
        let mut clocks = 0;
        for begin in (0..length).step_by(CHUNK).cycle() {
            let chunk = begin..length.min(begin + CHUNK);
            clocks += chunk.len() * self.lanes;
            for clock in chunk {
                for (row, stimulus) in rows.iter_mut().zip(stimuli) {
                    *row = &stimulus[clock];
                }
                hardware.clock(rows);
            }
            if started.elapsed() >= most {
                break;
            }
        }
        (clocks, started.elapsed().as_secs_f64(), 0)
    }

    fn scored(&self, stimuli: &[&[Inputs]], most: Duration) -> Sample {
        let started = Instant::now();
        let mut clocks = 0;
        while clocks == 0 || started.elapsed() < most {
            for (report, _) in self.subject.run_all(stimuli, false) {
                clocks += report.cycles as usize;
            }
        }
        (clocks, started.elapsed().as_secs_f64(), 0)
    }

    fn traced(&self, stimuli: &[&[Inputs]]) -> Result<Sample, WriteError> {
        let folder = tempfile::tempdir().map_err(|source| WriteError {
            path: std::env::temp_dir(),
            source,
        })?;
        let started = Instant::now();
        let (mut clocks, mut paths) = (0, vec![]);
        for (lane, (report, trace)) in (0..).zip(self.subject.run_all(stimuli, true)) {
            let path = folder.path().join(format!("trace_{lane}.vcd"));
            trace.expect("a trace was asked for").write(&path)?;
            clocks += report.cycles as usize;
            paths.push(path);
        }
        let seconds = started.elapsed().as_secs_f64();
        let sizes = paths.iter().filter_map(|path| path.metadata().ok());
        Ok((clocks, seconds, sizes.map(|file| file.len()).sum()))
    }
}
