//! A machine without a screen: its pixels over AXI4-Stream against golden pictures, with a receiver that may stall.

use super::request::mode;
use super::run::{Host, PinsOutcome, PinsRun};
use super::waves::Spot;
use crate::engine::machine::Machine;
use crate::random::Stalls;
use crate::report::place;
use imogene_golden::unit::lattice::Lattice;
use imogene_plan::description::{MachineDescription, MachineKind};
use imogene_plan::display::Image;
use std::time::Instant;

/// Sends the words of images and takes pixels until the last image was seen `frames` times. Every pixel of a frame has
/// to come exactly once, its word has to stay while the receiver stalls, and the first and last have to say so.
pub(super) fn run(
    mut hardware: Machine,
    machine: &MachineDescription,
    images: &[Image],
    options: &PinsRun,
    mut frame_done: impl FnMut(),
) -> PinsOutcome {
    // The colours of the pixels of a clock, and what the receiver is told of them.
    let ports: Vec<String> = match machine.pixels_at_once() {
        1 => vec!["m_tdata".to_owned()],
        count => (0..count).map(|pixel| format!("m_tdata_{pixel}")).collect(),
    };
    let colours = ports.iter().map(String::as_str);
    let compared: Vec<&str> = colours.chain(["m_tuser", "m_tlast"]).collect();
    let mut waves = options.waves(&hardware, &compared);
    let started = Instant::now();
    let mut host = Host::new(images, options);
    let mut receiver = Stalls::new(options.stalls.map(|seed| seed + 1));
    let mut taker = Taker::new(machine, images, &compared);
    let is_beam = machine.machine == MachineKind::Beam;
    // A zone machine sends a frame once for each image; a beam machine repeats it until the next image is there.
    let wanted = if is_beam { options.frames } else { 1 };
    let limit = host.limit(mode(machine).clocks(), options.frames);
    let (mut seen_last, mut idle, mut stalled) = (0, 0, None);
    hardware.set("m_tready", 0);
    hardware.clock();
    while seen_last < wanted && idle < limit && !options.ends(&taker.outcome, hardware.clocks) {
        host.offer(&mut hardware, is_beam, &mut taker.outcome);
        let takes = !receiver.stall();
        hardware.set("m_tready", takes.into());
        let word = |port: &&str| hardware.get(port).unwrap_or(-1);
        let now = hardware.is_set("m_tvalid").then(|| Beat {
            colours: taker.ports.iter().map(word).collect(),
            user: word(&"m_tuser"),
            is_last: hardware.is_set("m_tlast"),
        });
        let stays = stalled.is_none() || stalled == now;
        taker.check("m_tdata while the receiver stalls", hardware.clocks, stays);
        idle += 1;
        let spot = taker.spot(now.as_ref());
        let taken = now.as_ref().filter(|_| takes && waves.is_some());
        let taken = taken.map(|beat| taker.wanted(beat));
        stalled = now.clone().filter(|_| !takes);
        if let Some(beat) = now.filter(|_| takes) {
            idle = 0;
            if taker.take(&beat, hardware.clocks) {
                let is_last = taker.outcome.shown.last() == Some(&images.len().checked_sub(1));
                seen_last += usize::from(is_last);
                frame_done();
            }
        }
        if let Some(waves) = &mut waves {
            let differs = taker.outcome.report.mismatches > 0;
            waves.clock(
                &mut hardware,
                &spot,
                &taken.unwrap_or(vec![None; compared.len()]),
                differs,
            );
        }
        hardware.clock();
        taker.see_swap(&hardware, &host);
    }
    let all = seen_last == wanted;
    taker.check("frames of the last image", hardware.clocks, all);
    taker.outcome.finished(&hardware, options, waves, started)
}

/// The pixels of a clock on the stream.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Beat {
    colours: Vec<i64>,
    user: i64,
    is_last: bool,
}

/// The receiver: puts the pixels of a frame together.
struct Taker<'a> {
    images: &'a [Image],
    is_beam: bool,
    width: usize,
    /// Ports of the pixels of a clock.
    ports: &'a [&'a str],
    frame: Vec<u8>,
    seen: Vec<bool>,
    count: usize,
    /// Pixels of a frame.
    pixels: usize,
    /// Image of this frame, and of the next.
    on: Option<usize>,
    next: Option<usize>,
    outcome: PinsOutcome,
}

