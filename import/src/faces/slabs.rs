//! A face taken apart by lines u = constant: whatever its border, each part lies between two of its pieces.
//!
//! The lines through all ends and turns of the border divide the surface into slabs. Within a slab the pieces of the border keep their
//! order, so that the face is the strips between every other two of them, and a strip is the AND of six half-spaces at most: those of the slab, of
//! the piece below and of that above, and of two parallels where the surface is curved along v. The search of [`super::terms`] finds fewer
//! parts where it finds any; this always ends.

use super::arrangement::SMALLEST_PIECE;
use super::chart::Separator;
use super::compile::{Cell, Parting};
use super::curve::Curve;
use super::planes::Planes;
use super::sheet::Sheet;
use super::surface::{Implicit, Surface};
use super::vector::{Vector, minus, unit};
use std::f64::consts::{PI, TAU};

/// Most times that slabs are halved.
const MAX_HALVINGS: usize = 6;
/// Greatest gap between the ends of two pieces of a border that follow each other, in sizes of the part or radians.
const WIDEST_GAP: f64 = 1e-4;
/// Steps of an arc on its way over the surface.
const ARC_STEPS: usize = 96;
/// Share of its height by which a band goes on under or over the next, so that the rounding of both leaves no pixel to neither. Out there a chord is a
/// twelfth of the deviation off.
pub const OVERLAP: f64 = 0.02;
/// Places of a line v at which two planes are asked whether they keep more than a sector.
const PROBES: u32 = 64;
/// The widest sector between two planes through an axis, radians.
const WIDEST: f64 = 2.2;

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
    /// All of a surface.
    pub fn whole(surface: &Surface) -> Vec<Band> {
        vec![Band {
            quadric: surface.implicit(),
            ends: [f64::NEG_INFINITY, f64::INFINITY],
            beyond: 0.0,
        }]
    }
}

/// A piece of the border on its way over the surface.
struct Rail {
    separator: usize,
    path: Vec<[f64; 2]>,
    forward: bool,
}

