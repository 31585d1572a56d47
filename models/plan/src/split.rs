//! A picture divided among workers: rectangular zones, or groups of interleaved lines (source: 1.3.2, 2.4.4, 4.1.3).
//!
//! Each worker draws its own pieces of the screen, from coefficients that are moved to the piece in whole numbers, and
//! knows nothing of the others. The picture is that of the whole screen, bit for bit.

mod division;
mod duplication;
mod piece;

pub use division::{Division, DivisionError, Piece};
pub use duplication::{Duplication, expected};

use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::{ALL_SOURCES, Lighting};
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
        collect(scene, division, &slots, pieces.len(), results)
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

fn collect(
    scene: &PreparedScene,
    division: Division,
    slots: &[Slot],
    pieces: usize,
    results: Vec<(Vec<(usize, DrawnPiece)>, f64)>,
) -> Divided {
    let (width, height) = (scene.width as usize, scene.height as usize);
    let mut frame = Frame::background(width, height, scene.format.z_max());
    let mut flags = vec![ALL_SOURCES; width * height];
    let mut workers = vec![];
    let mut works = vec![Work::default(); pieces];
    for (drawn, seconds) in results {
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
        workers.push(worker);
    }
    Divided {
        frame,
        lighting: Lighting { flags },
        workers,
        pieces: works,
        duplication: Duplication::of(slots, division, scene.width, scene.height),
    }
}
