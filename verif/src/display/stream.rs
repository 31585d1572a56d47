//! A zone machine without a screen: its pixels over AXI4-Stream against the golden picture, with a receiver that stalls.

use super::request::stream_request;
use super::stalls::Stalls;
use super::zone_core::offer;
use super::{DisplayEngine, DisplayError, Machine};
use crate::report::{Mismatch, Report};
use imogene_models::machine::description::MachineDescription;
use imogene_models::machine::display::Image;
use std::time::Instant;

/// Sends the stream of an image and takes its pixels; both sides stall at random if there is a seed. Every pixel has to come exactly once, its word has
/// to stay while the receiver stalls, and the last one has to say so.
///
/// # Errors
///
/// When the hardware cannot be built or run.
pub fn run(
    machine: &MachineDescription,
    image: &Image,
    engine: DisplayEngine,
    stalls: Option<u64>,
) -> Result<Report, DisplayError> {
    let mut hardware = Machine::start(&stream_request(machine, ""), engine)?;
    let started = Instant::now();
    let mut report = Report {
        subject: hardware.name.clone(),
        engine: engine.name().into(),
        seed: stalls,
        ..Report::default()
    };
    let mut sender = Stalls::new(stalls);
    let mut receiver = Stalls::new(stalls.map(|seed| seed + 1));
    let pixels = image.frame.width * image.frame.height;
    let mut seen = vec![false; pixels];
    let (mut sent, mut idle, mut stalled) = (0, 0u64, None);
    hardware.set("m_tready", 0);
    hardware.clock();
    while report.pixels < pixels as u64 && idle < 1 << 20 {
        let is_ready = hardware.is_set("s_tready");
        let beat = image.beats.get(sent).filter(|_| !sender.stall());
        offer(&mut hardware, beat);
        sent += usize::from(beat.is_some() && is_ready);
        let takes = !receiver.stall();
        hardware.set("m_tready", takes.into());
        let now = hardware.is_set("m_tvalid").then(|| Pixel::of(&hardware));
        check(
            &mut report,
            &hardware,
            "m_tdata while the receiver stalls",
            stalled.is_none() || stalled == now,
        );
        stalled = now.filter(|_| !takes);
        idle += 1;
        if let Some(pixel) = now.filter(|_| takes) {
            idle = 0;
            pixel.compare(&hardware, image, &mut seen, &mut report);
        }
        hardware.clock();
    }
    check(
        &mut report,
        &hardware,
        "all pixels",
        seen.iter().all(|&seen| seen),
    );
    report.cycles = hardware.clocks;
    report.timed(started.elapsed().as_secs_f64());
    Ok(report)
}

/// A pixel on the stream.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Pixel {
    colour: i64,
    place: i64,
    is_last: bool,
}

impl Pixel {
    fn of(hardware: &Machine) -> Pixel {
        Pixel {
            colour: hardware.get("m_tdata").unwrap_or(-1),
            place: hardware.get("m_tuser").unwrap_or(-1),
            is_last: hardware.is_set("m_tlast"),
        }
    }

    fn compare(&self, hardware: &Machine, image: &Image, seen: &mut [bool], report: &mut Report) {
        let (x, y) = (self.place & 0xfff, self.place >> 12);
        let at = y as usize * image.frame.width + x as usize;
        let is_new = x < image.frame.width as i64
            && at < seen.len()
            && !std::mem::replace(&mut seen[at], true);
        check(report, hardware, "a pixel once", is_new);
        report.pixels += 1;
        check(
            report,
            hardware,
            "m_tlast",
            self.is_last == (report.pixels == seen.len() as u64),
        );
        let Some(wanted) = image.picture.get(3 * at..3 * at + 3) else {
            return;
        };
        let golden = wanted
            .iter()
            .fold(0, |word, byte| word << 8 | i64::from(*byte));
        let mismatch = || Mismatch {
            cycle: hardware.clocks,
            pixel: Some((x, y)),
            signal: "m_tdata".into(),
            hardware: Some(self.colour),
            golden,
        };
        report.compare(mismatch, self.colour == golden);
    }
}

fn check(report: &mut Report, hardware: &Machine, what: &str, holds: bool) {
    let mismatch = || Mismatch {
        cycle: hardware.clocks,
        pixel: None,
        signal: what.into(),
        hardware: Some(0),
        golden: 1,
    };
    report.compare(mismatch, holds);
}