impl Rail {
    fn is_upright(&self, narrow: f64) -> bool {
        let [low, high] = self
            .path
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], [u, _]| {
                [low.min(*u), high.max(*u)]
            });
        high - low <= narrow
    }

    /// The u of its ends and of the places where it turns back.
    fn limits(&self) -> Vec<f64> {
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
    fn crossings(&self, u: f64, round: bool) -> Vec<(f64, bool)> {
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

/// What is needed to take a face apart.
pub struct Slabs<'a> {
    /// What it lies on.
    pub surface: &'a Surface,
    /// Its border.
    pub parting: &'a Parting,
    /// What it is drawn with.
    pub bands: &'a [Band],
    /// The plane of a face that is flat.
    pub flat: Option<usize>,
    /// Size of the part, scene units.
    pub size: f64,
}

/// A crossing of the middle of a slab.
#[derive(Clone, Copy, Debug)]
struct Crossing {
    v: f64,
    rail: usize,
    /// It runs eastwards.
    east: bool,
    /// The face is above, as the direction of the border says.
    above: bool,
}

/// What is between two crossings of a slab; a side without one is open.
#[derive(Clone, Copy, Debug)]
struct Strip {
    ends: [Option<Crossing>; 2],
    /// v of the ends in the middle of the slab.
    at: [f64; 2],
    inside: bool,
}

/// What a band has of a strip.
struct Part {
    band: usize,
    /// Of the band, as many turns on as the strip is.
    ends: [f64; 2],
    /// Of a place in both.
    v: f64,
    /// Whether the strip goes on beyond each end.
    goes_on: [bool; 2],
}

/// Planes and at most one quadric of a cell, by separators and sides.
#[derive(Clone, Debug, PartialEq)]
struct Key {
    band: usize,
    sides: Vec<(usize, bool)>,
    planes: Vec<(usize, bool)>,
}

/// Neighbouring slabs that have a cell in common.
struct Run {
    key: Key,
    slabs: [usize; 2],
    /// A point of it in every slab.
    samples: Vec<Vector>,
}

impl Slabs<'_> {
    /// The cells of the face.
    pub fn cells(&self, planes: &mut Planes) -> Result<Vec<Cell>, String> {
        let sheet = self.sheet().ok_or("it has no coordinates")?;
        let rails = self.rails(&sheet);
        let mut more = vec![];
        for round in 0..=MAX_HALVINGS {
            let work = Work {
                face: self,
                sheet: &sheet,
                rails: &rails,
                limits: self.limits(&sheet, &rails, &more),
                parallels: round > 0,
            };
            match work.cells(planes)? {
                Ok(cells) => return Ok(cells),
                Err(crowded) => more.extend(crowded),
            }
        }
        Err("parts of its border are too near to each other".into())
    }

    fn sheet(&self) -> Option<Sheet> {
        let north = match self.surface {
            Surface::Plane { .. } => self.parting.boundaries.iter().find_map(|b| match b.curve {
                Curve::Line { from, to } => Some(unit(minus(to, from))),
                _ => None,
            }),
            Surface::Sphere { centre, radius } => Some(super::chart::free_pole(
                *centre,
                *radius,
                &self.parting.separators,
            )),
            _ => None,
        };
        Sheet::of(self.surface, north)
    }

    fn rails(&self, sheet: &Sheet) -> Vec<Rail> {
        let rail = |boundary: &super::arrangement::Boundary| {
            let steps = match boundary.curve {
                Curve::Line { .. } => 1,
                _ => ARC_STEPS,
            };
            Rail {
                separator: boundary.separator,
                path: sheet.path(&boundary.curve.sampled(steps)),
                forward: boundary.forward,
            }
        };
        self.parting.boundaries.iter().map(rail).collect()
    }

    /// The ends of all slabs, ascending; the first again behind the last, once round, if u is an angle.
    fn limits(&self, sheet: &Sheet, rails: &[Rail], more: &[f64]) -> Vec<f64> {
        let mut limits: Vec<f64> = rails.iter().flat_map(Rail::limits).collect();
        limits.extend(more);
        limits.retain(|u| u.is_finite());
        if sheet.is_round() {
            for u in &mut limits {
                *u = u.rem_euclid(TAU);
            }
        }
        limits.sort_by(f64::total_cmp);
        let narrow = self.narrow(sheet);
        limits.dedup_by(|next, kept| *next - *kept <= narrow);
        if sheet.is_round() {
            if limits.len() > 1 && limits[0] + TAU - limits[limits.len() - 1] <= narrow {
                limits.pop();
            }
            match limits.first() {
                Some(first) => limits.push(first + TAU),
                None => limits = vec![0.0, TAU],
            }
        }
        self.without_gaps(sheet, rails, limits)
    }

    /// Limits without slabs between two ends that should be one: there a line crosses the border an odd number of times.
    fn without_gaps(&self, sheet: &Sheet, rails: &[Rail], mut limits: Vec<f64>) -> Vec<f64> {
        let widest = WIDEST_GAP * if sheet.is_round() { 1.0 } else { self.size };
        let crossings = |u: f64| -> usize {
            let each = rails
                .iter()
                .map(|rail| rail.crossings(u, sheet.is_round()).len());
            each.sum()
        };
        let mut slab = 0;
        while limits.len() > 2 && slab + 1 < limits.len() {
            let (from, to) = (limits[slab], limits[slab + 1]);
            if to - from > widest || crossings(0.5 * (from + to)) % 2 == 0 {
                slab += 1;
            } else if slab + 2 < limits.len() {
                limits.remove(slab + 1);
            } else if sheet.is_round() {
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
    fn narrow(&self, sheet: &Sheet) -> f64 {
        10.0 * SMALLEST_PIECE * if sheet.is_round() { 1.0 } else { self.size }
    }
}

/// One try with the ends of slabs.
struct Work<'a> {
    face: &'a Slabs<'a>,
    sheet: &'a Sheet,
    rails: &'a [Rail],
    limits: Vec<f64>,
    /// Strips are also bounded by parallels.
    parallels: bool,
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
                    let sample = self.sheet.point(middle, part.v);
                    match self.keys(slab, strip, &part, sample, planes) {
                        Some(keys) => {
                            for key in keys {
                                join(&mut runs, key, slab, sample);
                            }
                        }
                        None => crowded.push(middle),
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
        Ok(if crowded.is_empty() {
            Ok(cells)
        } else {
            crowded.retain(|u| u.is_finite());
            Err(crowded)
        })
    }

    fn slabs(&self) -> usize {
        self.limits.len().saturating_sub(1)
    }

    fn middle(&self, slab: usize) -> f64 {
        0.5 * (self.limits[slab] + self.limits[slab + 1])
    }

    /// The strips of every slab.
    fn strips(&self) -> Result<Vec<Vec<Strip>>, String> {
        let crossings: Vec<Vec<Crossing>> = (0..self.slabs())
            .map(|slab| self.crossings(self.middle(slab)))
            .collect();
        let oriented = self.sheet.is_ball() || self.sheet.is_tube();
        if crossings.iter().any(|all| all.len() % 2 == 1)
            && !matches!(
                self.face.surface,
                Surface::Cone { .. } | Surface::Sphere { .. }
            )
        {
            return Err("its loops are not closed on the surface".into());
        }
        let below = if oriented {
            self.below(&crossings)
        } else {
            vec![false; crossings.len()]
        };
        let of = |(all, below): (&Vec<Crossing>, bool)| {
            let first = match self.face.surface {
                // A cone is entered from its open end, since its apex may belong to the face.
                Surface::Cone { .. } => all.len() % 2 == 1,
                _ => below,
            };
            self.between(all, first)
        };
        Ok(crossings.iter().zip(below).map(of).collect())
    }

    fn crossings(&self, u: f64) -> Vec<Crossing> {
        let mut all = vec![];
        for (index, rail) in self.rails.iter().enumerate() {
            for (v, east) in rail.crossings(u, self.sheet.is_round()) {
                let v = if self.sheet.is_tube() {
                    v.rem_euclid(TAU)
                } else {
                    v
                };
                all.push(Crossing {
                    v,
                    rail: index,
                    east,
                    above: east == rail.forward,
                });
            }
        }
        all.sort_by(|a, b| a.v.total_cmp(&b.v));
        all
    }

    /// For each slab whether what is below its first crossing is of the face: what most of its crossings say, or what the slab beside it says.
    fn below(&self, crossings: &[Vec<Crossing>]) -> Vec<bool> {
        let votes = |all: &[Crossing]| -> i64 {
            let vote = |(index, crossing): (usize, &Crossing)| {
                // Every other crossing is entered.
                let says = crossing.above == (index % 2 == 1);
                if says { 1 } else { -1 }
            };
            all.iter().enumerate().map(vote).sum()
        };
        let said: Vec<Option<bool>> = crossings
            .iter()
            .map(|all| match votes(all) {
                0 => None,
                sum => Some(sum > 0),
            })
            .collect();
        if self.sheet.is_ball() {
            // All lines begin at one pole.
            let sum: i64 = said
                .iter()
                .flatten()
                .map(|yes| if *yes { 1 } else { -1 })
                .sum();
            let any = said.iter().any(Option::is_some);
            return vec![sum > 0 || !any; crossings.len()];
        }
        (0..crossings.len())
            .map(|slab| said[slab].unwrap_or_else(|| self.beside(slab, crossings, &said)))
            .collect()
    }

    /// Whether a line of a tube that no border crosses is in the face: what the next border to the west says.
    fn beside(&self, slab: usize, crossings: &[Vec<Crossing>], said: &[Option<bool>]) -> bool {
        let slabs = self.slabs();
        let narrow = self.face.narrow(self.sheet);
        for step in 0..slabs {
            let own = (slab + slabs - step) % slabs;
            if step > 0
                && let Some(below) = said[own]
            {
                // The widest strip goes on where the others end.
                let strips = self.between(&crossings[own], below);
                let width = |strip: &&Strip| strip.at[1] - strip.at[0];
                let widest = strips.iter().max_by(|a, b| width(a).total_cmp(&width(b)));
                return widest.is_some_and(|strip| strip.inside);
            }
            let at = self.limits[own];
            let upright = self.rails.iter().find(|rail| {
                let off = (rail.path[0][0] - at).rem_euclid(TAU);
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

    fn between(&self, all: &[Crossing], first: bool) -> Vec<Strip> {
        let [low, high] = self.sheet.reach();
        if self.sheet.is_tube() {
            let count = all.len();
            if count == 0 {
                return vec![Strip {
                    ends: [None; 2],
                    at: [0.0, TAU],
                    inside: first,
                }];
            }
            let strip = |index: usize| {
                let (from, to) = (all[index], all[(index + 1) % count]);
                let top = if index + 1 == count { to.v + TAU } else { to.v };
                Strip {
                    ends: [Some(from), Some(to)],
                    at: [from.v, top],
                    inside: first == (index % 2 == 1),
                }
            };
            return (0..count).map(strip).collect();
        }
        let mut strips = vec![];
        let (mut from, mut at, mut inside) = (None, low, first);
        for crossing in all {
            strips.push(Strip {
                ends: [from, Some(*crossing)],
                at: [at, crossing.v],
                inside,
            });
            (from, at, inside) = (Some(*crossing), crossing.v, !inside);
        }
        strips.push(Strip {
            ends: [from, None],
            at: [at, high],
            inside,
        });
        strips
    }

    /// Least and greatest v of a border over a slab, near where it crosses the middle.
    fn range(&self, slab: usize, crossing: &Crossing, at: f64) -> [f64; 2] {
        let (from, to) = (self.limits[slab], self.limits[slab + 1]);
        let inner = 1e-6 * (to - from);
        let rail = &self.rails[crossing.rail];
        let mut range = [at, at];
        let steps = 16;
        for k in 0..=steps {
            let u = from + inner + (to - from - 2.0 * inner) * f64::from(k) / f64::from(steps);
            // A closed piece has two branches, which run in opposite directions.
            let branch = rail.crossings(u, self.sheet.is_round()).into_iter();
            let v = branch
                .filter(|(_, east)| *east == crossing.east)
                .map(|(v, _)| {
                    if self.sheet.is_tube() {
                        nearest_turn(v, at)
                    } else {
                        v
                    }
                })
                .min_by(|v, w| (v - at).abs().total_cmp(&(w - at).abs()));
            if let Some(v) = v {
                range = [range[0].min(v), range[1].max(v)];
            }
        }
        range
    }

    /// The bands that a strip has a part of, with their ends at its turn, and a v of it in each.
    fn bands_of(&self, slab: usize, strip: &Strip) -> Vec<Part> {
        let [low, high] = self.extent(slab, strip);
        let turns: &[f64] = if self.sheet.is_tube() {
            &[-TAU, 0.0, TAU, 2.0 * TAU]
        } else {
            &[0.0]
        };
        let mut found = vec![];
        for (band, own) in self.face.bands.iter().enumerate() {
            for turn in turns {
                let ends = own.ends.map(|v| v + turn);
                let least = 1e-9
                    * if ends[0].is_finite() {
                        ends[1] - ends[0]
                    } else {
                        1.0
                    };
                if ends[1].min(high) - ends[0].max(low) > least {
                    let v = self.inner(strip.at, ends);
                    let goes_on = [low < ends[0] - least, high > ends[1] + least];
                    found.push(Part {
                        band,
                        ends,
                        v,
                        goes_on,
                    });
                }
            }
        }
        found
    }

    /// From the lowest place of the border below to the highest of that above.
    fn extent(&self, slab: usize, strip: &Strip) -> [f64; 2] {
        let low = strip.ends[0].map_or(strip.at[0], |c| self.range(slab, &c, strip.at[0])[0]);
        let high = strip.ends[1].map_or(strip.at[1], |c| self.range(slab, &c, strip.at[1])[1]);
        [low, high]
    }

    /// A v between both ends, in the band if that has any.
    fn inner(&self, [low, high]: [f64; 2], [from, to]: [f64; 2]) -> f64 {
        let (a, b) = (low.max(from), high.min(to));
        let [a, b] = if a < b { [a, b] } else { [low, high] };
        match (a.is_finite(), b.is_finite()) {
            (true, true) => 0.5 * (a + b),
            (true, false) => a + self.face.size,
            (false, true) => b - self.face.size,
            (false, false) => 0.0,
        }
    }

    /// What bounds a strip in a band, besides the slab: one cell, or two if it lies between two conics; nothing if these are too near.
    fn keys(
        &self,
        slab: usize,
        strip: &Strip,
        part: &Part,
        sample: Vector,
        planes: &mut Planes,
    ) -> Option<Vec<Key>> {
        let separators = &self.face.parting.separators;
        let side = |crossing: &Crossing| {
            let separator = self.rails[crossing.rail].separator;
            (separator, separators[separator].is_positive(sample))
        };
        let ranges = [0, 1]
            .map(|end| strip.ends[end].map(|crossing| self.range(slab, &crossing, strip.at[end])));
        let mut key = Key {
            band: part.band,
            sides: vec![],
            planes: self.band_planes(part, planes),
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
                let plane = self.sheet.parallel_plane(range[end], planes);
                key.planes.push((plane, planes.is_positive(plane, sample)));
            }
        }
        let mut keys = self.between_conics(slab, strip, key, ranges, planes)?;
        for (end, crossing) in strip.ends.iter().enumerate() {
            let (Some(crossing), Some(range)) = (crossing, ranges[end]) else {
                continue;
            };
            let same = strip.ends[1 - end].is_some_and(|other| side(&other) == side(crossing));
            let back = self.comes_back(slab, strip, crossing, end);
            let Some(back) = back.filter(|_| !same) else {
                continue;
            };
            // The part of the strip that it crosses again is parted off, and needs it no more.
            let (low, high) = if end == 0 {
                (range[1], back[0])
            } else {
                (back[1], range[0])
            };
            if low >= high {
                return None;
            }
            let own = side(crossing);
            let part = |key: Key| -> Vec<Key> {
                if key.sides.contains(&own) {
                    let (beyond, near) = if end == 0 { (high, low) } else { (low, high) };
                    let at = 0.5 * (low + high);
                    vec![
                        self.half(&key, slab, at, beyond, Some(own), planes),
                        self.half(&key, slab, at, near, None, planes),
                    ]
                } else {
                    vec![key]
                }
            };
            keys = keys.into_iter().flat_map(part).collect();
        }
        Some(keys)
    }

    /// A strip that lies between two conics as two cells; nothing if these are too near.
    fn between_conics(
        &self,
        slab: usize,
        strip: &Strip,
        key: Key,
        ranges: [Option<[f64; 2]>; 2],
        planes: &mut Planes,
    ) -> Option<Vec<Key>> {
        let separators = &self.face.parting.separators;
        let is_conic = |(k, _): &&(usize, bool)| matches!(separators[*k], Separator::Quadric(_));
        let conics: Vec<(usize, bool)> = key.sides.iter().filter(is_conic).copied().collect();
        let [one, other] = conics[..] else {
            return Some(vec![key]);
        };
        let (low, high) = (ranges[0]?[1], ranges[1]?[0]);
        if low >= high {
            return None;
        }
        let below = self.rails[strip.ends[0]?.rail].separator;
        let (lower, upper) = if below == one.0 {
            (one, other)
        } else {
            (other, one)
        };
        let at = 0.5 * (low + high);
        Some(vec![
            self.half(&key, slab, at, low, Some(upper), planes),
            self.half(&key, slab, at, high, Some(lower), planes),
        ])
    }

    /// The part of a cell on the side of the parallel `at` on which `v` is, without one of its sides.
    fn half(
        &self,
        key: &Key,
        slab: usize,
        at: f64,
        v: f64,
        without: Option<(usize, bool)>,
        planes: &mut Planes,
    ) -> Key {
        let mut half = key.clone();
        half.sides.retain(|side| Some(*side) != without);
        let plane = self.sheet.parallel_plane(at, planes);
        let inside = self.sheet.point(self.middle(slab), v);
        half.planes.push((plane, planes.is_positive(plane, inside)));
        half
    }

    /// Least and greatest v at which the surface of a border crosses its strip again.
    fn comes_back(
        &self,
        slab: usize,
        strip: &Strip,
        crossing: &Crossing,
        end: usize,
    ) -> Option<[f64; 2]> {
        let separator = &self.face.parting.separators[self.rails[crossing.rail].separator];
        let (from, to) = (self.limits[slab], self.limits[slab + 1]);
        let mut back: Option<[f64; 2]> = None;
        for share in [0.001, 0.25, 0.5, 0.75, 0.999] {
            let u = from + share * (to - from);
            let all = self.sheet.crossings(u, separator);
            let near = |v: &&f64| (**v - strip.at[end]).abs();
            let own = all
                .iter()
                .min_by(|a, b| near(a).total_cmp(&near(b)))
                .copied();
            for v in all.iter().filter(|v| Some(**v) != own) {
                if *v > strip.at[0] && *v < strip.at[1] {
                    let [low, high] = back.unwrap_or([*v, *v]);
                    back = Some([low.min(*v), high.max(*v)]);
                }
            }
        }
        back
    }

    /// The planes that a part has besides those of the border: of its band, and of a cone that between its nappes.
    fn band_planes(&self, part: &Part, planes: &mut Planes) -> Vec<(usize, bool)> {
        if let Surface::Cone { .. } = self.face.surface {
            let plane = self.sheet.parallel_plane(0.0, planes);
            let inside = self.sheet.on_axis(self.face.size);
            return vec![(plane, planes.is_positive(plane, inside))];
        }
        if !part.ends[0].is_finite() {
            return vec![];
        }
        let heights = part.ends.map(|v| self.sheet.meridian(v).1);
        let inside = self.sheet.on_axis(0.5 * (heights[0] + heights[1]));
        let plane = |end: usize| {
            let share = if part.goes_on[end] {
                OVERLAP
            } else {
                self.face.bands[part.band].beyond
            };
            let height = heights[end] + share * (heights[end] - heights[1 - end]);
            let plane = self.sheet.level_plane(height, planes);
            (plane, planes.is_positive(plane, inside))
        };
        [0, 1].map(plane).to_vec()
    }

    /// On a round sheet the last slab and the first are neighbours.
    fn close(&self, runs: &mut Vec<Run>) {
        let last = self.slabs().saturating_sub(1);
        if !self.sheet.is_round() || last == 0 {
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

    fn limit(&self, index: usize) -> f64 {
        let slabs = self.slabs();
        let turns = index / slabs;
        self.limits[index % slabs] + turns as f64 * TAU
    }

    /// The spans of u of a run, none wider than two planes through an axis can bound, each with a sample.
    fn sectors(&self, run: &Run) -> Vec<([f64; 2], Vector)> {
        let whole = [f64::NEG_INFINITY, f64::INFINITY];
        let (from, to) = (self.limit(run.slabs[0]), self.limit(run.slabs[1] + 1));
        if !self.sheet.is_round() {
            let to = self.limits[run.slabs[1] + 1];
            return vec![([self.limits[run.slabs[0]], to], run.samples[0])];
        }
        if run.slabs[1] + 1 - run.slabs[0] == self.slabs() {
            return vec![(whole, run.samples[0])];
        }
        let parts = ((to - from) / WIDEST).ceil().max(1.0);
        let step = (to - from) / parts;
        (0..parts as usize)
            .map(|k| {
                let span = [from + step * k as f64, from + step * (k + 1) as f64];
                let middle = 0.5 * (span[0] + span[1]);
                let v = self.sheet.coordinates(run.samples[0])[1];
                (span, self.sheet.point(middle, v))
            })
            .collect()
    }

    fn cell(&self, run: &Run, span: [f64; 2], sample: Vector, planes: &mut Planes) -> Cell {
        let parting = self.face.parting;
        let mut cell = Cell {
            quadric: self.face.bands[run.key.band].quadric,
            flat: self.face.flat,
            cuts: run.key.planes.clone(),
        };
        for (separator, positive) in &run.key.sides {
            match (parting.planes[*separator], parting.separators[*separator]) {
                (Some(plane), _) => cell.cuts.push((plane, *positive)),
                (None, Separator::Quadric(implicit)) => {
                    cell.quadric = Some(if *positive {
                        implicit.negated()
                    } else {
                        implicit
                    });
                }
                _ => {}
            }
        }
        if span[0].is_finite() {
            cell.cuts.extend(self.sides(span, sample, planes));
        }
        cell.cuts.sort_unstable();
        cell.cuts.dedup();
        cell
    }

    /// The planes at both ends of a span: those of edges that are there, if together they keep nothing else of the line v.
    fn sides(&self, span: [f64; 2], sample: Vector, planes: &mut Planes) -> [(usize, bool); 2] {
        let v = self.sheet.coordinates(sample)[1];
        let width = span[1] - span[0];
        let edges = span.map(|u| self.edge_at(u, span, v, planes));
        let meridians = [0, 1].map(|end| {
            let plane = self.sheet.meridian_plane(span[end], planes);
            // The normal of a plane that was there before may point the other way.
            let inwards = if end == 0 { 1e-3 } else { -1e-3 } * width;
            let beside = self.sheet.point(span[end] + inwards, v);
            (plane, planes.is_positive(plane, beside))
        });
        let own = [0, 1].map(|end| edges[end].unwrap_or(meridians[end]));
        let elsewhere = |k: u32| {
            let u = span[1] + (TAU - width) * (f64::from(k) + 0.5) / f64::from(PROBES);
            let p = self.sheet.point(u, v);
            own.iter()
                .all(|(plane, positive)| planes.is_positive(*plane, p) == *positive)
        };
        if !self.sheet.is_round() || edges == [None; 2] || !(0..PROBES).any(elsewhere) {
            own
        } else {
            meridians
        }
    }

    /// The plane of an upright edge at an end of a span, if it has all of the span on one side.
    fn edge_at(&self, u: f64, span: [f64; 2], v: f64, planes: &Planes) -> Option<(usize, bool)> {
        let narrow = 2.0 * self.face.narrow(self.sheet);
        let upright = self.rails.iter().filter(|rail| rail.is_upright(narrow));
        for rail in upright {
            let mut off = rail.path[0][0] - u;
            if self.sheet.is_round() {
                off = (off + PI).rem_euclid(TAU) - PI;
            }
            let plane = self.face.parting.planes[rail.separator];
            let Some(plane) = plane.filter(|_| off.abs() <= narrow) else {
                continue;
            };
            let shares = [0.02, 0.5, 0.98].map(|share| span[0] + share * (span[1] - span[0]));
            let sides = shares.map(|u| planes.is_positive(plane, self.sheet.point(u, v)));
            if sides == [sides[0]; 3] {
                return Some((plane, sides[0]));
            }
        }
        None
    }

    /// Slabs with places of the face that no cell has.
    fn lost(&self, cells: &[Cell], strips: &[Vec<Strip>], planes: &Planes) -> Crowded {
        if !self.sheet.is_ball() && self.face.flat.is_none() {
            return vec![];
        }
        let mut lost = vec![];
        for (slab, strips) in strips.iter().enumerate() {
            let middle = self.middle(slab);
            for strip in strips.iter().filter(|strip| strip.inside) {
                let mut places = self.probes(strip.at).into_iter();
                let taken = |v: f64| {
                    let p = self.sheet.point(middle, v);
                    cells.iter().any(|cell| cell.takes(p, planes))
                };
                if !places.all(taken) {
                    lost.push(middle);
                }
            }
        }
        lost
    }

    /// Whether a cell has places of strips that are not of the face.
    fn takes_others(&self, cell: &Cell, strips: &[Vec<Strip>], planes: &Planes) -> bool {
        let exact = !self.sheet.is_ball() && self.face.flat.is_none();
        if exact {
            return false;
        }
        strips.iter().enumerate().any(|(slab, strips)| {
            let middle = self.middle(slab);
            strips.iter().filter(|strip| !strip.inside).any(|strip| {
                let mut places = self.probes(strip.at).into_iter();
                places.any(|v| cell.takes(self.sheet.point(middle, v), planes))
            })
        })
    }

    /// Places between two v, far out where one is open: a conic may come back there.
    fn probes(&self, [low, high]: [f64; 2]) -> Vec<f64> {
        if high - low <= WIDEST_GAP * self.face.size {
            return vec![];
        }
        let far = [0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0].map(|share| share * self.face.size);
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

/// An angle as many turns on as makes it nearest to another.
fn nearest_turn(v: f64, at: f64) -> f64 {
    at + (v - at + PI).rem_euclid(TAU) - PI
}

/// Adds a cell of a slab to the run that it continues.
fn join(runs: &mut Vec<Run>, key: Key, slab: usize, sample: Vector) {
    let before = runs
        .iter_mut()
        .rev()
        .find(|run| run.slabs[1] + 1 == slab && run.key == key);
    match before {
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
