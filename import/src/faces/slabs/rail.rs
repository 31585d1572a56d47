//! The border of a face on its way over the surface, and the lines that divide it into slabs.

use super::{Slabs, WIDEST_GAP};
use crate::faces::arrangement::{Boundary, SMALLEST_PIECE};
use crate::faces::chart::Chart;
use crate::faces::curve::Curve;
use crate::faces::vector::range;
use std::f64::consts::TAU;

/// Steps of an arc on its way over the surface.
const ARC_STEPS: usize = 96;

/// A piece of the border on its way over the surface.
pub struct Rail {
    pub separator: usize,
    pub path: Vec<[f64; 2]>,
    pub forward: bool,
}

impl Rail {
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

impl Slabs<'_> {
    pub fn rails(&self, chart: &Chart) -> Vec<Rail> {
        let rail = |boundary: &Boundary| {
            let steps = match boundary.curve {
                Curve::Line { .. } => 1,
                _ => ARC_STEPS,
            };
            Rail {
                separator: boundary.separator,
                path: chart.path(&boundary.curve.sampled(steps)),
                forward: boundary.forward,
            }
        };
        self.parting.boundaries.iter().map(rail).collect()
    }

    /// The ends of all slabs, ascending; the first again behind the last, once round, if u is an angle.
    pub fn limits(&self, chart: &Chart, rails: &[Rail], more: &[f64]) -> Vec<f64> {
        let mut limits: Vec<f64> = rails.iter().flat_map(Rail::limits).collect();
        limits.extend(more);
        limits.retain(|u| u.is_finite());
        if chart.is_round() {
            for u in &mut limits {
                *u = u.rem_euclid(TAU);
            }
        }
        limits.sort_by(f64::total_cmp);
        let narrow = self.narrow(chart);
        limits.dedup_by(|next, kept| *next - *kept <= narrow);
        if chart.is_round() {
            if limits.len() > 1 && limits[0] + TAU - limits[limits.len() - 1] <= narrow {
                limits.pop();
            }
            match limits.first() {
                Some(first) => limits.push(first + TAU),
                None => limits = vec![0.0, TAU],
            }
        }
        self.without_gaps(chart, rails, limits)
    }

    /// Limits without slabs between two ends that should be one: there a line crosses the border an odd number of
    /// times.
    pub fn without_gaps(&self, chart: &Chart, rails: &[Rail], mut limits: Vec<f64>) -> Vec<f64> {
        let widest = WIDEST_GAP * if chart.is_round() { 1.0 } else { self.size };
        let crossings = |u: f64| -> usize {
            let of = |rail: &Rail| rail.crossings(u, chart.is_round()).len();
            rails.iter().map(of).sum()
        };
        let mut slab = 0;
        while limits.len() > 2 && slab + 1 < limits.len() {
            let (from, to) = (limits[slab], limits[slab + 1]);
            if to - from > widest || crossings(0.5 * (from + to)) % 2 == 0 {
                slab += 1;
            } else if slab + 2 < limits.len() {
                limits.remove(slab + 1);
            } else if chart.is_round() {
                // The last limit is the first again.
                limits.remove(0);
                let last = limits.len() - 1;
                limits[last] = limits[0] + TAU;
            } else {
                limits.remove(slab);
            }
        }
        limits
    }

    /// Slabs that are no wider than this are none: two ends that should be one.
    pub fn narrow(&self, chart: &Chart) -> f64 {
        10.0 * SMALLEST_PIECE * if chart.is_round() { 1.0 } else { self.size }
    }
}
