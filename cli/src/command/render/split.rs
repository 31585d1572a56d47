//! `imogene render --split`: the picture that workers draw piece by piece.

use super::super::threads;
use crate::arguments::{Model, Render};
use crate::failure::Failure;
use crate::output;
use imogene_plan::split::{Divided, Division, Duplication, Work, Worker};
use imogene_prepare::PreparedScene;
use serde::Serialize;

/// How the work was divided; the keys are stable.
#[derive(Serialize)]
pub struct SplitReport {
    split: Division,
    pieces: usize,
    work: Work,
    /// Mean load of a worker over the greatest, in pixels visited: 1 is even.
    balance: f64,
    /// The same if the pieces were taken from a common queue.
    balance_of_queue: f64,
    /// Mean seconds of a worker over the greatest.
    balance_of_seconds: f64,
    duplication: Duplication,
    workers: Vec<Worker>,
}

pub fn draw(
    options: &Render,
    division: Division,
    prepared: &PreparedScene,
) -> Result<(Divided, SplitReport), Failure> {
    if options.model != Model::Golden {
        return Err(Failure::Input(
            "a divided picture is drawn by the golden model; give --model golden, or leave --split out".into(),
        ));
    }
    prepared.refuse_transparent()?;
    let workers = options.split.workers.map_or_else(threads, usize::from);
    let pieces = division.pieces(prepared.width, prepared.height).len();
    let divided = output::during(pieces as u64, "pieces of the screen", |bar| {
        Divided::draw(prepared, division, workers, || bar.inc(1))
    });
    let report = SplitReport::of(&divided, division);
    Ok((divided, report))
}

impl SplitReport {
    fn of(divided: &Divided, division: Division) -> SplitReport {
        let seconds = divided.workers.iter().map(|worker| worker.seconds);
        let most = seconds.clone().fold(1e-9, f64::max);
        SplitReport {
            split: division,
            pieces: divided.pieces.len(),
            work: divided.work(),
            balance: divided.balance(),
            balance_of_queue: divided.balance_of_queue(),
            balance_of_seconds: seconds.sum::<f64>() / divided.workers.len() as f64 / most,
            duplication: divided.duplication,
            workers: divided.workers.clone(),
        }
    }
}
