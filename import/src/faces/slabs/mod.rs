//! A face taken apart by lines u = constant: whatever its border, each part lies between two of its pieces.
//!
//! The lines through all ends and turns of the border divide the surface into slabs. Within a slab the pieces of the
//! border keep their order, so that the face is the strips between every other two of them, and a strip is the AND of
//! six half-spaces at most: those of the slab, of the piece below and of that above, and of two parallels where the
//! surface is curved along v. The search of [`super::terms`] finds fewer parts where it finds any; this always ends.

mod keys;
mod sectors;
mod strips;

use super::cell::{Cell, Made, Planes};
use super::chart::{Chart, free_pole};
use super::compile::Task;
use super::curve::Curve;
use super::parting::Parting;
use super::surface::{Implicit, Surface};
use super::vector::{minus, unit};
use sectors::{Run, join};
use strips::Rail;

/// Most times that slabs are halved.
const MAX_HALVINGS: usize = 6;

/// Greatest gap between the ends of two pieces of a border that follow each other, in sizes of the part or radians.
pub const WIDEST_GAP: f64 = 1e-4;
/// Share of its height by which a band goes on under or over the next, so that the rounding of both leaves no pixel to
/// neither. Out there a chord is a twelfth of the deviation off.
pub const OVERLAP: f64 = 0.02;

/// A part of the surface between two parallels, drawn as one quadric.
#[derive(Clone, Debug)]
pub struct Band {
    /// Its quadric; nothing on a plane.
    pub quadric: Option<Implicit>,
    /// Least and greatest v.
    pub ends: [f64; 2],
    /// Share of its height by which it goes on beyond the border of its face, within the deviation.
    pub beyond: f64,
}

impl Band {
    pub fn whole(surface: &Surface) -> Vec<Band> {
        vec![Band {
            quadric: surface.implicit(),
            ends: [f64::NEG_INFINITY, f64::INFINITY],
            beyond: 0.0,
        }]
    }
}

struct Slabs<'a> {
    parting: &'a Parting,
    bands: &'a [Band],
    /// The plane of a face that is flat.
    flat: Option<usize>,
    /// Size of the part, scene units.
    size: f64,
    chart: Chart,
    rails: Vec<Rail>,
    /// The ends of all slabs of this try.
    limits: Vec<f64>,
    /// Strips are also bounded by parallels.
    parallels: bool,
}

/// The cells of a face between lines u = constant.
pub fn cells(
    task: Task,
    parting: &Parting,
    bands: &[Band],
    flat: Option<usize>,
    planes: &mut Planes,
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
        match slabs.cells(planes)? {
            Ok(cells) => return Ok(cells),
            Err(crowded) => more.extend(crowded),
        }
    }
    Err("parts of its border are too near to each other".into())
}

impl Slabs<'_> {
    fn slabs(&self) -> usize {
        self.limits.len().saturating_sub(1)
    }

    fn middle(&self, slab: usize) -> f64 {
        0.5 * (self.limits[slab] + self.limits[slab + 1])
    }

    /// The cells, or the u of slabs that have to be halved.
    fn cells(&self, planes: &mut Planes) -> Made<Result<Vec<Cell>, Vec<f64>>> {
        let strips = self.strips()?;
        let mut runs: Vec<Run> = vec![];
        let mut crowded = vec![];
        for strip in strips.iter().filter(|strip| strip.inside) {
            for part in self.bands_of(strip) {
                let keys = self.keys(strip, &part, planes);
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
                let cell = self.cell(run, span, sample, planes);
                if self.takes_others(&cell, &strips, planes) {
                    crowded.push(0.5 * (span[0] + span[1]));
                }
                cells.push(cell);
            }
        }
        crowded.extend(self.lost(&cells, &strips, planes));
        let is_whole = crowded.is_empty();
        crowded.retain(|u| u.is_finite());
        Ok(if is_whole { Ok(cells) } else { Err(crowded) })
    }
}
