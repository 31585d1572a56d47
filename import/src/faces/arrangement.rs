//! The pieces into which separators divide a surface: one point of each, its side of every separator, and whether the face has it.
//!
//! The lines u = constant through all places where separators meet, turn or end divide the surface into slabs; within a slab the
//! separators keep their order, so that each piece of a slab is one strip between two of them. Every connected region of the surface is open and
//! thus has a strip in some slab: no region is without a sample, whatever its shape.

use super::chart::{Chart, Separator};
use super::curve::Curve;
use super::surface::Surface;
use super::vector::{Vector, dot, positive_angle};
use std::f64::consts::{PI, TAU};

/// Most separators of one face: a sample has one bit for each.
pub const MAX_SEPARATORS: usize = 128;

/// Share of the size of a part below which a piece is no piece but rounding.
pub const SMALLEST_PIECE: f64 = 1e-7;

/// An edge of a face, which lies on one of the separators.
#[derive(Clone, Debug)]
pub struct Boundary {
    /// Index of the separator.
    pub separator: usize,
    /// Its course.
    pub curve: Curve,
    /// Whether the loop passes it from start to end.
    pub forward: bool,
}

/// A point of a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Bit k: it is on the positive side of separator k.
    pub sides: u128,
    /// The face has it.
    pub inside: bool,
    /// Where.
    pub point: Vector,
}

/// Why the pieces of a face cannot be told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Confusion {
    /// A line over the surface enters the face and never leaves it.
    Open,
    /// Loops of a sphere contradict each other in what is on their left.
    Orientation,
    /// More separators than [`MAX_SEPARATORS`].
    TooMany,
}

/// The angles over which a curve runs on a cylinder or cone, where a plane has one point at every angle.
#[derive(Clone, Copy, Debug)]
struct Span {
    from: f64,
    /// Negative if it runs backwards.
    sweep: f64,
}

impl Span {
    /// The span of a curve that is given by points; others know their extent themselves.
    fn of(chart: &Chart, curve: &Curve) -> Option<Span> {
        let (Chart::Ruled { .. }, Curve::Points { .. }) = (chart, curve) else {
            return None;
        };
        let angles: Vec<f64> = curve
            .sampled(1)
            .into_iter()
            .map(|p| chart.u_of(p))
            .collect();
        let sweep = angles
            .windows(2)
            .map(|pair| (pair[1] - pair[0] + PI).rem_euclid(TAU) - PI)
            .sum();
        Some(Span {
            from: angles[0],
            sweep,
        })
    }

    fn has(self, u: f64) -> bool {
        let turned = if self.sweep < 0.0 {
            self.from - u
        } else {
            u - self.from
        };
        positive_angle(turned) < self.sweep.abs()
    }
}

/// What is needed to divide a face.
pub struct Division<'a> {
    /// The support surface.
    pub surface: &'a Surface,
    /// What divides it.
    pub separators: &'a [Separator],
    /// The edges of the face.
    pub boundaries: &'a [Boundary],
    /// Size of the part, scene units.
    pub size: f64,
}

/// A crossing of the line u.
struct Crossing {
    w: f64,
    /// Number of edges here, and whether the face is above by the direction of the first.
    edges: usize,
    inside_above: bool,
}

