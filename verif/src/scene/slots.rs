//! Co-simulation of a scene with processors of every kind: each processor by itself on the zone of its screen box, its results through the
//! decider's rule into a frame.
//!
//! The beam machine has quadric processors only. Here every slot's processor runs alone, clock by clock beside its golden model, from
//! the words that the preparation made; what all of them draw together is compared with the frame of the golden machine.

use crate::engine::design::DesignError;
use crate::report::{Mismatch, Report};
use crate::subject::{Inputs, Subject};
use crate::trace::Sample;
use crate::unit::words::{Loaded, processor};
use crate::unit::{UnitError, subject};
use imogene_models::format::Format;
use imogene_models::machine::beam::render;
use imogene_models::machine::frame::Frame;
use imogene_models::object::slot::{ProcessorWords, Slot};
use imogene_models::prepare::PreparedScene;
use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::EmitRequest;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::time::Instant;
use thiserror::Error;

/// Pixels around the screen box that are drawn too: the object is absent there.
const BORDER: i64 = 1;

/// A processor and its parameters: slots of the same kind share one description.
type Kind = (&'static str, Option<usize>, Option<usize>);

/// A slot that is on the screen.
struct Job<'a> {
    slot: &'a Slot,
    zone: Zone,
    loaded: Loaded,
}

/// Pixels that a processor draws.
#[derive(Clone, Copy)]
struct Zone {
    x: i64,
    y: i64,
    width: i64,
    height: i64,
}

/// What the hardware says of a pixel.
struct Drawn {
    at: usize,
    depth: i64,
    number: u8,
    normal: [i16; 3],
}

/// Puts another engine under the description of a unit that is emitted by a request.
pub type Engine<'a> = &'a (dyn Fn(Subject, &EmitRequest) -> Result<Subject, DesignError> + Sync);

/// Why a scene's processors cannot be co-simulated.
#[derive(Debug, Error)]
pub enum SlotError {
    /// A processor has no legal parameters.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// The engine cannot be built.
    #[error(transparent)]
    Design(#[from] DesignError),
}

/// Runs all processors of a scene; `engine` may put another engine under a subject, `pixel_done` is told of pixels, from any thread.
///
/// # Errors
///
/// When a processor cannot be co-simulated, or the engine cannot be built.
pub fn run(
    scene: &PreparedScene,
    rows_per_stage: usize,
    engine: Engine,
    pixel_done: impl Fn(u64) + Sync,
) -> Result<(Report, Frame), SlotError> {
    let started = Instant::now();
    let slots = scene.slots();
    let jobs: Vec<Job> = slots.iter().filter_map(|slot| job(slot, scene)).collect();
    let mut subjects: BTreeMap<Kind, Subject> = BTreeMap::new();
    for job in &jobs {
        let kind = job.kind();
        if !subjects.contains_key(&kind) {
            let parameters = job.loaded.parameters(&scene.format, rows_per_stage);
            let unit = Unit::from_name(kind.0).expect("a unit of the catalogue");
            let rust_hdl = subject(kind.0, parameters)?;
            subjects.insert(kind, engine(rust_hdl, &parameters.request(unit))?);
        }
    }
    let width = scene.width as usize;
    let parts: Vec<(Report, Vec<Drawn>)> = jobs
        .par_iter()
        .map(|job| {
            let part = job.run(&subjects[&job.kind()], &scene.format, width);
            pixel_done(part.0.pixels);
            part
        })
        .collect();
    let mut frame = Frame::background(width, scene.height as usize, scene.format.z_max());
    let mut report = Report::default();
    for (job, (part, drawn)) in jobs.iter().zip(parts) {
        report.absorb(part);
        drawn.iter().for_each(|pixel| job.decide(pixel, &mut frame));
    }
    let golden = render(&slots, &scene.format, width, scene.height as usize, || ());
    compare_frames(&frame, &golden, &mut report);
    report.timed(started.elapsed().as_secs_f64());
    Ok((report, frame))
}

/// Pixels that [`run`] draws, for a progress bar.
pub fn pixels(scene: &PreparedScene) -> u64 {
    let slots = scene.slots();
    let jobs = slots.iter().filter_map(|slot| job(slot, scene));
    jobs.map(|job| (job.zone.width * job.zone.height) as u64)
        .sum()
}

/// True if every object of the scene is drawn by a quadric processor, so that a beam machine can draw it.
pub fn is_for_beam(scene: &PreparedScene) -> bool {
    let slots = scene.slots();
    slots
        .iter()
        .all(|slot| matches!(slot.words, ProcessorWords::Quadric(_)))
}

fn job<'a>(slot: &'a Slot, scene: &PreparedScene) -> Option<Job<'a>> {
    let window = slot.words.screen_box();
    if window.is_empty() {
        return None;
    }
    let (x, y) = ((window.x0 - BORDER).max(0), (window.y0 - BORDER).max(0));
    let last = |edge: i64, size: u32| (edge + BORDER).min(i64::from(size) - 1);
    let zone = Zone {
        x,
        y,
        width: last(window.x1, scene.width) - x + 1,
        height: last(window.y1, scene.height) - y + 1,
    };
    let words = slot.words.for_zone(zone.x, zone.y, zone.width, zone.height);
    Some(Job {
        slot,
        zone,
        loaded: processor(&words, &scene.format),
    })
}