impl<'a> Taker<'a> {
    fn new(machine: &MachineDescription, images: &'a [Image], stream: &'a [&'a str]) -> Self {
        let mode = mode(machine);
        let pixels = (mode.line.active * mode.frame.active) as usize;
        let is_beam = machine.machine == MachineKind::Beam;
        let first = (!is_beam).then_some(0);
        Taker {
            images,
            is_beam,
            width: mode.line.active as usize,
            ports: &stream[..stream.len() - 2],
            frame: vec![0; 3 * pixels],
            seen: vec![false; pixels],
            count: 0,
            pixels: pixels / machine.fields().len(),
            on: first,
            next: first.map(|_| 1),
            outcome: PinsOutcome::default(),
        }
    }

    /// A swap may come while the last pixels of the old frame wait in the queue: it is for the frame after this one.
    fn see_swap(&mut self, hardware: &Machine, host: &Host) {
        if !self.is_beam || !hardware.is_set("swapped") {
            return;
        }
        let image = self.next.map_or(0, |image| image + 1);
        self.next = Some(image);
        if self.count == 0 {
            self.on = self.next;
        }
        if let Some(began) = host.began(image) {
            self.outcome.loading.push(hardware.clocks - began);
        }
    }

    /// Where the first pixel of a clock is in the frame, row by row; a wrong machine may go beyond its end.
    fn place(&self, beat: &Beat) -> usize {
        let image = self.on.and_then(|on| self.images.get(on));
        let field = image.map_or(Lattice::zone(0, 0), |image| image.pixels);
        let (x, y) = match self.is_beam {
            true => (self.count % self.width, self.count / self.width),
            false => ((beat.user & 0xfff) as usize, (beat.user >> 12) as usize),
        };
        (y * field.dy as usize + field.y0 as usize) * self.width + x
    }

    /// Where the stream is, with the first pixel that it offers.
    fn spot(&self, beat: Option<&Beat>) -> Spot {
        let place = |beat| {
            let at = self.place(beat);
            (at % self.width, at / self.width)
        };
        Spot {
            frame: self.outcome.shown.len() as u32 + 1,
            is_scene: self.on.is_some(),
            pixel: beat.map(place),
        }
    }

    /// What the stream should be with pixels that are taken; a zone machine says itself which one it is.
    fn wanted(&self, beat: &Beat) -> Vec<Option<i64>> {
        let last = self.seen.len() - 1;
        let at = self.place(beat);
        let colours = (at..at + self.ports.len()).map(|at| Some(self.colour(at.min(last))));
        let user = self.is_beam.then(|| (self.count == 0).into());
        let ends = self.ends(at + self.ports.len() - 1);
        colours.chain([user, Some(ends.into())]).collect()
    }

    /// The golden colour at a place.
    fn colour(&self, at: usize) -> i64 {
        let image = self.on.and_then(|on| self.images.get(on));
        let wanted = image.map_or([0; 3], |image| [0, 1, 2].map(|k| image.picture[3 * at + k]));
        let [red, green, blue] = wanted.map(i64::from);
        red << 16 | green << 8 | blue
    }

    /// The pixel that comes now, at a place, ends a line or the frame.
    fn ends(&self, at: usize) -> bool {
        match self.is_beam {
            true => at % self.width == self.width - 1,
            false => self.count == self.pixels - 1,
        }
    }

    /// Takes the pixels of a clock; true if the frame is complete.
    fn take(&mut self, beat: &Beat, clock: u64) -> bool {
        let at = self.place(beat);
        let ends = self.ends(at + beat.colours.len() - 1);
        self.check("m_tlast", clock, beat.is_last == ends);
        if self.is_beam {
            self.check("m_tuser", clock, (beat.user == 1) == (self.count == 0));
        }
        let pixels = self.seen.len();
        for (lane, colour) in beat.colours.iter().enumerate() {
            let (is_inside, at) = (at + lane < pixels, (at + lane).min(pixels - 1));
            let is_new = is_inside && !std::mem::replace(&mut self.seen[at], true);
            self.check("a pixel once", clock, is_new);
            for (channel, shift) in [16, 8, 0].into_iter().enumerate() {
                self.frame[3 * at + channel] = (colour >> shift) as u8;
            }
            let (place, golden) = (place(at, self.width), self.colour(at));
            let report = &mut self.outcome.report;
            report.compare(clock, place, self.ports[lane], Some(*colour), golden);
        }
        self.outcome.report.pixels += beat.colours.len() as u64;
        self.count += beat.colours.len();
        if self.count < self.pixels {
            return false;
        }
        self.outcome.shown.push(self.on);
        self.outcome.picture.clone_from(&self.frame);
        self.seen.fill(false);
        self.count = 0;
        if let Some(next) = self.next {
            self.on = Some(next);
            if !self.is_beam {
                self.next = Some(next + 1);
            }
        }
        true
    }

    fn check(&mut self, what: &str, clock: u64, holds: bool) {
        let found = Some(holds.into());
        self.outcome.report.compare(clock, None, what, found, 1);
    }
}
