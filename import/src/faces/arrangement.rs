//! The pieces into which separators divide a surface: a point of each, its sides, and whether the face has it.
//!
//! The lines u = constant through all places where separators meet, turn or end divide the surface into slabs; within a
//! slab the separators keep their order, so that each piece of a slab is one strip between two of them. Every connected
//! region of the surface is open and thus has a strip in some slab: no region is without a sample, whatever its shape.

use super::chart::{close_round, nearest_turn};
use super::cover::{Sample, Term};
use super::vector::{Vector, between, dot, positive_angle};
use super::{Chart, Curve, Form, Implicit, PlaneOf, Planes, Separator, Surface};
use std::collections::HashMap;

/// Most separators of one face: a sample has one bit for each.
pub const MAX_SEPARATORS: usize = 128;

/// Share of the size of a part below which a piece is no piece but rounding.
pub const SMALLEST_PIECE: f64 = 1e-7;

/// An edge of a face, which lies on one of the separators.
#[derive(Clone, Debug)]
pub struct Boundary {
    pub separator: usize,
    pub curve: Curve,
    /// Whether the loop passes it from start to end.
    pub forward: bool,
}

/// Loops of a sphere contradict each other in what is on their left.
const CONTRADICTION: &str =
    "its loops contradict each other: the face has to be on the left of every edge";

/// A conic as a quadric that meets the plane in it.
#[derive(Clone, Debug)]
pub struct Conic {
    pub implicit: Implicit,
    pub centre: Vector,
    /// Least and greatest distance of the conic from it.
    pub radii: [f64; 2],
}

#[derive(Clone, Debug, Default)]
pub struct Parting {
    pub separators: Vec<Separator>,
    /// For each: the plane, or nothing for a quadric.
    pub planes: Vec<Option<usize>>,
    /// For each: separators of the lower rank are dropped first.
    pub ranks: Vec<u8>,
    pub boundaries: Vec<Boundary>,
    /// The conics of quadrics on a plane, by their separators.
    pub shapes: HashMap<usize, Conic>,
}

/// Rank of a quadric that bounds a plane, of which a cell can have one alone.
const CONIC: u8 = 0;
/// Rank of a plane that is no edge.
pub const AUXILIARY: u8 = 1;
/// Rank of a plane that has an edge.
pub const EDGE: u8 = 2;

impl Parting {
    /// Adds a separator; its index.
    pub fn push(&mut self, separator: Separator, plane: Option<usize>, rank: u8) -> usize {
        self.separators.push(separator);
        self.planes.push(plane);
        self.ranks.push(rank);
        self.separators.len() - 1
    }

    /// Index of the separator of a plane.
    pub fn plane(&mut self, planes: &Planes, plane: usize, rank: u8) -> usize {
        let Some(index) = self.planes.iter().position(|p| *p == Some(plane)) else {
            return self.push(planes.separator(plane), Some(plane), rank);
        };
        self.ranks[index] = self.ranks[index].max(rank);
        index
    }

    pub fn quadric(&mut self, implicit: Implicit) -> usize {
        let separator = Separator::Quadric(implicit);
        let known = self.separators.iter().position(|s| *s == separator);
        known.unwrap_or_else(|| self.push(separator, None, CONIC))
    }

    pub fn border(&mut self, separator: usize, curve: Curve, forward: bool) {
        self.boundaries.push(Boundary {
            separator,
            curve,
            forward,
        });
    }

    /// Adds planes that divide and are no edges; false if all are there already, or too many.
    pub fn split(&mut self, planes: &Planes, new: &[PlaneOf]) -> bool {
        let before = self.separators.len();
        for (point, normal) in new {
            self.plane(planes, planes.find_or_add(*point, *normal), AUXILIARY);
        }
        self.separators.len() > before && self.separators.len() <= MAX_SEPARATORS
    }

    /// One sample of every piece of a surface, of a part of a size.
    pub fn samples(&self, surface: &Surface, size: f64) -> Result<Vec<Sample>, &'static str> {
        let chart = Chart::free(surface, &self.separators);
        let boundaries = self.boundaries.iter();
        let division = Division {
            parting: self,
            spans: boundaries.map(|own| span(&chart, &own.curve)).collect(),
            chart,
            size,
        };
        let line = |u| (u, division.crossings(u));
        let lines: Vec<_> = division.middles().into_iter().map(line).collect();
        let pole = division.pole(&lines)?;
        let strips = lines.iter().map(|(u, all)| division.strips(*u, all, pole));
        Ok(strips.collect::<Result<Vec<_>, _>>()?.concat())
    }

    pub fn cuts(&self, term: &Term) -> Vec<(usize, bool)> {
        let cut = |(k, positive): (usize, bool)| self.planes[k].map(|plane| (plane, positive));
        term.literals().filter_map(cut).collect()
    }

    pub fn conics(&self, term: &Term) -> Vec<(usize, bool)> {
        let own = term.literals().filter(|(k, _)| self.planes[*k].is_none());
        own.collect()
    }

    /// One object has one conic, and so many sides at most.
    pub fn fits(&self, term: &Term, most: usize) -> bool {
        let own = self.conics(term).len();
        own <= 1 && term.count() as usize - own <= most
    }
}

/// The angles over which a curve given by points runs on a cylinder or cone: the first, and how far from there, less
/// than 0 backwards. Other curves know their extent.
fn span(chart: &Chart, curve: &Curve) -> Option<[f64; 2]> {
    let is_upright = matches!(chart.surface.form, Form::Cylinder(_) | Form::Cone(_));
    if !is_upright || !matches!(curve, Curve::Points(_)) {
        return None;
    }
    let points = curve.sampled(1).into_iter();
    let angles: Vec<f64> = points.map(|p| chart.u_of(p)).collect();
    let turn = |pair: &[f64]| nearest_turn(pair[1] - pair[0], 0.0);
    Some([angles[0], angles.windows(2).map(turn).sum()])
}