impl Job<'_> {
    fn kind(&self) -> Kind {
        (self.loaded.unit, self.loaded.planes, self.loaded.sides)
    }

    /// Draws the zone with hardware and golden model.
    fn run(&self, subject: &Subject, format: &Format, width: usize) -> (Report, Vec<Drawn>) {
        let mut drawn = Vec::new();
        let mut pixel = 0;
        let latency = subject.latency;
        let see = |sample: Sample| {
            if sample.hardware[0] != Some(1) {
                return;
            }
            let (x, y) = (pixel % self.zone.width, pixel / self.zone.width);
            pixel += 1;
            let value = |k: usize| sample.hardware[k].unwrap_or(format.z_max());
            if value(1) < format.z_max() {
                drawn.push(Drawn {
                    at: (self.zone.y + y) as usize * width + (self.zone.x + x) as usize,
                    depth: value(1),
                    number: value(3) as u8,
                    normal: [4, 5, 6].map(|k| value(k) as i16),
                });
            }
        };
        let report = subject.run_each(self.clocks(latency), see);
        (report, drawn)
    }

    /// One pixel a clock, then as many clocks as the last one takes.
    fn clocks(&self, latency: usize) -> impl Iterator<Item = Inputs> {
        let Zone { width, height, .. } = self.zone;
        let words = &self.loaded.words;
        let inputs = move |flags: [i64; 3], x: i64, y: i64| {
            let raster = flags.into_iter().chain([x, y]);
            raster.chain(words.iter().copied()).collect()
        };
        let raster = (0..width * height).map(move |n| {
            let (x, y) = (n % width, n / width);
            inputs([1, i64::from(n == 0), i64::from(x == 0 && y > 0)], x, y)
        });
        raster.chain((0..latency).map(move |_| inputs([0; 3], 0, 0)))
    }

    /// The decider's rule: the nearer one, at equal depth the earlier slot.
    fn decide(&self, pixel: &Drawn, frame: &mut Frame) {
        if pixel.depth < frame.depth[pixel.at] {
            frame.depth[pixel.at] = pixel.depth;
            frame.id[pixel.at] = self.slot.object as i32;
            frame.number[pixel.at] = pixel.number;
            frame.normal[pixel.at] = pixel.normal;
        }
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
            let mismatch = || Mismatch {
                cycle: 0,
                pixel: Some(((at % golden.width) as i64, (at / golden.width) as i64)),
                signal: format!("frame.{name}"),
                hardware: Some(found),
                golden: wanted,
            };
            report.compare(mismatch, found == wanted);
        }
    }
}
