//! A machine with its screen against golden pictures: the pins on every clock.

use super::request::{mode, request_for};
use super::run::Host;
use super::stream;
use super::waves::{Spot, Waves};
use crate::engine::design::DesignError;
use crate::engine::machine::{Machine, MachineDesign};
use crate::signal::Delay;
use imogene_golden::machine::overlay::OverlayPlane;
use imogene_golden::machine::video_timing::{Shown, VideoTiming};
use imogene_plan::description::{MachineDescription, MachineKind, Output};
use imogene_plan::display::Image;
use std::sync::Arc;
use std::time::Instant;

pub use super::run::{PinsOutcome, PinsRun};

/// Shows images one after the other and compares every pin on every clock, or every pixel of a machine that streams. A
/// frame is that of the image that came on last, or black.
pub fn run(
    machine: &MachineDescription,
    images: &[Image],
    options: &PinsRun,
    frame_done: impl FnMut(),
) -> Result<PinsOutcome, DesignError> {
    let design = options.design(machine, images)?;
    run_in(&design, machine, images, options, frame_done)
}

/// The same in a machine that was made of this description.
pub fn run_in(
    design: &Arc<MachineDesign>,
    machine: &MachineDescription,
    images: &[Image],
    options: &PinsRun,
    mut frame_done: impl FnMut(),
) -> Result<PinsOutcome, DesignError> {
    let mut hardware = Machine::of(design);
    if machine.output == Output::Stream {
        return Ok(stream::run(hardware, machine, images, options, frame_done));
    }
    let behind = request_for(machine, &[], "").clocks()?.output;
    let mode = mode(machine);
    let started = Instant::now();
    let mut run = Run {
        places: PINS.map(|pin| hardware.output(pin)),
        swapped: hardware.output("swapped"),
        golden: VideoTiming::new(mode, 0),
        late: Delay::new(behind),
        width: mode.line.active as usize,
        black: vec![0; 3 * (mode.line.active * mode.frame.active) as usize],
        images,
        overlay: options.overlay,
        is_overlaid: false,
        on: None,
        next: None,
        outcome: PinsOutcome {
            clocks_per_frame: mode.clocks(),
            ..PinsOutcome::default()
        },
        frame: vec![],
        waves: options.waves(&hardware, &PINS),
        spot: Spot::default(),
        wanted: None,
    };
    let mut host = Host::new(images, options);
    let is_beam = machine.machine == MachineKind::Beam;
    let mut plane = options.overlay.map_or(&[][..], |plane| &plane.words);
    let mut seen_last = 0;
    let limit = host.limit(mode.clocks(), options.frames);
    while seen_last < options.frames
        && hardware.clocks < limit
        && !options.ends(&run.outcome, hardware.clocks)
    {
        if options.overlay.is_some() {
            plane = write_plane(&mut hardware, plane, options.overlay);
        }
        host.offer(&mut hardware, is_beam, &mut run.outcome);
        run.keep(&mut hardware);
        hardware.clock();
        run.see_swap(&hardware, &host);
        if run.see_pins(&hardware) {
            // A frame is complete: what the pins show next comes after the blanking.
            run.is_overlaid = options.overlay.is_some() && plane.is_empty();
            hardware.set("overlay_enable", run.is_overlaid.into());
            let is_last = run.outcome.shown.last() == Some(&images.len().checked_sub(1));
            seen_last += usize::from(is_last);
            frame_done();
        }
    }
    run.keep(&mut hardware);
    let (what, seen) = ("frames of the last image", Some(seen_last as i64));
    let report = &mut run.outcome.report;
    report.compare(hardware.clocks, None, what, seen, options.frames as i64);
    let Run { outcome, waves, .. } = run;
    Ok(outcome.finished(&hardware, options, waves, started))
}

/// Puts the next word of the plane on the bus of the overlay; the words that are left.
fn write_plane<'a>(
    hardware: &mut Machine,
    left: &'a [u32],
    plane: Option<&OverlayPlane>,
) -> &'a [u32] {
    hardware.set("overlay_write", i64::from(!left.is_empty()));
    let Some((plane, (&word, rest))) = plane.zip(left.split_first()) else {
        return left;
    };
    let [red, green, blue] = plane.colour.map(i64::from);
    hardware.set("overlay_colour", red << 16 | green << 8 | blue);
    hardware.set("overlay_address", (plane.words.len() - left.len()) as i64);
    hardware.set("overlay_data", word.into());
    rest
}

