//! A face taken apart by lines u = constant: whatever its border, each part lies between two of its pieces.
//!
//! The lines through all ends and turns of the border divide the surface into slabs. Within a slab the pieces of the
//! border keep their order, so that the face is the strips between every other two of them, and a strip is the AND of
//! six half-spaces at most: those of the slab, of the piece below and of that above, and of two parallels where the
//! surface is curved along v. The search of [`super::parting::terms`] finds fewer parts where it finds any; this always
//! ends.

mod keys;
mod sectors;
mod strips;

use super::cell::{Cell, Made};
use super::chart::{Chart, free_pole};
use super::curve::Curve;
use super::parting::Parting;
use super::rings::Band;
use super::task::Task;
use super::vector::{minus, unit};
use sectors::{Run, join};
use strips::{Rail, Slabs};

/// Most times that slabs are halved.
const MAX_HALVINGS: usize = 6;

/// The cells of a face between lines u = constant.
pub fn cells(
    task: Task,
    parting: &Parting,
    bands: &[Band],
    flat: Option<usize>,
) -> Made<Vec<Cell>> {
    let surface = &task.face().surface;
    let mut border = parting.boundaries.iter();
    let north = match surface.is_plane() {
        true => border.find_map(|own| match &own.curve {
            Curve::Line { from, to } => Some(unit(minus(*to, *from))),
            _ => None,
        }),
        false => free_pole(surface, &parting.separators),
    };
    let chart = Chart::of(surface, north);
    let rails = parting.boundaries.iter();
    let mut slabs = Slabs {
        rails: rails.map(|own| Rail::of(own, &chart)).collect(),
        limits: vec![],
        parallels: false,
        planes: task.planes,
        parting,
        bands,
        flat,
        size: task.model.size(),
        chart,
    };
    let mut more = vec![];
    for round in 0..=MAX_HALVINGS {
        slabs.limits = slabs.limits(&more);
        slabs.parallels = round > 0;
        match slabs.cells()? {
            Ok(cells) => return Ok(cells),
            Err(crowded) => more.extend(crowded),
        }
    }
    Err("parts of its border are too near to each other".into())
}

impl Slabs<'_> {
    /// The cells, or the u of slabs that have to be halved.
    fn cells(&self) -> Made<Result<Vec<Cell>, Vec<f64>>> {
        let strips = self.strips()?;
        let mut runs: Vec<Run> = vec![];
        let mut crowded = vec![];
        for strip in strips.iter().filter(|strip| strip.inside) {
            for part in self.bands_of(strip) {
                let keys = self.keys(strip, &part);
                if keys.is_none() {
                    crowded.push(self.middle(strip.slab));
                }
                for key in keys.into_iter().flatten() {
                    join(&mut runs, key, strip.slab, part.sample);
                }
            }
        }
        if !crowded.is_empty() {
            return Ok(Err(crowded));
        }
        if runs.is_empty() {
            return Err("its loops enclose nothing".into());
        }
        self.close(&mut runs);
        let mut cells = vec![];
        for run in &runs {
            for (span, sample) in self.sectors(run) {
                let cell = self.cell(run, span, sample);
                if self.takes_others(&cell, &strips) {
                    crowded.push(0.5 * (span[0] + span[1]));
                }
                cells.push(cell);
            }
        }
        crowded.extend(self.lost(&cells, &strips));
        let is_whole = crowded.is_empty();
        crowded.retain(|u| u.is_finite());
        Ok(if is_whole { Ok(cells) } else { Err(crowded) })
    }
}
