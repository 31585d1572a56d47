//! The border of a face on its way over the surface, the slabs, and what a slab has between crossings with the border.

use crate::faces::arrangement::{Boundary, Parting, SMALLEST_PIECE};
use crate::faces::chart::{close_round, nearest_turn};
use crate::faces::rings::Band;
use crate::faces::vector::{Vector, between, range};
use crate::faces::{Chart, Curve, Form, PlaneOf, Planes};
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

/// A crossing of the middle of a slab.
#[derive(Clone, Copy, Debug)]
pub struct Crossing {
    pub v: f64,
    pub rail: usize,
    pub east: bool,
}

/// What is between two crossings of a slab; a side without one is open.
#[derive(Clone, Copy, Debug)]
pub struct Strip {
    pub slab: usize,
    pub ends: [Option<Crossing>; 2],
    /// v of the ends in the middle of the slab, on a tube the second above the first.
    pub at: [f64; 2],
    pub inside: bool,
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

    pub fn strips(&self) -> Result<Vec<Strip>, String> {
        let middles = (0..self.slabs()).map(|slab| self.middle(slab));
        let crossings: Vec<Vec<Crossing>> = middles.map(|u| self.crossings(u)).collect();
        let surface = &self.chart.surface;
        let has_end = surface.is_cone() || surface.is_sphere();
        if !has_end && crossings.iter().any(|all| all.len() % 2 == 1) {
            return Err("its loops are not closed on the surface".into());
        }
        let below = match surface.is_sphere() || surface.is_torus() {
            true => self.below(&crossings),
            false => vec![false; crossings.len()],
        };
        let of = |(slab, all): (usize, &Vec<Crossing>)| {
            // A cone is entered from its open end, since its apex may belong to the face.
            let odd = surface.is_cone() && all.len() % 2 == 1;
            self.between(slab, all, odd || below[slab])
        };
        Ok(crossings.iter().enumerate().flat_map(of).collect())
    }

    fn crossings(&self, u: f64) -> Vec<Crossing> {
        let mut all = vec![];
        for (index, rail) in self.rails.iter().enumerate() {
            for (v, east) in rail.crossings(u, self.chart.is_round()) {
                let turned = self.chart.surface.is_torus().then(|| v.rem_euclid(TAU));
                all.push(Crossing {
                    v: turned.unwrap_or(v),
                    rail: index,
                    east,
                });
            }
        }
        all.sort_by(|a, b| a.v.total_cmp(&b.v));
        all
    }

    /// For each slab whether the face is below its first crossing, as most of its crossings say, or the slab beside.
    fn below(&self, crossings: &[Vec<Crossing>]) -> Vec<bool> {
        let votes = |all: &[Crossing]| -> i64 {
            let vote = |(index, crossing): (usize, &Crossing)| {
                // As the direction of the border says; every other crossing is entered.
                let above = crossing.east == self.rails[crossing.rail].forward;
                if above == (index % 2 == 1) { 1 } else { -1 }
            };
            all.iter().enumerate().map(vote).sum()
        };
        let said = crossings.iter().map(|all| votes(all));
        let said: Vec<Option<bool>> = said.map(|sum| (sum != 0).then_some(sum > 0)).collect();
        if self.chart.surface.is_sphere() {
            // All lines begin at one pole.
            let yes = said.iter().flatten().filter(|yes| **yes).count();
            let all = said.iter().flatten().count();
            return vec![2 * yes > all || all == 0; crossings.len()];
        }
        let beside = |slab: usize| self.beside(slab, crossings, &said);
        let below = (0..said.len()).map(|slab| said[slab].unwrap_or_else(|| beside(slab)));
        below.collect()
    }

    /// Whether a line of a tube that no border crosses is in the face: what the next border to the west says.
    fn beside(&self, slab: usize, crossings: &[Vec<Crossing>], said: &[Option<bool>]) -> bool {
        let slabs = self.slabs();
        let narrow = self.narrow();
        for step in 0..slabs {
            let own = (slab + slabs - step) % slabs;
            if let (1.., Some(below)) = (step, said[own]) {
                // The widest strip goes on where the others end.
                let strips = self.between(own, &crossings[own], below);
                let width = |strip: &&Strip| strip.at[1] - strip.at[0];
                let widest = strips.iter().max_by(|a, b| width(a).total_cmp(&width(b)));
                return widest.is_some_and(|strip| strip.inside);
            }
            let upright = self.rails.iter().find(|rail| {
                let off = (rail.path[0][0] - self.limits[own]).rem_euclid(TAU);
                rail.is_upright(narrow) && (off <= 2.0 * narrow || off >= TAU - 2.0 * narrow)
            });
            if let Some(rail) = upright {
                let north = rail.path[rail.path.len() - 1][1] > rail.path[0][1];
                // The face is on the left of its border.
                return north != rail.forward;
            }
        }
        true
    }

