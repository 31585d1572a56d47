//! A face taken apart by lines u = constant: whatever its border, each part lies between two of its pieces.
//!
//! The lines through all ends and turns of the border divide the surface into slabs. Within a slab the pieces of the
//! border keep their order, so that the face is the strips between every other two of them, and a strip is the AND of
//! six half-spaces at most: those of the slab, of the piece below and of that above, and of two parallels where the
//! surface is curved along v. The search of [`super::terms`] finds fewer parts where it finds any; this always ends.

mod face;
mod keys;
mod probes;
mod rail;
mod sectors;
mod strips;
mod work;

pub use face::{Band, OVERLAP, Slabs};

use super::cell::Cell;
use super::planes::Planes;
use sectors::{Run, join};
use work::Work;

/// Most times that slabs are halved.
const MAX_HALVINGS: usize = 6;

impl Slabs<'_> {
    /// The cells of the face.
    pub fn cells(&self, planes: &mut Planes) -> Result<Vec<Cell>, String> {
        let chart = self.chart().ok_or("it has no coordinates")?;
        let rails = self.rails(&chart);
        let mut more = vec![];
        for round in 0..=MAX_HALVINGS {
            let work = Work {
                face: self,
                chart: &chart,
                rails: &rails,
                limits: self.limits(&chart, &rails, &more),
                parallels: round > 0,
            };
            match work.cells(planes)? {
                Ok(cells) => return Ok(cells),
                Err(crowded) => more.extend(crowded),
            }
        }
        Err("parts of its border are too near to each other".into())
    }
}

/// The u of slabs that have to be halved.
type Crowded = Vec<f64>;

impl Work<'_> {
    fn cells(&self, planes: &mut Planes) -> Result<Result<Vec<Cell>, Crowded>, String> {
        let strips = self.strips()?;
        let mut runs: Vec<Run> = vec![];
        let mut crowded = vec![];
        for (slab, strips) in strips.iter().enumerate() {
            let middle = self.middle(slab);
            for strip in strips.iter().filter(|strip| strip.inside) {
                for part in self.bands_of(slab, strip) {
                    let sample = self.chart.point(middle, part.v);
                    let keys = self.keys(slab, strip, &part, sample, planes);
                    if keys.is_none() {
                        crowded.push(middle);
                    }
                    for key in keys.into_iter().flatten() {
                        join(&mut runs, key, slab, sample);
                    }
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
                let cell = self.cell(run, span, sample, planes);
                if self.takes_others(&cell, &strips, planes) {
                    crowded.push(0.5 * (span[0] + span[1]));
                }
                cells.push(cell);
            }
        }
        crowded.extend(self.lost(&cells, &strips, planes));
        if crowded.is_empty() {
            return Ok(Ok(cells));
        }
        crowded.retain(|u| u.is_finite());
        Ok(Err(crowded))
    }
}
