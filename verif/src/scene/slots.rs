//! Co-simulation of a scene with processors of every kind, each by itself on the zone of its screen box.
//!
//! A beam machine has quadric processors only. Here the processor of each slot runs beside its golden model, from the
//! words of the preparation; what they draw together is compared with the frame of the golden machine.

use super::CosimError;
use super::zone::Zone;
use crate::engine::Engine;
use crate::report::{Report, place};
use crate::subject::{Inputs, Subject};
use crate::unit::words::processor;
use imogene_golden::format::Format;
use imogene_golden::machine::frame::Frame;
use imogene_golden::object::slot::{ProcessorWords, Slot};
use imogene_golden::object::words::Words;
use imogene_prepare::PreparedScene;
use std::time::Instant;

/// A slot that is on the screen and has hardware.
type Job<'a> = super::zone::Job<&'a Slot>;

/// What the hardware says of a pixel: its place, and depth, number and normal of what is seen there.
type Drawn = (usize, [i64; 5]);

/// Runs all processors of a scene in an engine; `pixel_done` is told of pixels, from any thread.
pub fn run(
    scene: &PreparedScene,
    rows_per_stage: usize,
    engine: Engine,
    pixel_done: impl Fn(u64) + Sync,
) -> Result<(Report, Frame), CosimError> {
    let started = Instant::now();
    if !scene.format.follows_depth_word() || scene.format.has_guards() {
        return Err(CosimError::OwnWords);
    }
    let slots = scene.slots();
    let is_without = |slot: &&Slot| processor(&slot.words, &scene.format).is_none();
    if let Some(slot) = slots.iter().find(is_without) {
        let object = scene.objects[slot.object].name();
        return Err(CosimError::NoHardware(object.to_owned()));
    }
    let jobs: Vec<Job> = slots.iter().filter_map(|slot| job(slot, scene)).collect();
    let width = scene.width as usize;
    let run = |job: &Job, subject: &Subject| job.run(subject, &scene.format, width);
    let parts = Job::run_all(&jobs, rows_per_stage, engine, pixel_done, run)?;
    let mut frame = Frame::background(width, scene.height as usize, scene.format.z_max());
    let mut report = Report::default();
    for (job, (part, drawn)) in jobs.iter().zip(parts) {
        report.absorb(part);
        for (at, [depth, number, normal @ ..]) in drawn {
            // The decider's rule: the nearer one, at equal depth the earlier slot.
            if depth < frame.depth[at] {
                frame.depth[at] = depth;
                frame.id[at] = job.of.object as i32;
                frame.number[at] = number as u8;
                frame.normal[at] = normal.map(|part| part as i16);
            }
        }
    }
    compare_frames(&frame, &scene.frame(|| ()), &mut report);
    report.timed(started.elapsed().as_secs_f64());
    Ok((report, frame))
}

/// Pixels that [`run`] draws, for a progress bar.
pub fn pixels(scene: &PreparedScene) -> u64 {
    let slots = scene.slots();
    let jobs = slots.iter().filter_map(|slot| job(slot, scene));
    jobs.map(|job| job.zone.pixels() as u64).sum()
}

/// True if a beam machine can draw the scene: it has quadric processors alone, and no more than there are slots.
pub fn is_for_beam(scene: &PreparedScene) -> bool {
    let slots = scene.slots();
    let is_quadric = |slot: &Slot| matches!(slot.words, ProcessorWords::Quadric(_));
    slots.iter().all(is_quadric) && slots.len() <= super::MAX_OBJECTS
}

fn job<'a>(slot: &'a Slot, scene: &PreparedScene) -> Option<Job<'a>> {
    let zone = Zone::around(slot.words.screen_box(), scene.width, scene.height)?;
    let words = slot.words.for_zone(zone.x, zone.y, zone.width, zone.height);
    Some(Job {
        of: slot,
        zone,
        loaded: processor(&words, &scene.format)?,
    })
}

impl Job<'_> {
    /// Draws the zone with hardware and golden model.
    fn run(&self, subject: &Subject, format: &Format, width: usize) -> (Report, Vec<Drawn>) {
        let mut drawn = Vec::new();
        let see = |at: usize, hardware: &[Option<i64>]| {
            let value = |k: usize| hardware[k].unwrap_or(format.z_max());
            if value(1) < format.z_max() {
                drawn.push((at, [1, 3, 4, 5, 6].map(value)));
            }
        };
        let report = self.drive(subject, self.clocks(subject.latency), width, see);
        (report, drawn)
    }

    /// One pixel a clock, then as many clocks as the last one takes.
    fn clocks(&self, latency: usize) -> impl Iterator<Item = Inputs> {
        let inputs = |raster: [i64; 5]| [&raster[..], &self.loaded.words].concat();
        let raster = (0..self.zone.pixels()).map(move |n| inputs(self.zone.raster(n)));
        raster.chain((0..latency).map(move |_| inputs([0; 5])))
    }
}

/// Counts what differs between the frames of the hardware and of the golden machine.
fn compare_frames(hardware: &Frame, golden: &Frame, report: &mut Report) {
    for at in 0..golden.depth.len() {
        let of = |frame: &Frame| {
            let [nx, ny, nz] = frame.normal[at].map(i64::from);
            let (id, number) = (i64::from(frame.id[at]), i64::from(frame.number[at]));
            [frame.depth[at], id, number, nx, ny, nz]
        };
        let names = ["depth", "id", "number", "nx", "ny", "nz"];
        for ((name, found), wanted) in names.into_iter().zip(of(hardware)).zip(of(golden)) {
            let (pixel, signal) = (place(at, golden.width), format!("frame.{name}"));
            report.compare(0, pixel, signal, Some(found), wanted);
        }
    }
}
