//! A face divided by lines u = constant: its border on its way over the surface, and the slabs.

use crate::faces::arrangement::Boundary;
use crate::faces::band::Band;
use crate::faces::cell::Planes;
use crate::faces::chart::Chart;
use crate::faces::curve::{Curve, PlaneOf};
use crate::faces::parting::Parting;
use crate::faces::vector::{Vector, range};
use std::f64::consts::TAU;

/// Greatest gap between the ends of two pieces of a border that follow each other, in sizes of the part or radians.
pub const WIDEST_GAP: f64 = 1e-4;

/// Steps of an arc on its way over the surface.
const ARC_STEPS: usize = 96;

/// A piece of the border on its way over the surface.
pub struct Rail {
    pub separator: usize,
    pub path: Vec<[f64; 2]>,
    pub forward: bool,
}

impl Rail {
    pub fn of(boundary: &Boundary, chart: &Chart) -> Rail {
        let steps = match boundary.curve {
            Curve::Line { .. } => 1,
            _ => ARC_STEPS,
        };
        Rail {
            separator: boundary.separator,
            path: chart.path(&boundary.curve.sampled(steps)),
            forward: boundary.forward,
        }
    }

    pub fn is_upright(&self, narrow: f64) -> bool {
        let [low, high] = range(self.path.iter().map(|[u, _]| *u));
        high - low <= narrow
    }

    /// The u of its ends and of the places where it turns back.
    pub fn limits(&self) -> Vec<f64> {
        let path = &self.path;
        let mut limits = vec![path[0][0], path[path.len() - 1][0]];
        for three in path.windows(3) {
            let [a, b, c] = [three[0][0], three[1][0], three[2][0]];
            if (b - a) * (c - b) < 0.0 {
                // The top of the parabola through the three.
                let bend = a - 2.0 * b + c;
                limits.push(b - (c - a) * (c - a) / (8.0 * bend));
            }
        }
        limits
    }

    /// v where it crosses the line u, and whether it runs eastwards there.
    pub fn crossings(&self, u: f64, round: bool) -> Vec<(f64, bool)> {
        let mut found = vec![];
        for pair in self.path.windows(2) {
            let [[a, v], [b, w]] = [pair[0], pair[1]];
            let (low, high) = (a.min(b), a.max(b));
            // The same line, as often as the path has gone round.
            let turns = if round { ((low - u) / TAU).ceil() } else { 0.0 };
            let at = u + turns * TAU;
            if at >= low && at < high {
                found.push((v + (w - v) * (at - a) / (b - a), b > a));
            }
        }
        found
    }
}

/// A face divided by lines u = constant.
pub struct Slabs<'a> {
    pub planes: &'a Planes,
    pub parting: &'a Parting,
    pub bands: &'a [Band],
    /// The plane of a face that is flat.
    pub flat: Option<usize>,
    /// Size of the part, scene units.
    pub size: f64,
    pub chart: Chart,
    pub rails: Vec<Rail>,
    /// The ends of all slabs of this try.
    pub limits: Vec<f64>,
    /// Strips are also bounded by parallels.
    pub parallels: bool,
}

impl Slabs<'_> {
    pub fn slabs(&self) -> usize {
        self.limits.len().saturating_sub(1)
    }

    /// A plane, and the side of it on which a point is.
    pub fn cut(&self, (origin, normal): PlaneOf, inside: Vector) -> (usize, bool) {
        let plane = self.planes.find_or_add(origin, normal);
        (plane, self.planes.is_positive(plane, inside))
    }

    pub fn middle(&self, slab: usize) -> f64 {
        0.5 * (self.limits[slab] + self.limits[slab + 1])
    }
}
