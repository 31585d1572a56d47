//! Co-simulation of the shadow and light volumes of a scene: each on the zone of its screen box, on the depths that are
//! seen, its answers into the flags of the light sources.

use super::zone::{Engine, SlotError, Subjects, Zone};
use crate::report::Report;
use crate::subject::{Inputs, Subject};
use crate::unit::words::{Loaded, volume};
use crate::waveform::Sample;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::{ALL_SOURCES, Lighting};
use imogene_golden::object::volume::{VolumeKind, VolumeWords};
use imogene_golden::object::words::Words;
use imogene_prepare::PreparedScene;
use rayon::prelude::*;
use std::time::Instant;

/// Clocks from the visible depth to the answer, whatever the volume.
const FROM_DEPTH: usize = 3;

/// A volume that is on the screen.
struct Job<'a> {
    words: &'a VolumeWords,
    zone: Zone,
    loaded: Loaded,
}

/// Runs all volumes of a scene on a frame; `engine` may put another engine under a subject, `pixel_done` is told of
/// pixels, from any thread.
///
/// # Errors
///
/// When a processor cannot be co-simulated, or the engine cannot be built.
pub fn run(
    scene: &PreparedScene,
    frame: &Frame,
    rows_per_stage: usize,
    engine: Engine,
    pixel_done: impl Fn(u64) + Sync,
) -> Result<Report, SlotError> {
    let started = Instant::now();
    let jobs: Vec<Job> = jobs(scene).collect();
    let loaded = jobs.iter().map(|job| &job.loaded);
    let subjects = Subjects::new(loaded, rows_per_stage, engine)?;
    let parts: Vec<(Report, Vec<usize>)> = jobs
        .par_iter()
        .map(|job| {
            let part = job.run(subjects.of(&job.loaded), frame);
            pixel_done(part.0.pixels);
            part
        })
        .collect();
    let mut flags = vec![ALL_SOURCES; frame.depth.len()];
    // Outside a light volume is dark, also outside its box.
    for light in scene.volumes.iter().map(|v| &v.words) {
        if light.kind == VolumeKind::Light && light.screen_box.is_empty() {
            flags.iter_mut().for_each(|f| *f = light.after(*f, false));
        }
    }
    let mut report = Report::default();
    for (job, (part, inside)) in jobs.iter().zip(parts) {
        report.absorb(part);
        job.apply(&inside, &mut flags);
    }
    compare_flags(&flags, &scene.light(frame, || ()), frame, &mut report);
    report.timed(started.elapsed().as_secs_f64());
    Ok(report)
}

/// Pixels that [`run`] asks volumes about, for a progress bar.
pub fn pixels(scene: &PreparedScene) -> u64 {
    jobs(scene).map(|job| job.zone.pixels() as u64).sum()
}

fn jobs(scene: &PreparedScene) -> impl Iterator<Item = Job<'_>> {
    scene.volumes.iter().filter_map(|prepared| {
        let words = &prepared.words;
        let zone = Zone::around(&words.screen_box, scene.width, scene.height)?;
        let moved = words.for_zone(zone.x, zone.y, zone.width, zone.height);
        Some(Job {
            words,
            zone,
            loaded: volume(&moved, &scene.format),
        })
    })
}

impl Job<'_> {
    /// Asks hardware and golden model about the zone; the places that the hardware says are inside.
    fn run(&self, subject: &Subject, frame: &Frame) -> (Report, Vec<usize>) {
        let mut inside = Vec::new();
        let mut pixel = 0;
        let see = |sample: Sample| {
            if sample.hardware[0] != Some(1) {
                return;
            }
            if sample.hardware[1] == Some(1) {
                inside.push(self.zone.place(pixel, frame.width));
            }
            pixel += 1;
        };
        let report = subject.run_each(self.clocks(subject.latency, frame), see);
        (report, inside)
    }

    /// One pixel a clock, its depth as many clocks later as the volume takes to its own depths; then until the last
    /// answer.
    fn clocks(&self, latency: usize, frame: &Frame) -> impl Iterator<Item = Inputs> {
        let (zone, pixels) = (self.zone, self.zone.pixels());
        let entry = (latency - FROM_DEPTH) as i64;
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

    /// Takes the source's flag away where the volume is dark.
    fn apply(&self, inside: &[usize], flags: &mut [u16]) {
        match self.words.kind {
            VolumeKind::Shadow => {
                for &at in inside {
                    flags[at] = self.words.after(flags[at], true);
                }
            }
            VolumeKind::Light => {
                let mut lit = vec![false; flags.len()];
                inside.iter().for_each(|&at| lit[at] = true);
                for (flag, lit) in flags.iter_mut().zip(lit) {
                    *flag = self.words.after(*flag, lit);
                }
            }
        }
    }
}

/// Counts where hardware and golden machine do not agree on which sources reach a point.
fn compare_flags(hardware: &[u16], golden: &Lighting, frame: &Frame, report: &mut Report) {
    for (at, (&found, &wanted)) in hardware.iter().zip(&golden.flags).enumerate() {
        report.compare(
            0,
            Some(((at % frame.width) as i64, (at / frame.width) as i64)),
            "source flags",
            Some(found.into()),
            wanted.into(),
        );
    }
}
