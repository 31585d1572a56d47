//! A picture divided among workers: rectangular zones, or groups of interleaved lines (source: 1.3.2, 2.4.4, 4.1.3).
//!
//! Each worker draws its own pieces of the screen, from coefficients that are moved to the piece in whole numbers, and
//! knows nothing of the others. The picture is that of the whole screen, bit for bit.
//!
//! An object is loaded as often as pieces touch it (source: 5.5). A box of `l x h` pixels anywhere on zones of `L x H`
//! touches `(l + L)(h + H) / LH` of them on average, says the source, for boxes that may begin anywhere between pixels.
//! On whole pixels, where a box of one pixel touches one zone, the average over all places is `(l + L - 1)(h + H - 1) /
//! LH`, for boxes of any size.

mod division;
mod piece;

pub use division::{Division, DivisionError, Piece};

use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::{ALL_SOURCES, Lighting};
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::slot::Slot;
use imogene_prepare::PreparedScene;
use piece::DrawnPiece;
pub use piece::Work;
use rayon::prelude::*;
use serde::Serialize;
use std::time::Instant;

/// What one worker did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Worker {
    /// Pieces of the screen.
    pub pieces: u64,
    /// Its work on all of them.
    pub work: Work,
    /// Seconds that it was at work.
    pub seconds: f64,
}

/// A picture that workers have drawn together.
#[derive(Clone, Debug)]
pub struct Divided {
    /// The frame.
    pub frame: Frame,
    /// What the volumes leave of the sources.
    pub lighting: Lighting,
    /// The workers; worker i of N has the pieces i, i + N, i + 2 N, ..
    pub workers: Vec<Worker>,
    /// Work of each piece.
    pub pieces: Vec<Work>,
    /// How often objects are loaded.
    pub duplication: Duplication,
}

impl Divided {
    /// Draws a scene with `workers` workers, at least one; `piece_done` is called once a piece, from any thread.
    pub fn draw(
        scene: &PreparedScene,
        division: Division,
        workers: usize,
        piece_done: impl Fn() + Sync,
    ) -> Divided {
        let slots = scene.slots();
        let volumes = scene.volume_words();
        let pieces = division.pieces(scene.width, scene.height);
        let number = workers.max(1);
        let one = |worker: usize| {
            let started = Instant::now();
            let own = pieces.iter().enumerate().skip(worker).step_by(number);
            let draw = |(index, piece): (usize, &Piece)| {
                let drawn = DrawnPiece::draw(*piece, &slots, &volumes, scene);
                piece_done();
                (index, drawn)
            };
            let drawn: Vec<(usize, DrawnPiece)> = own.map(draw).collect();
            (drawn, started.elapsed().as_secs_f64())
        };
        let results: Vec<_> = (0..number).into_par_iter().map(one).collect();
        let (width, height) = (scene.width as usize, scene.height as usize);
        let mut frame = Frame::background(width, height, scene.format.z_max());
        let mut flags = vec![ALL_SOURCES; width * height];
        let mut works = vec![Work::default(); pieces.len()];
        let workers = results.into_iter().map(|(drawn, seconds)| {
            let mut worker = Worker {
                pieces: drawn.len() as u64,
                seconds,
                ..Worker::default()
            };
            for (index, piece) in drawn {
                worker.work += piece.work;
                works[index] = piece.work;
                piece.put_into(&mut frame, &mut flags);
            }
            worker
        });
        Divided {
            workers: workers.collect(),
            frame,
            lighting: Lighting { flags },
            pieces: works,
            duplication: Duplication::of(&slots, division, scene.width, scene.height),
        }
    }

    /// All work.
    pub fn work(&self) -> Work {
        let mut sum = Work::default();
        for worker in &self.workers {
            sum += worker.work;
        }
        sum
    }

    /// Mean load of a worker over the greatest: 1 if all have the same number of pixels to visit, 1/N if one has them
    /// all.
    pub fn balance(&self) -> f64 {
        balance(self.workers.iter().map(|worker| worker.work.pixels()))
    }

    /// The same if the next piece always went to the worker that is done first, at one pixel a step: what a common
    /// queue gives instead of fixed links.
    pub fn balance_of_queue(&self) -> f64 {
        let mut loads = vec![0; self.workers.len()];
        for piece in &self.pieces {
            // The first of the least loaded.
            let least = loads.iter_mut().min_by_key(|load| **load);
            *least.expect("a worker") += piece.pixels();
        }
        balance(loads.into_iter())
    }
}

fn balance(loads: impl ExactSizeIterator<Item = u64> + Clone) -> f64 {
    let workers = loads.len() as f64;
    let (sum, most): (u64, u64) = (loads.clone().sum(), loads.max().unwrap_or(0));
    if most == 0 {
        1.0
    } else {
        sum as f64 / workers / most as f64
    }
}

/// How often objects are loaded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Duplication {
    /// Processors with at least a pixel of the screen to visit.
    pub boxes: u64,
    /// Loads of all pieces.
    pub loads: u64,
    /// Loads of a box: the mean of what was counted.
    pub measured: f64,
    /// The source's formula, mean over the boxes.
    pub formula: f64,
    /// The formula for whole pixels, mean over the boxes.
    pub on_whole_pixels: f64,
}

impl Duplication {
    fn of(slots: &[Slot], division: Division, width: u32, height: u32) -> Duplication {
        let pieces = division.pieces(width, height);
        let mut sum = Duplication::default();
        for slot in slots {
            let window = slot.words.screen_box();
            if window.is_empty() {
                continue;
            }
            let touches = |piece: &&Piece| !piece.part_of(window).is_empty();
            sum.boxes += 1;
            sum.loads += pieces.iter().filter(touches).count() as u64;
            let [formula, whole] = expected(window, division);
            sum.formula += formula;
            sum.on_whole_pixels += whole;
        }
        let boxes = sum.boxes.max(1) as f64;
        Duplication {
            measured: sum.loads as f64 / boxes,
            formula: sum.formula / boxes,
            on_whole_pixels: sum.on_whole_pixels / boxes,
            ..sum
        }
    }
}

/// Pieces that a box of this size touches, by the source's formula and on whole pixels.
///
/// Of n interleaved groups, h lines touch the smaller of n and h wherever they are; the source has no formula for them.
pub fn expected(window: &ScreenBox, division: Division) -> [f64; 2] {
    let size = window.size().map(|n| n as f64);
    match division {
        Division::Zones { width, height } => {
            let zone = [width, height].map(f64::from);
            [0.0, 1.0].map(|less| {
                let along = |k: usize| (size[k] + zone[k] - less) / zone[k];
                along(0) * along(1)
            })
        }
        Division::Lines(groups) => [size[1].min(groups.into()); 2],
    }
}
