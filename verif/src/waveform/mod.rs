//! Waveforms: hardware and golden signals side by side, as VCD or FST, and a GTKWave save file that opens them grouped.

pub mod file;
mod request;

pub use request::{Place, PlaceError, WaveformRequest, WindowStart};

use crate::signal::Signal;
use std::collections::VecDeque;
use std::ops::Range;

/// Clocks kept before the first mismatch, so that it is seen with what led to it, and recorded from it on.
const BEFORE_MISMATCH: usize = 60;
const AFTER_MISMATCH: u64 = 200;

/// A group of signals that belong together, such as one unit.
#[derive(Clone, Debug, Default)]
pub struct Group {
    /// Name of the unit.
    pub name: String,
    /// Stimulus: signals that both sides are given.
    pub stimulus: Vec<Signal>,
    /// Signals that both sides produce.
    pub compared: Vec<Signal>,
    /// Signals that nothing is compared with; dots in their names part the scopes they are in.
    pub observed: Vec<Signal>,
}

/// One clock of one group.
#[derive(Clone, Debug, Default)]
pub struct Sample {
    /// Values of the stimulus.
    pub stimulus: Vec<i64>,
    /// Values of the hardware after the edge; `None` where a bit is undefined.
    pub hardware: Vec<Option<i64>>,
    /// Values of the golden model; `None` where it states nothing.
    pub golden: Vec<Option<i64>>,
    /// Values that nothing is compared with; `None` where there is none, as at the end of a list that is too short.
    pub observed: Vec<Option<i64>>,
}

/// Groups, and a sample of each for the clocks that are kept: those of a window, and around the first mismatch.
#[derive(Clone, Debug, Default)]
pub struct Trace {
    groups: Vec<Group>,
    window: Range<u64>,
    /// Clocks from the first mismatch on, once there is one.
    mismatch: Option<Range<u64>>,
    clocks: Vec<(u64, Vec<Sample>)>,
    recent: VecDeque<(u64, Vec<Sample>)>,
}

impl Trace {
    /// An empty trace of these groups, for the clocks of a window.
    pub fn new(groups: Vec<Group>, window: Range<u64>) -> Trace {
        Trace {
            groups,
            window,
            ..Trace::default()
        }
    }

    /// Puts the window elsewhere.
    pub fn open(&mut self, window: Range<u64>) {
        self.window = window;
    }

    /// Takes a clock. Its samples, one per group, are asked for if they can be of use: with true to record them, with
    /// false in case a mismatch follows. `differs` is true from the first mismatch on.
    pub fn clock(&mut self, clock: u64, differs: bool, samples: impl FnOnce(bool) -> Vec<Sample>) {
        if differs && self.mismatch.is_none() {
            self.mismatch = Some(clock..clock + AFTER_MISMATCH);
            self.clocks.extend(self.recent.drain(..));
        }
        let mut ranges = self.mismatch.iter().chain([&self.window]);
        if ranges.any(|range| range.contains(&clock)) {
            self.recent.clear();
            self.clocks.push((clock, samples(true)));
        } else if self.mismatch.is_none() {
            if self.recent.len() == BEFORE_MISMATCH {
                self.recent.pop_front();
            }
            self.recent.push_back((clock, samples(false)));
        }
    }

    /// Clocks recorded.
    pub fn len(&self) -> usize {
        self.clocks.len()
    }

    /// True if nothing was recorded.
    pub fn is_empty(&self) -> bool {
        self.clocks.is_empty()
    }
}

impl Sample {
    /// True if a stated golden value differs from the hardware's.
    pub fn differs(&self) -> bool {
        let mut pairs = self.hardware.iter().zip(&self.golden);
        pairs.any(|(hardware, golden)| golden.is_some() && golden != hardware)
    }
}
