//! The pieces into which separators divide a surface: one point of each, its side of every separator, and whether the
//! face has it.
//!
//! The lines u = constant through all places where separators meet, turn or end divide the surface into slabs; within a
//! slab the separators keep their order, so that each piece of a slab is one strip between two of them. Every connected
//! region of the surface is open and thus has a strip in some slab: no region is without a sample, whatever its shape.

use super::cell::Separator;
use super::chart::{Chart, nearest_turn};
use super::curve::Curve;
use super::surface::{Form, Surface};
use super::vector::{Vector, between, dot, positive_angle};
use std::f64::consts::TAU;

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

/// A point of a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Bit k: it is on the positive side of separator k.
    pub sides: u128,
    /// It belongs to the face.
    pub inside: bool,
    /// The point.
    pub point: Vector,
}

/// Loops of a sphere contradict each other in what is on their left.
const CONTRADICTION: &str =
    "its loops contradict each other: the face has to be on the left of every edge";

/// The angles over which a curve runs on a cylinder or cone, where a plane has one point at every angle: the first, and
/// how far from there, less than 0 if it runs backwards.
type Span = [f64; 2];

/// The span of a curve that is given by points; others know their extent themselves.
fn span(chart: &Chart, curve: &Curve) -> Option<Span> {
    let Curve::Points(_) = curve else {
        return None;
    };
    let is_upright = matches!(chart.surface.form, Form::Cylinder(_) | Form::Cone(_));
    let points = curve.sampled(1).into_iter();
    let angles: Vec<f64> = points.map(|p| chart.u_of(p)).collect();
    let turn = |pair: &[f64]| nearest_turn(pair[1] - pair[0], 0.0);
    is_upright.then(|| [angles[0], angles.windows(2).map(turn).sum()])
}

pub struct Division<'a> {
    pub surface: &'a Surface,
    pub separators: &'a [Separator],
    pub boundaries: &'a [Boundary],
    /// Size of the part, scene units.
    pub size: f64,
}

/// A crossing of the line u.
#[derive(Default)]
struct Crossing {
    w: f64,
    /// Number of edges here, and whether the face is above by the direction of the first.
    edges: usize,
    inside_above: bool,
}

impl Division<'_> {
    /// One sample of every piece.
    pub fn samples(&self) -> Result<Vec<Sample>, &'static str> {
        let chart = Chart::free(self.surface, self.separators);
        let curves = self.boundaries.iter().map(|own| &own.curve);
        let spans: Vec<Option<Span>> = curves.map(|curve| span(&chart, curve)).collect();
        let line = |u| (u, self.crossings(&chart, u, &spans));
        let lines: Vec<_> = self.middles(&chart).into_iter().map(line).collect();
        let pole = self.pole(&lines)?;
        let mut samples = vec![];
        for (u, crossings) in &lines {
            self.strips(&chart, *u, crossings, pole, &mut samples)?;
        }
        Ok(samples)
    }

    fn middles(&self, chart: &Chart) -> Vec<f64> {
        let ends = self.boundaries.iter().flat_map(|own| own.curve.ends());
        let mut limits: Vec<f64> = ends.map(|end| chart.u_of(end)).collect();
        for (index, separator) in self.separators.iter().enumerate() {
            limits.extend(chart.turns(separator));
            for other in &self.separators[index + 1..] {
                limits.extend(chart.meetings(separator, other));
            }
        }
        limits.retain(|u| u.is_finite());
        limits.sort_by(f64::total_cmp);
        if chart.is_round() {
            match limits.first() {
                Some(first) => limits.push(first + TAU),
                None => limits = vec![0.0, TAU],
            }
        } else {
            let [first, last] = [limits.first(), limits.last()].map(|end| *end.unwrap_or(&0.0));
            limits.insert(0, first - self.size);
            limits.push(last + self.size);
        }
        let smallest = SMALLEST_PIECE * if chart.is_round() { 1.0 } else { self.size };
        let pairs = limits.windows(2).map(|pair| (pair[0], pair[1]));
        let wide = pairs.filter(|(from, to)| to - from > smallest);
        wide.map(|(from, to)| 0.5 * (from + to)).collect()
    }

    fn crossings(&self, chart: &Chart, u: f64, spans: &[Option<Span>]) -> Vec<Crossing> {
        let mut all = vec![];
        for (index, separator) in self.separators.iter().enumerate() {
            for w in chart.crossings(u, separator) {
                if !w.is_finite() {
                    continue;
                }
                let mut crossing = Crossing {
                    w,
                    ..Crossing::default()
                };
                let p = chart.point(u, w);
                // The other nappe of a cone has no edge.
                let is_there = !self.surface.is_cone() || w > 0.0;
                let edges = self.boundaries.iter().zip(spans);
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
        if !self.surface.is_sphere() {
            return Ok(false);
        }
        let all = lines.iter().map(|(_, all)| all.iter());
        let first = all.filter_map(|mut all| all.find(|crossing| crossing.edges % 2 == 1));
        let mut below = first.map(|crossing| !crossing.inside_above);
        let pole = below.next().unwrap_or(true);
        let agree = below.all(|other| other == pole);
        agree.then_some(pole).ok_or(CONTRADICTION)
    }

    fn strips(
        &self,
        chart: &Chart,
        u: f64,
        crossings: &[Crossing],
        pole: bool,
        samples: &mut Vec<Sample>,
    ) -> Result<(), &'static str> {
        let (cone, sphere) = (self.surface.is_cone(), self.surface.is_sphere());
        let total: usize = crossings.iter().map(|c| c.edges).sum();
        // A cone is entered from its open end, since its apex may belong to the face; all others from below.
        let mut inside = if cone { total % 2 == 1 } else { pole };
        if !(cone || sphere) && total % 2 == 1 {
            return Err("its loops are not closed on the surface");
        }
        let [low, high] = chart.reach();
        let mut from = low;
        for crossing in crossings {
            samples.extend(self.strip(chart, u, [from, crossing.w], inside));
            if crossing.edges % 2 == 1 {
                inside = !inside;
                if sphere && inside != crossing.inside_above {
                    return Err(CONTRADICTION);
                }
            }
            from = crossing.w;
        }
        samples.extend(self.strip(chart, u, [from, high], inside));
        Ok(())
    }

    fn strip(&self, chart: &Chart, u: f64, [from, to]: [f64; 2], inside: bool) -> Option<Sample> {
        let is_sphere = chart.surface.is_sphere();
        let unit = if is_sphere { 1.0 } else { self.size };
        if to - from <= SMALLEST_PIECE * unit {
            return None;
        }
        let w = between(from, to, unit);
        let nappe = !self.surface.is_cone() || w > 0.0;
        let point = chart.point(u, w);
        let mut sides = 0;
        for (index, separator) in self.separators.iter().enumerate() {
            sides |= u128::from(separator.is_positive(point)) << index;
        }
        Some(Sample {
            sides,
            inside: inside && nappe,
            point,
        })
    }
}
