//! Processors that run by themselves on the zone of their screen box.

use super::CosimError;
use crate::engine::Engine;
use crate::report::Report;
use crate::subject::{Inputs, Subject};
use crate::unit::words::Loaded;
use imogene_contract::Request;
use imogene_golden::object::quadric::ScreenBox;
use rayon::prelude::*;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// Pixels around the screen box that are drawn too: the object is absent there.
const BORDER: i64 = 1;

/// A processor that runs by itself: what it is for, its zone, and its words there.
pub(super) struct Job<T> {
    pub of: T,
    pub zone: Zone,
    pub loaded: Loaded,
}

impl<T: Sync> Job<T> {
    /// Runs all jobs, each on the description of its processor; `pixel_done` is told of pixels, from any thread.
    pub fn run_all<D: Send>(
        jobs: &[Job<T>],
        rows_per_stage: usize,
        engine: Engine,
        pixel_done: impl Fn(u64) + Sync,
        run: impl Fn(&Job<T>, &Subject) -> (Report, D) + Sync,
    ) -> Result<Vec<(Report, D)>, CosimError> {
        let mut subjects: HashMap<Request, Subject> = HashMap::new();
        for Job { loaded, .. } in jobs {
            if let Entry::Vacant(place) = subjects.entry(loaded.request) {
                let request = Request {
                    rows_per_stage: rows_per_stage as u32,
                    ..loaded.request
                };
                place.insert(engine.unit(&request)?);
            }
        }
        let one = |job: &Job<T>| {
            let part = run(job, &subjects[&job.loaded.request]);
            pixel_done(part.0.pixels);
            part
        };
        Ok(jobs.par_iter().map(one).collect())
    }

    /// Gives hardware and golden model these clocks; `see` takes each pixel of the hardware and its place.
    pub fn drive(
        &self,
        subject: &Subject,
        clocks: impl Iterator<Item = Inputs>,
        screen_width: usize,
        mut see: impl FnMut(usize, &[Option<i64>]),
    ) -> Report {
        let mut pixel = 0;
        subject.run_each(clocks, |sample| {
            if sample.hardware[0] == Some(1) {
                see(self.zone.place(pixel, screen_width), sample.hardware);
                pixel += 1;
            }
        })
    }
}

/// Pixels that a processor draws.
#[derive(Clone, Copy, Debug)]
pub(super) struct Zone {
    /// First column.
    pub x: i64,
    /// First line.
    pub y: i64,
    pub width: i64,
    pub height: i64,
}

impl Zone {
    /// The screen box with a border, as far as there is a screen; `None` if the box is empty.
    pub fn around(window: &ScreenBox, width: u32, height: u32) -> Option<Zone> {
        if window.is_empty() {
            return None;
        }
        let (x, y) = ((window.x0 - BORDER).max(0), (window.y0 - BORDER).max(0));
        let last = |edge: i64, size: u32| (edge + BORDER).min(i64::from(size) - 1);
        Some(Zone {
            x,
            y,
            width: last(window.x1, width) - x + 1,
            height: last(window.y1, height) - y + 1,
        })
    }

    pub fn pixels(&self) -> i64 {
        self.width * self.height
    }

    /// Column and line in the zone of pixel `n`, and its raster flags.
    pub fn raster(&self, n: i64) -> [i64; 5] {
        let (x, y) = (n % self.width, n / self.width);
        [1, i64::from(n == 0), i64::from(x == 0 && y > 0), x, y]
    }

    /// Place on the screen of pixel `n`, row by row.
    pub fn place(&self, n: i64, screen_width: usize) -> usize {
        let (x, y) = (n % self.width, n / self.width);
        (self.y + y) as usize * screen_width + (self.x + x) as usize
    }
}
