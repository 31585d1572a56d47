//! The planes and the quadric that bound a strip within a slab.

use super::strips::{Crossing, Slabs, Strip};
use crate::faces::rings::OVERLAP;
use crate::faces::vector::{Vector, range};
use crate::faces::{Form, Separator};
use std::f64::consts::TAU;

/// What a band has of a strip.
pub struct Part {
    pub band: usize,
    /// Of the band, as many turns on as the strip is.
    pub ends: [f64; 2],
    /// A point of both.
    pub sample: Vector,
    pub goes_on: [bool; 2],
}

/// A separator and its side.
type Side = (usize, bool);

/// Planes and at most one quadric of a cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    pub band: usize,
    pub sides: Vec<Side>,
    pub planes: Vec<(usize, bool)>,
}

impl Slabs<'_> {
    /// The bands that a strip has a part of, with their ends at its turn.
    pub fn bands_of(&self, strip: &Strip) -> Vec<Part> {
        let [low, high] = self.extent(strip);
        let turns = match self.chart.surface.form {
            Form::Torus(..) => -1..=2,
            _ => 0..=0,
        };
        let mut found = vec![];
        for (band, own) in self.bands.iter().enumerate() {
            for turn in turns.clone() {
                let ends = own.ends.map(|v| v + f64::from(turn) * TAU);
                let height = Some(ends[1] - ends[0]).filter(|height| height.is_finite());
                let least = 1e-9 * height.unwrap_or(1.0);
                if ends[1].min(high) - ends[0].max(low) > least {
                    let v = self.inner(strip.at, ends);
                    found.push(Part {
                        band,
                        ends,
                        sample: self.chart.point(self.middle(strip.slab), v),
                        goes_on: [low < ends[0] - least, high > ends[1] + least],
                    });
                }
            }
        }
        found
    }

    /// What bounds a strip in a band: one cell, or two between two conics; `None` if these are too near.
    pub fn keys(&self, strip: &Strip, part: &Part) -> Option<Vec<Key>> {
        let separators = &self.parting.separators;
        let side = |crossing: &Crossing| -> Side {
            let separator = self.rails[crossing.rail].separator;
            (separator, separators[separator].is_positive(part.sample))
        };
        let ranges = self.ranges(strip);
        let mut key = Key {
            band: part.band,
            sides: vec![],
            planes: self.band_planes(part),
        };
        let least = 1e-9 * (part.ends[1] - part.ends[0]).min(1.0);
        for end in 0..2 {
            let (Some(crossing), Some(range)) = (&strip.ends[end], ranges[end]) else {
                continue;
            };
            let comes_in = match end {
                0 => range[1] > part.ends[0] + least,
                _ => range[0] < part.ends[1] - least,
            };
            let side = side(crossing);
            if comes_in && !key.sides.contains(&side) {
                key.sides.push(side);
            }
            if self.parallels {
                let parallel = self.chart.parallel_plane(range[end]);
                key.planes.push(self.cut(parallel, part.sample));
            }
        }
        let mut keys = self.between_conics(strip, key)?;
        for (end, crossing) in strip.ends.iter().enumerate() {
            let (Some(crossing), Some(range)) = (crossing, ranges[end]) else {
                continue;
            };
            let own = side(crossing);
            let same = strip.ends[1 - end].is_some_and(|other| side(&other) == own);
            let Some(back) = self.comes_back(strip, crossing).filter(|_| !same) else {
                continue;
            };
            // The part of the strip that it crosses again is parted off, and needs it no more.
            let (beyond, near) = (back[end], range[1 - end]);
            if (end == 0 && near >= beyond) || (end == 1 && beyond >= near) {
                return None;
            }
            let part = |key: Key| match key.sides.contains(&own) {
                true => self.halves(&key, strip, [(beyond, Some(own)), (near, None)]),
                false => vec![key],
            };
            keys = keys.into_iter().flat_map(part).collect();
        }
        Some(keys)
    }

    /// A strip that lies between two conics as two cells; `None` if these are too near.
    fn between_conics(&self, strip: &Strip, key: Key) -> Option<Vec<Key>> {
        let separators = &self.parting.separators;
        let is_conic = |(k, _): &&Side| matches!(separators[*k], Separator::Quadric(_));
        let conics: Vec<Side> = key.sides.iter().filter(is_conic).copied().collect();
        let [one, other] = conics[..] else {
            return Some(vec![key]);
        };
        let ranges = self.ranges(strip);
        let (low, high) = (ranges[0]?[1], ranges[1]?[0]);
        if low >= high {
            return None;
        }
        let (lower, upper) = match self.rails[strip.ends[0]?.rail].separator == one.0 {
            true => (one, other),
            false => (other, one),
        };
        Some(self.halves(&key, strip, [(low, Some(upper)), (high, Some(lower))]))
    }

    /// A cell as two, parted by the parallel half way between a v in each, and each without one of the sides.
    fn halves(&self, key: &Key, strip: &Strip, parts: [(f64, Option<Side>); 2]) -> Vec<Key> {
        let plane = self.chart.parallel_plane(0.5 * (parts[0].0 + parts[1].0));
        let half = |(v, without): (f64, Option<Side>)| {
            let mut half = key.clone();
            half.sides.retain(|side| Some(*side) != without);
            let inside = self.chart.point(self.middle(strip.slab), v);
            half.planes.push(self.cut(plane, inside));
            half
        };
        parts.map(half).to_vec()
    }

    /// Least and greatest v at which the surface of a border crosses its strip again.
    fn comes_back(&self, strip: &Strip, crossing: &Crossing) -> Option<[f64; 2]> {
        let separator = &self.parting.separators[self.rails[crossing.rail].separator];
        let (from, to) = (self.limits[strip.slab], self.limits[strip.slab + 1]);
        let mut back = vec![];
        for share in [0.001, 0.25, 0.5, 0.75, 0.999] {
            let all = self.chart.crossings(from + share * (to - from), separator);
            let near = |v: &f64| (v - crossing.v).abs();
            let each = all.iter().copied();
            let own = each.min_by(|a, b| near(a).total_cmp(&near(b)));
            let others = all.into_iter().filter(|v| Some(*v) != own);
            back.extend(others.filter(|v| *v > strip.at[0] && *v < strip.at[1]));
        }
        (!back.is_empty()).then(|| range(back.into_iter()))
    }

    /// The planes that a part has besides those of the border: of its band, and of a cone that between its nappes.
    fn band_planes(&self, part: &Part) -> Vec<(usize, bool)> {
        if self.chart.surface.is_cone() {
            let inside = self.chart.on_axis(self.size);
            return vec![self.cut(self.chart.parallel_plane(0.0), inside)];
        }
        if !part.ends[0].is_finite() {
            return vec![];
        }
        let heights = part.ends.map(|v| self.chart.meridian(v).1);
        let inside = self.chart.on_axis(0.5 * (heights[0] + heights[1]));
        let plane = |end: usize| {
            let border = self.bands[part.band].beyond;
            let share = if part.goes_on[end] { OVERLAP } else { border };
            let height = heights[end] + share * (heights[end] - heights[1 - end]);
            self.cut(self.chart.level_plane(height), inside)
        };
        [0, 1].map(plane).to_vec()
    }
}