impl Division<'_> {
    /// One sample of every piece.
    pub fn samples(&self) -> Result<Vec<Sample>, Confusion> {
        if self.separators.len() > MAX_SEPARATORS {
            return Err(Confusion::TooMany);
        }
        let Some(chart) = Chart::of(self.surface, self.separators) else {
            return Ok(vec![]);
        };
        let spans: Vec<Option<Span>> = self
            .boundaries
            .iter()
            .map(|boundary| Span::of(&chart, &boundary.curve))
            .collect();
        let mut lines = vec![];
        for u in self.middles(&chart) {
            lines.push((u, self.crossings(&chart, u, &spans)));
        }
        let pole = self.pole(&lines)?;
        let mut samples = vec![];
        for (u, crossings) in &lines {
            self.strips(&chart, *u, crossings, pole, &mut samples)?;
        }
        Ok(samples)
    }

    /// The middle of every slab.
    fn middles(&self, chart: &Chart) -> Vec<f64> {
        let mut limits: Vec<f64> = self
            .boundaries
            .iter()
            .flat_map(|boundary| boundary.curve.ends())
            .map(|end| chart.u_of(end))
            .collect();
        for (index, separator) in self.separators.iter().enumerate() {
            limits.extend(chart.turns(separator));
            for other in &self.separators[index + 1..] {
                limits.extend(chart.meetings(separator, other, self.surface));
            }
        }
        limits.retain(|u| u.is_finite());
        limits.sort_by(f64::total_cmp);
        if chart.is_periodic() {
            match limits.first() {
                Some(first) => limits.push(first + TAU),
                None => limits = vec![0.0, TAU],
            }
        } else {
            let (first, last) = (limits.first().copied(), limits.last().copied());
            limits.insert(0, first.unwrap_or(0.0) - self.size);
            limits.push(last.unwrap_or(0.0) + self.size);
        }
        let smallest = if chart.is_periodic() {
            SMALLEST_PIECE
        } else {
            SMALLEST_PIECE * self.size
        };
        limits
            .windows(2)
            .filter(|pair| pair[1] - pair[0] > smallest)
            .map(|pair| 0.5 * (pair[0] + pair[1]))
            .collect()
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
                    edges: 0,
                    inside_above: false,
                };
                for (boundary, span) in self.boundaries.iter().zip(spans) {
                    if boundary.separator == index {
                        self.pass(chart, u, boundary, *span, &mut crossing);
                    }
                }
                all.push(crossing);
            }
        }
        all.sort_by(|a, b| a.w.total_cmp(&b.w));
        all
    }

    /// Counts an edge that passes this crossing.
    fn pass(
        &self,
        chart: &Chart,
        u: f64,
        boundary: &Boundary,
        span: Option<Span>,
        crossing: &mut Crossing,
    ) {
        if matches!(self.surface, Surface::Cone { .. }) && crossing.w <= 0.0 {
            return;
        }
        if let Some(span) = span {
            crossing.edges += usize::from(span.has(u));
            return;
        }
        let p = chart.point(u, crossing.w);
        if let Some(direction) = boundary.curve.direction_at(p, 1e-6 * self.size) {
            let east = dot(direction, chart.eastwards(p)) > 0.0;
            crossing.edges += 1;
            crossing.inside_above = east == boundary.forward;
        }
    }

    /// Whether the south pole of a sphere is in the face: what all lines that meet an edge say.
    fn pole(&self, lines: &[(f64, Vec<Crossing>)]) -> Result<bool, Confusion> {
        let Surface::Sphere { .. } = self.surface else {
            return Ok(false);
        };
        let mut known = None;
        for (_, crossings) in lines {
            let Some(first) = crossings.iter().find(|c| c.edges % 2 == 1) else {
                continue;
            };
            let below = !first.inside_above;
            if known.is_some_and(|known| known != below) {
                return Err(Confusion::Orientation);
            }
            known = Some(below);
        }
        Ok(known.unwrap_or(true))
    }

    fn strips(
        &self,
        chart: &Chart,
        u: f64,
        crossings: &[Crossing],
        pole: bool,
        samples: &mut Vec<Sample>,
    ) -> Result<(), Confusion> {
        let cone = matches!(self.surface, Surface::Cone { .. });
        let total: usize = crossings.iter().map(|c| c.edges).sum();
        // A cone is entered from its open end, since its apex may belong to the face; all others from below.
        let mut inside = if cone { total % 2 == 1 } else { pole };
        if !matches!(self.surface, Surface::Sphere { .. } | Surface::Cone { .. }) && total % 2 == 1
        {
            return Err(Confusion::Open);
        }
        let [low, high] = chart.reach();
        let mut from = low;
        for crossing in crossings {
            self.strip(chart, u, [from, crossing.w], inside, samples);
            if crossing.edges % 2 == 1 {
                inside = !inside;
                let sphere = matches!(self.surface, Surface::Sphere { .. });
                if sphere && inside != crossing.inside_above {
                    return Err(Confusion::Orientation);
                }
            }
            from = crossing.w;
        }
        self.strip(chart, u, [from, high], inside, samples);
        Ok(())
    }

    fn strip(
        &self,
        chart: &Chart,
        u: f64,
        [from, to]: [f64; 2],
        inside: bool,
        samples: &mut Vec<Sample>,
    ) {
        let unit = match chart {
            Chart::Sphere { .. } => 1.0,
            _ => self.size,
        };
        if to - from <= SMALLEST_PIECE * unit {
            return;
        }
        let w = match (from.is_finite(), to.is_finite()) {
            (true, true) => 0.5 * (from + to),
            (true, false) => from + unit,
            (false, true) => to - unit,
            (false, false) => 0.0,
        };
        let nappe = !matches!(self.surface, Surface::Cone { .. }) || w > 0.0;
        let point = chart.point(u, w);
        let mut sides = 0;
        for (index, separator) in self.separators.iter().enumerate() {
            sides |= u128::from(separator.is_positive(point)) << index;
        }
        samples.push(Sample {
            sides,
            inside: inside && nappe,
            point,
        });
    }
}
