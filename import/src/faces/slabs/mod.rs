//! A face taken apart by lines u = constant: whatever its border, each part lies between two of its pieces.
//!
//! The lines through all ends and turns of the border divide the surface into slabs. Within a slab the pieces of the
//! border keep their order, so that the face is the strips between every other two of them, and a strip is the AND of
//! six half-spaces at most: those of the slab, of the piece below and of that above, and of two parallels where the
//! surface is curved along v. The search of [`super::terms`] finds fewer parts where it finds any; this always ends.

mod keys;
mod rail;
mod sectors;
mod strips;

use super::cell::Cell;
use super::chart::{Chart, free_pole};
use super::curve::Curve;
use super::parting::Parting;
use super::planes::Planes;
use super::surface::{Implicit, Surface};
use super::vector::{minus, unit};
use rail::Rail;
use sectors::{Run, join};

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

pub struct Slabs<'a> {
    pub surface: &'a Surface,
    pub parting: &'a Parting,
    pub bands: &'a [Band],
    /// The plane of a face that is flat.
    pub flat: Option<usize>,
    /// Size of the part, scene units.
    pub size: f64,
}

/// One try with the ends of slabs.
pub struct Work<'a> {
    pub face: &'a Slabs<'a>,
    pub chart: &'a Chart,
    pub rails: &'a [Rail],
    pub limits: Vec<f64>,
    /// Strips are also bounded by parallels.
    pub parallels: bool,
}

impl Slabs<'_> {
    fn chart(&self) -> Chart {
        let line = |curve: &Curve| match curve {
            Curve::Line { from, to } => Some(unit(minus(*to, *from))),
            _ => None,
        };
        let mut border = self.parting.boundaries.iter();
        let north = match self.surface.is_plane() {
            true => border.find_map(|own| line(&own.curve)),
            false => free_pole(self.surface, &self.parting.separators),
        };
        Chart::of(self.surface, north)
    }

    pub fn cells(&self, planes: &mut Planes) -> Result<Vec<Cell>, String> {
        let chart = self.chart();
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
    pub fn slabs(&self) -> usize {
        self.limits.len().saturating_sub(1)
    }

    pub fn middle(&self, slab: usize) -> f64 {
        0.5 * (self.limits[slab] + self.limits[slab + 1])
    }

    fn cells(&self, planes: &mut Planes) -> Result<Result<Vec<Cell>, Crowded>, String> {
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
        if crowded.is_empty() {
            return Ok(Ok(cells));
        }
        crowded.retain(|u| u.is_finite());
        Ok(Err(crowded))
    }
}
