//! Exact repair: short words everywhere, exact arithmetic where they cannot decide (Claux, IV.2.4 and IV.2.5).
//!
//! A pixel is *open* if the proven bounds of the words leave presence, face or order of objects to the rounding
//! ([`Jury`]), or if an object of a processor without such bounds can be on it. Open pixels are solved exactly and
//! replace those of the first pass; all others keep its words bit for bit. Then object and face are the true ones at
//! every pixel: by proof where the words decided, by computation where they did not.

use imogene_analysis::bounds::Jury;
use imogene_analysis::exact::render::{render_where, to_frame};
use imogene_golden::machine::frame::Frame;
use imogene_prepare::PreparedScene;
use imogene_scene::FramedScene;
use serde::Serialize;
use std::time::Instant;

/// A repaired picture.
pub struct Repaired {
    /// What the words alone drew.
    pub first: Frame,
    /// The repaired picture: depth words of the format, exact ones rounded down.
    pub frame: Frame,
    /// The pixels that were solved exactly.
    pub open: Vec<bool>,
    /// What was done.
    pub report: RepairReport,
}

/// What a repair did.
#[derive(Clone, Debug, Default, Serialize)]
pub struct RepairReport {
    /// Pixels of the picture.
    pub pixels: usize,
    /// Pixels solved exactly.
    pub open: usize,
    /// Of these, pixels at which the first pass showed another object or face.
    pub mended: usize,
    /// Seconds of the first pass.
    pub first_seconds: f64,
    /// Seconds of finding the open pixels.
    pub find_seconds: f64,
    /// Seconds of solving them.
    pub solve_seconds: f64,
}

/// Draws and repairs; `prepared` must come from `scene`. `done` is called once a line of the repair, from any thread.
pub fn repair(scene: &FramedScene, prepared: &PreparedScene, done: impl Fn() + Sync) -> Repaired {
    let format = &prepared.format;
    let started = Instant::now();
    let first = prepared.frame(|| ());
    let first_seconds = started.elapsed().as_secs_f64();
    let started = Instant::now();
    let open = open_pixels(prepared);
    let find_seconds = started.elapsed().as_secs_f64();
    let started = Instant::now();
    let solved = render_where(scene, format, |index| open[index], done);
    let exact = to_frame(&solved, scene, format);
    let mut frame = first.clone();
    let mut mended = 0;
    for index in (0..open.len()).filter(|&i| open[i]) {
        let (was, is) = (face(&first, index), face(&exact, index));
        mended += usize::from(was != is);
        frame.take(index, &exact);
    }
    let solve_seconds = started.elapsed().as_secs_f64();
    Repaired {
        report: RepairReport {
            pixels: open.len(),
            open: open.iter().filter(|open| **open).count(),
            mended,
            first_seconds,
            find_seconds,
            solve_seconds,
        },
        first,
        frame,
        open,
    }
}

/// The pixels that the words do not decide.
pub fn open_pixels(prepared: &PreparedScene) -> Vec<bool> {
    let mut open = Jury::of_words(prepared).undecided();
    for object in prepared.objects.iter().filter(|o| o.quadric().is_none()) {
        let window = object.screen_box();
        if window.is_empty() {
            continue;
        }
        for y in window.y0..=window.y1 {
            let line = y as usize * prepared.width as usize;
            open[line + window.x0 as usize..=line + window.x1 as usize].fill(true);
        }
    }
    open
}

/// Object and face at a pixel.
pub fn face(frame: &Frame, index: usize) -> (i32, u8) {
    (frame.id[index], frame.number[index])
}

/// Pixels at which two pictures show another object or face.
pub fn differing_faces(one: &Frame, other: &Frame) -> usize {
    let all = 0..one.id.len();
    all.filter(|&i| face(one, i) != face(other, i)).count()
}

impl Repaired {
    /// True if every pixel that was not open is as the first pass left it, bit for bit.
    pub fn leaves_the_rest(&self) -> bool {
        (0..self.open.len()).filter(|&i| !self.open[i]).all(|i| {
            let words = |f: &Frame| (f.depth[i], f.id[i], f.number[i], f.normal[i]);
            words(&self.first) == words(&self.frame)
        })
    }
}
