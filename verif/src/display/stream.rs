//! A machine without a screen: its pixels over AXI4-Stream against golden pictures, with a receiver that may stall.

use super::Machine;
use super::request::mode;
use super::run::{Host, PinsOutcome, PinsRun};
use super::waves::Spot;
use crate::random::Stalls;
use crate::report::place;
use imogene_plan::description::{MachineDescription, MachineKind};
use imogene_plan::display::Image;
use std::time::Instant;

/// What a receiver is given with each pixel.
const STREAM: [&str; 3] = ["m_tdata", "m_tuser", "m_tlast"];

/// Sends the words of images and takes pixels until the last image was seen `frames` times. Every pixel of a frame has
/// to come exactly once, its word has to stay while the receiver stalls, and the first and last have to say so.
pub(super) fn run(
    mut hardware: Machine,
    machine: &MachineDescription,
    images: &[Image],
    options: &PinsRun,
    mut frame_done: impl FnMut(),
) -> PinsOutcome {
    let mut waves = options.waves(&hardware, &STREAM);
    let started = Instant::now();
    let mut host = Host::new(images, options);
    let mut receiver = Stalls::new(options.stalls.map(|seed| seed + 1));
    let mut taker = Taker::new(machine, images);
    let is_beam = machine.machine == MachineKind::Beam;
    // A frame of a zone machine comes once for each image; a beam machine repeats its frame until the next image is
    // there.
    let wanted = if is_beam { options.frames } else { 1 };
    let limit = host.limit(mode(machine).clocks(), options.frames);
    let (mut seen_last, mut idle, mut stalled) = (0, 0, None);
    hardware.set("m_tready", 0);
    hardware.clock();
    while seen_last < wanted && idle < limit && !options.ends(&taker.outcome, hardware.clocks) {
        host.offer(&mut hardware, is_beam, &mut taker.outcome);
        let takes = !receiver.stall();
        hardware.set("m_tready", takes.into());
        let now = hardware.is_set("m_tvalid").then(|| Pixel::of(&hardware));
        let stays = stalled.is_none() || stalled == now;
        taker.check("m_tdata while the receiver stalls", hardware.clocks, stays);
        stalled = now.filter(|_| !takes);
        idle += 1;
        let spot = taker.spot(now.as_ref());
        let taken = now
            .filter(|_| takes && waves.is_some())
            .map(|pixel| taker.wanted(&pixel));
        if let Some(pixel) = now.filter(|_| takes) {
            idle = 0;
            if taker.take(&pixel, hardware.clocks) {
                let is_last = taker.outcome.shown.last() == Some(&images.len().checked_sub(1));
                seen_last += usize::from(is_last);
                frame_done();
            }
        }
        if let Some(waves) = &mut waves {
            let differs = taker.outcome.report.mismatches > 0;
            waves.clock(&mut hardware, &spot, &taken.unwrap_or_default(), differs);
        }
        hardware.clock();
        taker.see_swap(&hardware, is_beam, &host);
    }
    let all = seen_last == wanted;
    taker.check("frames of the last image", hardware.clocks, all);
    taker.outcome.finished(&hardware, options, waves, started)
}

/// A pixel on the stream.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Pixel {
    colour: i64,
    user: i64,
    is_last: bool,
}

impl Pixel {
    fn of(hardware: &Machine) -> Pixel {
        Pixel {
            colour: hardware.get("m_tdata").unwrap_or(-1),
            user: hardware.get("m_tuser").unwrap_or(-1),
            is_last: hardware.is_set("m_tlast"),
        }
    }
}

/// The receiver: puts the pixels of a frame together.
struct Taker<'a> {
    images: &'a [Image],
    is_beam: bool,
    width: usize,
    frame: Vec<u8>,
    seen: Vec<bool>,
    count: usize,
    /// Image of this frame, and of the next.
    on: Option<usize>,
    next: Option<usize>,
    outcome: PinsOutcome,
}

impl<'a> Taker<'a> {
    fn new(machine: &MachineDescription, images: &'a [Image]) -> Self {
        let mode = mode(machine);
        let pixels = (mode.line.active * mode.frame.active) as usize;
        let is_beam = machine.machine == MachineKind::Beam;
        let first = (!is_beam).then_some(0);
        Taker {
            images,
            is_beam,
            width: mode.line.active as usize,
            frame: vec![0; 3 * pixels],
            seen: vec![false; pixels],
            count: 0,
            on: first,
            next: first.map(|_| 1),
            outcome: PinsOutcome::default(),
        }
    }

    /// A swap comes while the last pixels of the old frame may still wait in the queue: it is for the frame after this
    /// one.
    fn see_swap(&mut self, hardware: &Machine, is_beam: bool, host: &Host) {
        if !is_beam || !hardware.is_set("swapped") {
            return;
        }
        let image = self.next.or(self.on).map_or(0, |image| image + 1);
        self.next = Some(image);
        if self.count == 0 {
            self.on = self.next;
        }
        if let Some(began) = host.began(image) {
            self.outcome.loading.push(hardware.clocks - began);
        }
    }

    /// The place of a pixel in the frame, row by row; one that is beyond its end is of a wrong machine.
    fn place(&self, pixel: &Pixel) -> usize {
        match self.is_beam {
            true => self.count,
            false => (pixel.user >> 12) as usize * self.width + (pixel.user & 0xfff) as usize,
        }
    }

    /// Where the stream is, with the pixel that it offers.
    fn spot(&self, pixel: Option<&Pixel>) -> Spot {
        let place = |pixel| {
            let at = self.place(pixel);
            (at % self.width, at / self.width)
        };
        Spot {
            frame: self.outcome.shown.len() as u32 + 1,
            is_scene: self.on.is_some(),
            pixel: pixel.map(place),
        }
    }

    /// What [`STREAM`] should be with a pixel that is taken; a zone machine says itself which one it is.
    fn wanted(&self, pixel: &Pixel) -> [Option<i64>; STREAM.len()] {
        let at = self.place(pixel).min(self.seen.len() - 1);
        let user = self.is_beam.then(|| (at == 0).into());
        [Some(self.colour(at)), user, Some(self.ends(at).into())]
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
            false => self.count == self.seen.len() - 1,
        }
    }

    /// Takes a pixel; true if the frame is complete.
    fn take(&mut self, pixel: &Pixel, clock: u64) -> bool {
        let at = self.place(pixel);
        let pixels = self.seen.len();
        let is_new = at < pixels && !std::mem::replace(&mut self.seen[at.min(pixels - 1)], true);
        self.check("a pixel once", clock, is_new);
        self.check("m_tlast", clock, pixel.is_last == self.ends(at));
        if self.is_beam {
            self.check("m_tuser", clock, (pixel.user == 1) == (at == 0));
        }
        self.compare(pixel, at.min(pixels - 1), clock);
        self.outcome.report.pixels += 1;
        self.count += 1;
        if self.count < pixels {
            return false;
        }
        self.finish();
        true
    }

    fn compare(&mut self, pixel: &Pixel, at: usize, clock: u64) {
        for (channel, shift) in [16, 8, 0].into_iter().enumerate() {
            self.frame[3 * at + channel] = (pixel.colour >> shift) as u8;
        }
        let (place, golden) = (place(at, self.width), self.colour(at));
        let report = &mut self.outcome.report;
        report.compare(clock, place, "m_tdata", Some(pixel.colour), golden);
    }

    fn finish(&mut self) {
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
    }

    fn check(&mut self, what: &str, clock: u64, holds: bool) {
        let found = Some(holds.into());
        self.outcome.report.compare(clock, None, what, found, 1);
    }
}
