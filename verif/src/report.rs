//! What a co-simulation found.

use crate::waveform::Trace;
use serde::Serialize;
use std::fmt;
use std::path::PathBuf;

/// Mismatches kept in full; all are counted.
pub const KEPT: usize = 20;

/// Column and line of a pixel, by its place in a picture row by row.
pub(crate) fn place(at: usize, width: usize) -> Option<(i64, i64)> {
    Some(((at % width) as i64, (at / width) as i64))
}

/// One clock at which hardware and golden model differ.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Mismatch {
    /// Clock, counted from the first after reset.
    pub cycle: u64,
    /// Column and line of the pixel, if the signal belongs to one.
    pub pixel: Option<(i64, i64)>,
    /// Name of the signal.
    pub signal: String,
    /// Value of the hardware; none where it has an undefined bit.
    pub hardware: Option<i64>,
    /// Value of the golden model.
    pub golden: i64,
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cycle {}", self.cycle)?;
        if let Some((x, y)) = self.pixel {
            write!(f, ", pixel ({x}, {y})")?;
        }
        match self.hardware {
            Some(value) => write!(f, ": {} is {value} in hardware", self.signal),
            None => write!(f, ": {} has undefined bits in hardware", self.signal),
        }?;
        write!(f, ", {} in the golden model", self.golden)
    }
}

/// Outcome of a co-simulation; the keys are stable.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Report {
    /// Unit or scene.
    pub subject: String,
    /// Engine that ran the hardware.
    pub engine: String,
    /// Target whose netlist was run in place of the hardware's description, if one was.
    pub netlist: Option<String>,
    /// Clocks compared.
    pub cycles: u64,
    /// Pixels (or results) compared.
    pub pixels: u64,
    /// Values compared.
    pub comparisons: u64,
    /// Values that differ.
    pub mismatches: u64,
    /// The first of them.
    pub first_mismatches: Vec<Mismatch>,
    /// Seconds of simulation.
    pub seconds: f64,
    /// Clocks per second, all threads together.
    pub cycles_per_second: f64,
    /// Seed of the stimulus, if it was random.
    pub seed: Option<u64>,
    /// Waveforms, if they were asked for.
    #[serde(skip)]
    pub trace: Option<Trace>,
    /// Files written.
    pub files: Vec<PathBuf>,
    /// Command that reproduces the run.
    pub reproduce: String,
}

impl Report {
    /// Counts a comparison and keeps it if it fails; `signal` is asked for its name only then.
    pub fn compare(
        &mut self,
        cycle: u64,
        pixel: Option<(i64, i64)>,
        signal: impl fmt::Display,
        hardware: Option<i64>,
        golden: i64,
    ) {
        self.comparisons += 1;
        if hardware == Some(golden) {
            return;
        }
        self.mismatches += 1;
        if self.first_mismatches.len() < KEPT {
            self.first_mismatches.push(Mismatch {
                cycle,
                pixel,
                signal: signal.to_string(),
                hardware,
                golden,
            });
        }
    }

    /// Adds the counts of a part that ran beside this one.
    pub fn absorb(&mut self, part: Report) {
        self.cycles += part.cycles;
        self.pixels += part.pixels;
        self.comparisons += part.comparisons;
        self.mismatches += part.mismatches;
        self.first_mismatches.extend(part.first_mismatches);
        self.first_mismatches.truncate(KEPT);
        self.trace = self.trace.take().or(part.trace);
        self.files.extend(part.files);
    }

    /// True if something was compared and nothing differed: an empty run is a failure.
    pub fn passed(&self) -> bool {
        self.mismatches == 0 && self.comparisons > 0 && self.pixels > 0
    }

    /// Sets the time taken.
    pub fn timed(&mut self, seconds: f64) {
        self.seconds = seconds;
        self.cycles_per_second = self.cycles as f64 / seconds.max(1e-9);
    }
}
