//! Co-simulation of shadow and light volumes, each on its screen box: on visible depths, into flags of the sources.

use super::CosimError;
use super::zone::Zone;
use crate::engine::Engine;
use crate::report::{Report, place};
use crate::subject::{Inputs, Subject};
use crate::unit::words::volume;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::ALL_SOURCES;
use imogene_golden::object::volume::{FROM_DEPTH, VolumeKind, VolumeWords};
use imogene_golden::object::words::Words;
use imogene_prepare::PreparedScene;
use std::time::Instant;

/// A volume that is on the screen.
type Job<'a> = super::zone::Job<&'a VolumeWords>;

/// Runs all volumes of a scene on a frame in an engine; `pixel_done` is told of pixels, from any thread.
pub fn run(
    scene: &PreparedScene,
    frame: &Frame,
    rows_per_stage: usize,
    engine: Engine,
    pixel_done: impl Fn(u64) + Sync,
) -> Result<Report, CosimError> {
    let started = Instant::now();
    let jobs: Vec<Job> = jobs(scene).collect();
    let run = |job: &Job, subject: &Subject| job.run(subject, frame);
    let parts = Job::run_all(&jobs, rows_per_stage, engine, pixel_done, run)?;
    let mut flags = vec![ALL_SOURCES; frame.depth.len()];
    // Outside a light volume is dark, also outside its box.
    for light in scene.volume_words() {
        if light.kind == VolumeKind::Light && light.screen_box.is_empty() {
            flags.iter_mut().for_each(|f| *f = light.after(*f, false));
        }
    }
    let mut report = Report::default();
    for (job, (part, inside)) in jobs.iter().zip(parts) {
        report.absorb(part);
        for (flag, is_inside) in flags.iter_mut().zip(inside) {
            *flag = job.of.after(*flag, is_inside);
        }
    }
    let golden = scene.light(frame, || ());
    for (at, (&found, &wanted)) in flags.iter().zip(&golden.flags).enumerate() {
        let (pixel, found) = (place(at, frame.width), Some(found.into()));
        report.compare(0, pixel, "source flags", found, wanted.into());
    }
    report.timed(started.elapsed().as_secs_f64());
    Ok(report)
}

/// Pixels that [`run`] asks volumes about, for a progress bar.
pub fn pixels(scene: &PreparedScene) -> u64 {
    jobs(scene).map(|job| job.zone.pixels() as u64).sum()
}

fn jobs(scene: &PreparedScene) -> impl Iterator<Item = Job<'_>> {
    scene.volume_words().into_iter().filter_map(|words| {
        let zone = Zone::around(&words.screen_box, scene.width, scene.height)?;
        let moved = words.for_zone(zone.x, zone.y, zone.width, zone.height);
        Some(Job {
            of: words,
            zone,
            loaded: volume(&moved, &scene.format),
        })
    })
}

impl Job<'_> {
    /// Asks hardware and golden model about the zone; whether the hardware says that a place on the screen is inside.
    fn run(&self, subject: &Subject, frame: &Frame) -> (Report, Vec<bool>) {
        let mut inside = vec![false; frame.depth.len()];
        let see = |at: usize, hardware: &[Option<i64>]| inside[at] = hardware[1] == Some(1);
        let clocks = self.clocks(subject.latency, frame);
        let report = self.drive(subject, clocks, frame.width, see);
        (report, inside)
    }

    /// One pixel a clock, its depth as many clocks later as the volume wants it; then until the last answer.
    fn clocks(&self, latency: usize, frame: &Frame) -> impl Iterator<Item = Inputs> {
        let (zone, pixels) = (self.zone, self.zone.pixels());
        let entry = match self.of.quadric {
            Some(_) => latency as i64 - i64::from(FROM_DEPTH),
            None => 0,
        };
        (0..pixels + latency as i64).map(move |n| {
            let raster = if n < pixels { zone.raster(n) } else { [0; 5] };
            let seen = n - entry;
            let depth = if (0..pixels).contains(&seen) {
                frame.depth[zone.place(seen, frame.width)]
            } else {
                0
            };
            let words = self.loaded.words.iter().copied();
            raster.into_iter().chain([depth]).chain(words).collect()
        })
    }
}
