//! How a machine is shown, and what came of it.

use super::Machine;
use crate::engine::Engine;
use crate::report::Report;
use imogene_golden::machine::overlay::OverlayPlane;
use std::time::Instant;

/// How to run.
#[derive(Clone, Copy, Debug)]
pub struct PinsRun<'a> {
    /// Plane that is put over the pictures, by a host that writes it while the first frame is shown; the machine has an
    /// overlay and a screen.
    pub overlay: Option<&'a OverlayPlane>,
    /// Engine.
    pub engine: Engine,
    /// Seed of random stalls of the host; none if it never stalls.
    pub stalls: Option<u64>,
    /// Clocks for which the host does nothing before each image.
    pub late: u64,
    /// Whole frames to see of the last image.
    pub frames: usize,
}

/// What the pins have shown.
#[derive(Clone, Debug, Default)]
pub struct PinsOutcome {
    /// Comparisons of every clock.
    pub report: Report,
    /// The last whole frame on the pins: red, green, blue, row-major.
    pub picture: Vec<u8>,
    /// Which image each frame showed, none before the first.
    pub shown: Vec<Option<usize>>,
    /// Clocks from the first word of each image to the blanking in which it came on.
    pub loading: Vec<u64>,
    /// Clocks from the first word of each image until the machine took its last one.
    pub taking: Vec<u64>,
    /// Clocks of a frame on the pins.
    pub clocks_per_frame: u64,
}

impl PinsOutcome {
    /// Says what was run, and how long it took.
    pub(super) fn finished(
        mut self,
        machine: &Machine,
        options: &PinsRun,
        started: Instant,
    ) -> PinsOutcome {
        let report = &mut self.report;
        report.subject = machine.design.name.clone();
        report.engine = options.engine.name().into();
        report.seed = options.stalls;
        report.cycles = machine.clocks;
        report.timed(started.elapsed().as_secs_f64());
        self
    }
}