/// What a screen is given.
const PINS: [&str; 6] = ["red", "green", "blue", "hsync", "vsync", "de"];

struct Run<'a> {
    /// Places of [`PINS`] among the outputs, and of `swapped`.
    places: [usize; PINS.len()],
    swapped: usize,
    golden: VideoTiming,
    late: Delay<(Shown, bool, bool)>,
    width: usize,
    black: Vec<u8>,
    images: &'a [Image],
    overlay: Option<&'a OverlayPlane>,
    is_overlaid: bool,
    /// Image of this frame, and of the next.
    on: Option<usize>,
    next: Option<usize>,
    outcome: PinsOutcome,
    frame: Vec<u8>,
    waves: Option<Waves>,
    /// Where in the picture the pins are, and what they should be.
    spot: Spot,
    wanted: Option<[i64; PINS.len()]>,
}

impl Run<'_> {
    /// Keeps the waveforms of the clock that comes next.
    fn keep(&mut self, hardware: &mut Machine) {
        if let Some(waves) = &mut self.waves {
            let golden = self.wanted.map(|pins| pins.map(Some));
            let golden = golden.unwrap_or_default();
            let differs = self.outcome.report.mismatches > 0;
            waves.clock(hardware, &self.spot, &golden, differs);
        }
    }

    fn see_swap(&mut self, hardware: &Machine, host: &Host) {
        if hardware.at(self.swapped) == Some(1) {
            let next = self.next.map_or(0, |image| image + 1);
            self.next = Some(next);
            if let Some(began) = host.began(next) {
                self.outcome.loading.push(hardware.clocks - began);
            }
        }
    }

    /// Compares the pins; true if a frame is complete.
    fn see_pins(&mut self, hardware: &Machine) -> bool {
        // The frames change places in the blanking; the pins are some clocks behind and still show the last pixels.
        if self.frame.is_empty() {
            self.on = self.next;
        }
        let timing = self.golden.clock(true);
        let scanned = (timing.now, timing.hsync, timing.vsync);
        let Some((shown, hsync, vsync)) = self.late.push(scanned) else {
            return false;
        };
        let [x, y] = [shown.x, shown.y].map(usize::from);
        self.spot.pixel = shown.active.then_some((x, y));
        if shown.start {
            self.spot.frame += 1;
            self.spot.is_scene = self.on.is_some();
        }
        let image = self.on.and_then(|on| self.images.get(on));
        let expected = image.map_or(&self.black, |image| &image.picture);
        let at = 3 * (y * self.width + x);
        let plane = self.overlay.filter(|_| self.is_overlaid);
        let over = plane.and_then(|plane| plane.colour_at(at / 3));
        let colour = |channel: usize| match (shown.active, over) {
            (true, Some(over)) => over[channel].into(),
            (true, None) => i64::from(expected[at + channel]),
            (false, _) => 0,
        };
        let [red, green, blue] = [0, 1, 2].map(colour);
        let [hsync, vsync, de] = [hsync, vsync, shown.active].map(i64::from);
        let wanted = [red, green, blue, hsync, vsync, de];
        self.wanted = Some(wanted);
        let found = self.places.map(|place| hardware.at(place));
        let pixel = shown.active.then_some((x as i64, y as i64));
        let report = &mut self.outcome.report;
        for ((pin, found), golden) in PINS.iter().zip(found).zip(wanted) {
            report.compare(hardware.clocks, pixel, pin, found, golden);
        }
        let [red, green, blue, _, _, Some(1)] = found else {
            return false;
        };
        report.pixels += 1;
        let levels = [red, green, blue].map(|level| level.unwrap_or(0) as u8);
        self.frame.extend(levels);
        let is_whole = self.frame.len() == self.black.len();
        if is_whole {
            self.outcome.picture = std::mem::take(&mut self.frame);
            self.outcome.shown.push(self.on);
        }
        is_whole
    }
}