    fn between(&self, slab: usize, all: &[Crossing], first: bool) -> Vec<Strip> {
        let [low, high] = match self.chart.surface.form {
            Form::Torus(..) => [0.0, TAU],
            Form::Cone(_) => [0.0, f64::INFINITY],
            _ => self.chart.reach(),
        };
        let mut borders: Vec<Option<Crossing>> = all.iter().copied().map(Some).collect();
        let is_ring = self.chart.surface.is_torus() && !all.is_empty();
        if is_ring {
            let mut again = all[0];
            again.v += TAU;
            borders.push(Some(again));
        } else {
            borders.insert(0, None);
            borders.push(None);
        }
        let strip = |(index, pair): (usize, &[Option<Crossing>])| Strip {
            slab,
            ends: [pair[0], pair[1]],
            at: [pair[0].map_or(low, |c| c.v), pair[1].map_or(high, |c| c.v)],
            // Below the first crossing of a ring is its last strip.
            inside: first == (index % 2 == usize::from(is_ring)),
        };
        borders.windows(2).enumerate().map(strip).collect()
    }

    /// Least and greatest v of both borders of a strip over its slab.
    pub fn ranges(&self, strip: &Strip) -> [Option<[f64; 2]>; 2] {
        let range = |crossing: Crossing| self.range(strip.slab, &crossing);
        strip.ends.map(|end| end.map(range))
    }

    /// The same of one border, near where it crosses the middle.
    fn range(&self, slab: usize, crossing: &Crossing) -> [f64; 2] {
        let (from, to, at) = (self.limits[slab], self.limits[slab + 1], crossing.v);
        let inner = 1e-6 * (to - from);
        let rail = &self.rails[crossing.rail];
        let steps = 16;
        let near = (0..=steps).filter_map(|k| {
            let u = from + inner + (to - from - 2.0 * inner) * f64::from(k) / f64::from(steps);
            // A closed piece has two branches, which run in opposite directions.
            let branch = rail.crossings(u, self.chart.is_round()).into_iter();
            let branch = branch.filter(|(_, east)| *east == crossing.east);
            let v = branch.map(|(v, _)| match self.chart.surface.form {
                Form::Torus(..) => nearest_turn(v, at),
                _ => v,
            });
            v.min_by(|v, w| (v - at).abs().total_cmp(&(w - at).abs()))
        });
        range([at].into_iter().chain(near))
    }

    /// From the lowest place of the border below to the highest of that above.
    pub fn extent(&self, strip: &Strip) -> [f64; 2] {
        let ranges = self.ranges(strip);
        [0, 1].map(|end| ranges[end].map_or(strip.at[end], |range| range[end]))
    }

    /// A v between both ends, in the band if that has any.
    pub fn inner(&self, [low, high]: [f64; 2], [from, to]: [f64; 2]) -> f64 {
        let (a, b) = (low.max(from), high.min(to));
        let [a, b] = if a < b { [a, b] } else { [low, high] };
        between(a, b, self.size)
    }

    /// The ends of all slabs, ascending; the first again behind the last, once round, if u is an angle.
    pub fn limits(&self, more: &[f64]) -> Vec<f64> {
        let mut limits: Vec<f64> = self.rails.iter().flat_map(Rail::limits).collect();
        limits.extend(more);
        limits.retain(|u| u.is_finite());
        if self.chart.is_round() {
            for u in &mut limits {
                *u = u.rem_euclid(TAU);
            }
        }
        limits.sort_by(f64::total_cmp);
        let narrow = self.narrow();
        limits.dedup_by(|next, kept| *next - *kept <= narrow);
        if self.chart.is_round() {
            if limits.len() > 1 && limits[0] + TAU - limits[limits.len() - 1] <= narrow {
                limits.pop();
            }
            close_round(&mut limits);
        }
        self.without_gaps(limits)
    }

    /// Limits without slabs between ends that should be one: a line there crosses the border an odd number of times.
    fn without_gaps(&self, mut limits: Vec<f64>) -> Vec<f64> {
        let is_round = self.chart.is_round();
        let widest = WIDEST_GAP * if is_round { 1.0 } else { self.size };
        let crossings = |u: f64| -> usize {
            let of = |rail: &Rail| rail.crossings(u, is_round).len();
            self.rails.iter().map(of).sum()
        };
        let mut slab = 0;
        while limits.len() > 2 && slab + 1 < limits.len() {
            let (from, to) = (limits[slab], limits[slab + 1]);
            if to - from > widest || crossings(0.5 * (from + to)) % 2 == 0 {
                slab += 1;
            } else if slab + 2 < limits.len() {
                limits.remove(slab + 1);
            } else if is_round {
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
    pub fn narrow(&self) -> f64 {
        let is_round = self.chart.is_round();
        10.0 * SMALLEST_PIECE * if is_round { 1.0 } else { self.size }
    }
}