struct Division<'a> {
    parting: &'a Parting,
    chart: Chart,
    spans: Vec<Option<[f64; 2]>>,
    /// Size of the part, scene units.
    size: f64,
}

#[derive(Default)]
struct Crossing {
    w: f64,
    /// Number of edges here, and whether the face is above by the direction of the first.
    edges: usize,
    inside_above: bool,
}

impl Division<'_> {
    fn middles(&self) -> Vec<f64> {
        let chart = &self.chart;
        let (separators, boundaries) = (&self.parting.separators, &self.parting.boundaries);
        let ends = boundaries.iter().flat_map(|own| own.curve.ends());
        let mut limits: Vec<f64> = ends.map(|end| chart.u_of(end)).collect();
        for (index, separator) in separators.iter().enumerate() {
            limits.extend(chart.turns(separator));
            for other in &separators[index + 1..] {
                limits.extend(chart.meetings(separator, other));
            }
        }
        limits.retain(|u| u.is_finite());
        limits.sort_by(f64::total_cmp);
        if chart.is_round() {
            close_round(&mut limits);
        } else {
            let [first, last] = [limits.first(), limits.last()].map(|end| *end.unwrap_or(&0.0));
            limits.insert(0, first - self.size);
            limits.push(last + self.size);
        }
        let smallest = SMALLEST_PIECE * if chart.is_round() { 1.0 } else { self.size };
        let wide = |pair: &&[f64]| pair[1] - pair[0] > smallest;
        let middle = |pair: &[f64]| 0.5 * (pair[0] + pair[1]);
        limits.windows(2).filter(wide).map(middle).collect()
    }

    fn crossings(&self, u: f64) -> Vec<Crossing> {
        let (chart, mut all) = (&self.chart, vec![]);
        for (index, separator) in self.parting.separators.iter().enumerate() {
            let finite = chart.crossings(u, separator).into_iter();
            for w in finite.filter(|w| w.is_finite()) {
                let mut crossing = Crossing {
                    w,
                    ..Crossing::default()
                };
                let p = chart.point(u, w);
                // The other nappe of a cone has no edge.
                let is_there = !chart.surface.is_cone() || w > 0.0;
                let edges = self.parting.boundaries.iter().zip(&self.spans);
                for (own, span) in edges.filter(|(own, _)| is_there && own.separator == index) {
                    if let Some([from, sweep]) = span {
                        let way = positive_angle((u - from) * sweep.signum());
                        crossing.edges += usize::from(way < sweep.abs());
                    } else if let Some(course) = own.curve.direction_at(p, 1e-6 * self.size) {
                        let east = dot(course, chart.eastwards(p)) > 0.0;
                        crossing.edges += 1;
                        crossing.inside_above = east == own.forward;
                    }
                }
                all.push(crossing);
            }
        }
        all.sort_by(|a, b| a.w.total_cmp(&b.w));
        all
    }

    /// Whether the south pole of a sphere is in the face: what all lines that meet an edge say.
    fn pole(&self, lines: &[(f64, Vec<Crossing>)]) -> Result<bool, &'static str> {
        if !self.chart.surface.is_sphere() {
            return Ok(false);
        }
        let all = lines.iter().map(|(_, all)| all.iter());
        let first = all.filter_map(|mut all| all.find(|crossing| crossing.edges % 2 == 1));
        let mut below = first.map(|crossing| !crossing.inside_above);
        let pole = below.next().unwrap_or(true);
        let agree = below.all(|other| other == pole);
        agree.then_some(pole).ok_or(CONTRADICTION)
    }

    fn strips(&self, u: f64, all: &[Crossing], pole: bool) -> Result<Vec<Sample>, &'static str> {
        let surface = &self.chart.surface;
        let (cone, sphere) = (surface.is_cone(), surface.is_sphere());
        let is_odd = all.iter().map(|c| c.edges).sum::<usize>() % 2 == 1;
        if is_odd && !(cone || sphere) {
            return Err("its loops are not closed on the surface");
        }
        // A cone is entered from its open end, since its apex may belong to the face; all others from below.
        let mut inside = if cone { is_odd } else { pole };
        let [mut from, high] = self.chart.reach();
        let mut samples = vec![];
        for crossing in all {
            samples.extend(self.strip(u, [from, crossing.w], inside));
            if crossing.edges % 2 == 1 {
                inside = !inside;
                if sphere && inside != crossing.inside_above {
                    return Err(CONTRADICTION);
                }
            }
            from = crossing.w;
        }
        samples.extend(self.strip(u, [from, high], inside));
        Ok(samples)
    }

    fn strip(&self, u: f64, [from, to]: [f64; 2], inside: bool) -> Option<Sample> {
        let surface = &self.chart.surface;
        let unit = if surface.is_sphere() { 1.0 } else { self.size };
        if to - from <= SMALLEST_PIECE * unit {
            return None;
        }
        let w = between(from, to, unit);
        let nappe = !surface.is_cone() || w > 0.0;
        let point = self.chart.point(u, w);
        let separators = self.parting.separators.iter().rev();
        Some(Sample {
            sides: separators.fold(0, |all, own| all << 1 | u128::from(own.is_positive(point))),
            inside: inside && nappe,
            point,
        })
    }
}
