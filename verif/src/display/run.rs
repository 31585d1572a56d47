//! How a machine is shown, its host, which sends words over AXI4-Stream, and what came of it.

use super::request::{mode, request_for};
use super::waves::Waves;
use crate::engine::Engine;
use crate::engine::design::DesignError;
use crate::engine::machine::{Machine, MachineDesign};
use crate::random::Stalls;
use crate::report::Report;
use crate::waveform::{WaveformRequest, WindowStart};
use imogene_golden::machine::overlay::OverlayPlane;
use imogene_plan::description::MachineDescription;
use imogene_plan::display::Image;
use std::sync::Arc;
use std::time::Instant;

/// How to run.
#[derive(Clone, Copy, Debug)]
pub struct PinsRun<'a> {
    /// Plane over the pictures, which the host writes during the first frame; the machine has an overlay and a screen.
    pub overlay: Option<&'a OverlayPlane>,
    /// Engine.
    pub engine: Engine,
    /// Seed of random stalls of the host; none if it never stalls.
    pub stalls: Option<u64>,
    /// Clocks for which the host does nothing before each image.
    pub late: u64,
    /// Whole frames to see of the last image.
    pub frames: usize,
    /// Waveforms, if they are wanted.
    pub waveforms: Option<&'a WaveformRequest>,
    /// If the run ends with the first difference, the clock with which it ends at the latest.
    pub stops: Option<u64>,
}

impl PinsRun<'_> {
    /// One frame of the last image, with a host that does not stall.
    pub fn plain(engine: Engine) -> PinsRun<'static> {
        PinsRun {
            overlay: None,
            engine,
            stalls: None,
            late: 0,
            frames: 1,
            waveforms: None,
            stops: None,
        }
    }

    /// Does the run end after so many clocks with what came of it?
    pub(super) fn ends(&self, outcome: &PinsOutcome, clocks: u64) -> bool {
        let stops = |limit| outcome.report.mismatches > 0 || clocks >= limit;
        self.stops.is_some_and(stops)
    }

    /// The machine, ready to run; refuses waveforms from a pixel that its screen does not have.
    pub(super) fn design(
        &self,
        machine: &MachineDescription,
        images: &[Image],
    ) -> Result<Arc<MachineDesign>, DesignError> {
        let mode = mode(machine);
        if let Some(WindowStart::At(place)) = self.waveforms.map(|waveforms| waveforms.from) {
            place.check(mode.line.active as usize, mode.frame.active as usize)?;
        }
        let nets = self.waveforms.map_or(&[][..], |waveforms| &waveforms.nets);
        let tables = images.first().map_or(&[][..], |image| &image.tables);
        let request = request_for(machine, tables, "");
        MachineDesign::compile(self.engine, &request, vec![], nets)
    }

    /// The waveforms that are wanted, of a machine of whose outputs some are compared.
    pub(super) fn waves(&self, hardware: &Machine, compared: &[&str]) -> Option<Waves> {
        let waveforms = self.waveforms?;
        Some(Waves::new(waveforms, hardware, compared))
    }
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
        waves: Option<Waves>,
        started: Instant,
    ) -> PinsOutcome {
        let report = &mut self.report;
        report.trace = waves.and_then(Waves::finish);
        report.subject = machine.design.name.clone();
        report.engine = options.engine.name().into();
        report.seed = options.stalls;
        report.cycles = machine.clocks;
        report.timed(started.elapsed().as_secs_f64());
        self
    }
}

/// The host: the words of the images, one beat after the other.
pub(super) struct Host<'a> {
    images: &'a [Image],
    image: usize,
    beat: usize,
    wait: u64,
    began: Vec<u64>,
    stalls: Stalls,
    late: u64,
}

impl<'a> Host<'a> {
    pub(super) fn new(images: &'a [Image], options: &PinsRun) -> Self {
        Host {
            images,
            image: 0,
            beat: 0,
            wait: options.late,
            began: vec![],
            stalls: Stalls::new(options.stalls),
            late: options.late,
        }
    }

    /// Clocks after which a machine that shows nothing is given up; `frames` are those of the last image.
    pub(super) fn limit(&self, clocks_of_frame: u64, frames: usize) -> u64 {
        let of_image = |image: &Image| {
            let plan = image.plan.iter();
            let passes = plan.flat_map(|plan| {
                let each = u64::from(plan.machine.zone_width * plan.machine.zone_height) + 600;
                let passes = move |zone| plan.passes(zone, false).count() as u64 * each;
                plan.zones.iter().map(passes)
            });
            let words = image.beats.len() as u64 + passes.sum::<u64>() + self.late;
            8 * words + 4 * clocks_of_frame
        };
        let images: u64 = self.images.iter().map(of_image).sum();
        images + (frames as u64 + 16) * clocks_of_frame
    }

    /// The clock of the first word of an image.
    pub(super) fn began(&self, image: usize) -> Option<u64> {
        self.began.get(image).copied()
    }

    /// Sets the stream for the next clock.
    pub(super) fn offer(
        &mut self,
        hardware: &mut Machine,
        is_beam: bool,
        outcome: &mut PinsOutcome,
    ) {
        self.wait = self.wait.saturating_sub(1);
        let image = self.images.get(self.image).filter(|_| self.wait == 0);
        let beat = image.and_then(|image| image.beats.get(self.beat));
        let beat = beat.filter(|_| !self.stalls.stall());
        let is_ready = hardware.is_set("s_tready");
        hardware.offer(beat);
        if is_beam {
            hardware.set("s_tlast", i64::from(beat.is_some_and(|beat| beat.last)));
        }
        if self.beat == 0 && beat.is_some() && self.began.len() == self.image {
            self.began.push(hardware.clocks);
        }
        if let Some(beat) = beat.filter(|_| is_ready) {
            self.beat += 1;
            if beat.last {
                let began = self.began[self.image];
                outcome.taking.push(hardware.clocks - began);
                self.image += 1;
                self.beat = 0;
                self.wait = self.late;
            }
        }
    }
}
