//! A face taken apart by lines u = constant: whatever its border, each part lies between two of its pieces.
//!
//! The lines through all ends and turns of the border divide the surface into slabs. In a slab the pieces of the border
//! keep their order, so that the face is every other strip between them: the AND of six half-spaces at most, those of
//! the slab, of the pieces below and above, and of two parallels where the surface is curved along v. The search of
//! [`super::parting::terms`] finds fewer parts where it finds any; this always ends.

mod keys;
mod strips;

use super::arrangement::Parting;
use super::chart::{free_pole, nearest_turn};
use super::rings::Band;
use super::task::Task;
use super::vector::{Vector, minus, unit};
use super::{Cell, Chart, Curve, Made, Separator};
use keys::Key;
use std::f64::consts::TAU;
use strips::{Rail, Slabs, Strip, WIDEST_GAP};

const MAX_HALVINGS: usize = 6;
/// Places of a line v at which two planes are asked whether they keep more than a sector.
const PROBES: u32 = 64;
/// The widest sector between two planes through an axis, radians.
const WIDEST: f64 = 2.2;

pub fn cells(task: Task, border: &Parting, bands: &[Band], flat: Option<usize>) -> Made<Vec<Cell>> {
    let surface = &task.face().surface;
    let mut pieces = border.boundaries.iter();
    let north = match surface.is_plane() {
        true => pieces.find_map(|own| match &own.curve {
            Curve::Line { from, to } => Some(unit(minus(*to, *from))),
            _ => None,
        }),
        false => free_pole(surface, &border.separators),
    };
    let chart = Chart::of(surface, north);
    let pieces = border.boundaries.iter();
    let mut slabs = Slabs {
        rails: pieces.map(|own| Rail::of(own, &chart)).collect(),
        limits: vec![],
        parallels: false,
        planes: &task.part.planes,
        parting: border,
        bands,
        flat,
        size: task.part.model.size(),
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

struct Run {
    key: Key,
    slabs: [usize; 2],
    /// A point of it in every slab.
    samples: Vec<Vector>,
}

/// Adds a cell of a slab to the run that it continues.
fn join(runs: &mut Vec<Run>, key: Key, slab: usize, sample: Vector) {
    let mut before = runs.iter_mut().rev();
    match before.find(|run| run.slabs[1] + 1 == slab && run.key == key) {
        Some(run) => {
            run.slabs[1] = slab;
            run.samples.push(sample);
        }
        None => runs.push(Run {
            key,
            slabs: [slab; 2],
            samples: vec![sample],
        }),
    }
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

    /// On a round chart the last slab and the first are neighbours.
    fn close(&self, runs: &mut Vec<Run>) {
        let last = self.slabs().saturating_sub(1);
        if !self.chart.is_round() || last == 0 {
            return;
        }
        let mut index = 0;
        while index < runs.len() {
            let ends = runs[index].slabs;
            let other = runs.iter().position(|run| {
                run.slabs[0] == 0 && run.slabs[1] < ends[0] && run.key == runs[index].key
            });
            match other {
                Some(other) if ends[1] == last => {
                    let first = runs.remove(other);
                    let index = if other < index { index - 1 } else { index };
                    runs[index].slabs[1] = last + 1 + first.slabs[1];
                    runs[index].samples.extend(first.samples);
                }
                _ => index += 1,
            }
        }
    }

    /// The spans of u of a run, none wider than two planes through an axis can bound, each with a sample.
    fn sectors(&self, run: &Run) -> Vec<([f64; 2], Vector)> {
        let ends = [run.slabs[0], run.slabs[1] + 1];
        if !self.chart.is_round() {
            return vec![(ends.map(|end| self.limits[end]), run.samples[0])];
        }
        let slabs = self.slabs();
        if ends[1] - ends[0] == slabs {
            return vec![([f64::NEG_INFINITY, f64::INFINITY], run.samples[0])];
        }
        // The limits go on behind a whole turn.
        let limit = |end: usize| self.limits[end % slabs] + (end / slabs) as f64 * TAU;
        let [from, to] = ends.map(limit);
        let parts = ((to - from) / WIDEST).ceil().max(1.0);
        let step = (to - from) / parts;
        let v = self.chart.coordinates(run.samples[0])[1];
        let sector = |k: usize| {
            let span = [from + step * k as f64, from + step * (k + 1) as f64];
            (span, self.chart.point(0.5 * (span[0] + span[1]), v))
        };
        (0..parts as usize).map(sector).collect()
    }

    fn cell(&self, run: &Run, span: [f64; 2], sample: Vector) -> Cell {
        let parting = self.parting;
        let mut cell = Cell {
            quadric: self.bands[run.key.band].quadric,
            flat: self.flat,
            cuts: run.key.planes.clone(),
        };
        for (separator, positive) in &run.key.sides {
            if let Some(plane) = parting.planes[*separator] {
                cell.cuts.push((plane, *positive));
            } else if let Separator::Quadric(implicit) = parting.separators[*separator] {
                cell.quadric = Some(implicit.kept(*positive));
            }
        }
        if span[0].is_finite() {
            cell.cuts.extend(self.sides(span, sample));
        }
        cell.cuts.sort_unstable();
        cell.cuts.dedup();
        cell
    }

    /// The planes at both ends of a span: of edges, if together they keep nothing else of the line v.
    fn sides(&self, span: [f64; 2], sample: Vector) -> [(usize, bool); 2] {
        let v = self.chart.coordinates(sample)[1];
        let width = span[1] - span[0];
        let edges = span.map(|u| self.edge_at(u, span, v));
        let meridians = [0, 1].map(|end| {
            // The normal of a plane that was there before may point the other way.
            let inwards = if end == 0 { 1e-3 } else { -1e-3 } * width;
            let beside = self.chart.point(span[end] + inwards, v);
            self.cut(self.chart.meridian_plane(span[end]), beside)
        });
        let own = [0, 1].map(|end| edges[end].unwrap_or(meridians[end]));
        let elsewhere = |k: u32| {
            let u = span[1] + (TAU - width) * (f64::from(k) + 0.5) / f64::from(PROBES);
            let p = self.chart.point(u, v);
            own.iter()
                .all(|(plane, side)| self.planes.is_positive(*plane, p) == *side)
        };
        if !self.chart.is_round() || edges == [None; 2] || !(0..PROBES).any(elsewhere) {
            own
        } else {
            meridians
        }
    }

    /// The plane of an upright edge at an end of a span, if it has all of the span on one side.
    fn edge_at(&self, u: f64, span: [f64; 2], v: f64) -> Option<(usize, bool)> {
        let narrow = 2.0 * self.narrow();
        let mut upright = self.rails.iter().filter(|rail| rail.is_upright(narrow));
        upright.find_map(|rail| {
            let mut off = rail.path[0][0] - u;
            if self.chart.is_round() {
                off = nearest_turn(off, 0.0);
            }
            let plane = self.parting.planes[rail.separator].filter(|_| off.abs() <= narrow)?;
            let shares = [0.02, 0.5, 0.98].map(|share| span[0] + share * (span[1] - span[0]));
            let sides = shares.map(|u| self.planes.is_positive(plane, self.chart.point(u, v)));
            (sides == [sides[0]; 3]).then_some((plane, sides[0]))
        })
    }

    /// Whether cells are strips, without a doubt.
    fn is_exact(&self) -> bool {
        !self.chart.surface.is_sphere() && self.flat.is_none()
    }

    /// Slabs with places of the face that no cell has.
    fn lost(&self, cells: &[Cell], strips: &[Strip]) -> Vec<f64> {
        if self.is_exact() {
            return vec![];
        }
        let taken = |p: &Vector| cells.iter().any(|cell| cell.takes(*p, self.planes));
        let inside = self.probed(strips, true);
        let lost = inside.filter(|(_, places)| !places.iter().all(taken));
        lost.map(|(middle, _)| middle).collect()
    }

    /// Whether a cell has places of strips that are not of the face.
    fn takes_others(&self, cell: &Cell, strips: &[Strip]) -> bool {
        let mut outside = self.probed(strips, false).flat_map(|(_, places)| places);
        !self.is_exact() && outside.any(|p| cell.takes(p, self.planes))
    }

    /// For each strip that is of the face, or is not, the middle of its slab and places of it.
    fn probed(&self, strips: &[Strip], inside: bool) -> impl Iterator<Item = (f64, Vec<Vector>)> {
        let own = strips.iter().filter(move |strip| strip.inside == inside);
        own.map(|strip| {
            let middle = self.middle(strip.slab);
            let places = self.probes(strip.at).into_iter();
            let places = places.map(|v| self.chart.point(middle, v));
            (middle, places.collect())
        })
    }

    /// Places between two v, far out where one is open: a conic may come back there.
    fn probes(&self, [low, high]: [f64; 2]) -> Vec<f64> {
        if high - low <= WIDEST_GAP * self.size {
            return vec![];
        }
        let far = [0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0].map(|share| share * self.size);
        match (low.is_finite(), high.is_finite()) {
            (true, true) => [0.1, 0.5, 0.9]
                .map(|share| low + share * (high - low))
                .to_vec(),
            (true, false) => far.map(|way| low + way).to_vec(),
            (false, true) => far.map(|way| high - way).to_vec(),
            (false, false) => vec![0.0],
        }
    }
}
