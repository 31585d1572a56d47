//! Curves of edges.

use super::vector::*;
use std::f64::consts::TAU;

/// A plane in its own right: a point of it and its unit normal.
pub type PlaneOf = (Vector, Vector);

/// The course of an edge in space.
#[derive(Clone, Debug, PartialEq)]
pub enum Curve {
    /// A straight edge.
    Line {
        /// Start.
        from: Vector,
        /// End.
        to: Vector,
    },
    /// A part of an ellipse, or all of it.
    Arc(Arc),
    /// Any other curve, by points on it.
    Points(Polyline),
}

/// A whole ellipse, or a circle with both radii equal: `centre + radii[0] cos(a) x + radii[1] sin(a) (normal x x)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// Centre.
    pub centre: Vector,
    /// Unit normal; angles run counter-clockwise about it.
    pub normal: Vector,
    /// Unit vector across it, of the angle 0 and the first radius.
    pub x: Vector,
    /// Half axes, above 0.
    pub radii: [f64; 2],
}

/// The part of an ellipse from one angle on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// The whole.
    pub ellipse: Ellipse,
    /// First angle, radians.
    pub start: f64,
    /// Angle from start to end, 0 to 2 pi; 2 pi for a whole one.
    pub sweep: f64,
}

/// Points along a curve, close enough that what is between two of them is theirs alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Polyline {
    /// At least two, the first and last are the ends; closed curves do not repeat the first.
    pub points: Vec<Vector>,
    /// Whether the last point is followed by the first.
    pub closed: bool,
    /// The plane they all lie in, if they do.
    pub plane: Option<PlaneOf>,
    /// What is farther off the points than this is not on the curve.
    pub slack: f64,
}

impl Ellipse {
    /// Of a centre, a unit normal, a unit vector across it and half axes.
    pub fn new(centre: Vector, normal: Vector, x: Vector, radii: [f64; 2]) -> Ellipse {
        Ellipse {
            centre,
            normal,
            x,
            radii,
        }
    }

    fn y(&self) -> Vector {
        cross(self.normal, self.x)
    }

    fn at(&self, angle: f64) -> Vector {
        let (sine, cosine) = angle.sin_cos();
        let [a, b] = self.radii;
        let out = plus(times(a * cosine, self.x), times(b * sine, self.y()));
        plus(self.centre, out)
    }

    /// The angle of a point, and how far it is off the ellipse within its plane and off the plane.
    fn angle(&self, p: Vector) -> (f64, f64, f64) {
        let from = minus(p, self.centre);
        let a = dot(from, self.x) / self.radii[0];
        let b = dot(from, self.y()) / self.radii[1];
        let off = (a.hypot(b) - 1.0).abs() * self.radii[0].max(self.radii[1]);
        (b.atan2(a), off, dot(from, self.normal).abs())
    }

    /// The part from the first end to the second; the whole without ends, or if both are one vertex. An end may miss
    /// the ellipse by `missed`, an arc is longer than `shortest`, scene units. An error is the problem and the remedy.
    pub fn arc(
        self,
        ends: Option<[Vector; 2]>,
        one_vertex: bool,
        [missed, shortest]: [f64; 2],
    ) -> Result<Curve, (String, &'static str)> {
        let mut angles = vec![];
        for p in ends.into_iter().flatten() {
            let (angle, off, above) = self.angle(p);
            let off = off.max(above);
            if off > missed {
                let problem = format!("an end is {off:e} off the curve");
                return Err((problem, "vertices on the curve are needed"));
            }
            angles.push(angle);
        }
        let (start, sweep) = match angles[..] {
            [from, to] if !one_vertex => (from, positive_angle(to - from)),
            [from, _] => (from, TAU),
            _ => (0.0, TAU),
        };
        if sweep * self.radii[0].min(self.radii[1]) <= shortest {
            let accepted =
                "two vertices at different places, counter-clockwise about `axis`, are needed";
            return Err(("the arc has no length".into(), accepted));
        }
        Ok(Curve::Arc(Arc {
            ellipse: self,
            start,
            sweep,
        }))
    }
}

/// The arc of a circle from the first of some points to the last, on the way on which the second comes before a point;
/// all of it if it is closed. Without that point the second is in the first half.
pub fn arc_through(
    (centre, normal): PlaneOf,
    radius: f64,
    [first, second, last]: [Vector; 3],
    before: Option<Vector>,
    closed: bool,
) -> Curve {
    let x = unit(minus(first, centre));
    let angle = |p: Vector, normal: Vector| {
        let from = minus(p, centre);
        positive_angle(dot(from, cross(normal, x)).atan2(dot(from, x)))
    };
    let forward = angle(second, normal) < before.map_or(0.5 * TAU, |p| angle(p, normal));
    let normal = if forward { normal } else { opposite(normal) };
    Curve::Arc(Arc {
        ellipse: Ellipse::new(centre, normal, x, [radius; 2]),
        start: 0.0,
        sweep: if closed { TAU } else { angle(last, normal) },
    })
}

impl Polyline {
    fn segments(&self) -> impl Iterator<Item = [Vector; 2]> {
        let count = self.points.len() - usize::from(!self.closed);
        (0..count).map(|k| [self.points[k], self.points[(k + 1) % self.points.len()]])
    }

    /// Each segment in so many steps, its end not among them; the end of the whole if it has one.
    pub fn refined(&self, steps: usize) -> Vec<Vector> {
        let place = |[from, to]: [Vector; 2], step: usize| match step {
            0 => from,
            _ => along(from, step as f64 / steps as f64, minus(to, from)),
        };
        let of = |segment| (0..steps).map(move |step| place(segment, step));
        let end = self.points.last().filter(|_| !self.closed);
        self.segments().flat_map(of).chain(end.copied()).collect()
    }

    /// Its direction at the place nearest to `p`; `None` if that is one of its ends, or farther off than the slack.
    fn direction_at(&self, p: Vector) -> Option<Vector> {
        let near = |(k, [from, to]): (usize, [Vector; 2])| {
            let course = minus(to, from);
            let share = (dot(minus(p, from), course) / dot(course, course)).clamp(0.0, 1.0);
            (distance(p, along(from, share, course)), k, share, course)
        };
        let each = self.segments().enumerate().map(near);
        let (off, k, share, course) =
            each.reduce(|best, next| if next.0 < best.0 { next } else { best })?;
        let last = self.segments().count() - 1;
        let ended = (k == 0 && share == 0.0) || (k == last && share == 1.0);
        (off <= self.slack && (self.closed || !ended)).then_some(course)
    }
}

impl Curve {
    /// A curve through points; its plane is found.
    pub fn through(points: Vec<Vector>, closed: bool, tolerance: f64) -> Curve {
        let plane = common_plane(&points, tolerance);
        let mut line = Polyline {
            points,
            closed,
            plane,
            slack: 0.0,
        };
        let steps = line.segments().map(|[p, q]| distance(p, q));
        line.slack = steps.fold(0.0, f64::max);
        Curve::Points(line)
    }

    /// It has no ends.
    pub fn is_closed(&self) -> bool {
        match self {
            Self::Line { .. } => false,
            Self::Arc(arc) => arc.sweep >= TAU,
            Self::Points(line) => line.closed,
        }
    }

    /// The plane the curve spans; nothing for a line, which lies in many, and for a curve in space.
    pub fn plane(&self) -> Option<PlaneOf> {
        match self {
            Self::Line { .. } => None,
            Self::Arc(arc) => Some((arc.ellipse.centre, arc.ellipse.normal)),
            Self::Points(line) => line.plane,
        }
    }

    /// Where it starts and ends; twice the same point if it is closed.
    pub fn ends(&self) -> [Vector; 2] {
        match self {
            Self::Line { from, to } => [*from, *to],
            Self::Arc(arc) => [arc.start, arc.start + arc.sweep].map(|a| arc.ellipse.at(a)),
            Self::Points(line) => {
                let first = line.points[0];
                let last = line.points.last().filter(|_| !line.closed);
                [first, *last.unwrap_or(&first)]
            }
        }
    }

    /// Points from start to end, `count` steps for an arc; a closed curve comes back to its start.
    pub fn sampled(&self, count: usize) -> Vec<Vector> {
        let steps = (0..=count).map(|k| k as f64);
        let all = count as f64;
        match self {
            Self::Line { from, to } => steps
                .map(|k| along(*from, k / all, minus(*to, *from)))
                .collect(),
            Self::Arc(arc) => steps
                .map(|k| arc.ellipse.at(arc.start + arc.sweep * k / all))
                .collect(),
            Self::Points(line) => {
                let again = line.points[..1].iter().filter(|_| line.closed);
                line.points.iter().chain(again).copied().collect()
            }
        }
    }

    /// The direction in which the curve passes `p`, a point of its endless continuation, if that is between its ends.
    pub fn direction_at(&self, p: Vector, tolerance: f64) -> Option<Vector> {
        match self {
            Self::Line { from, to } => {
                let course = minus(*to, *from);
                let share = dot(minus(p, *from), course) / dot(course, course);
                let off = distance(p, along(*from, share, course));
                ((0.0..=1.0).contains(&share) && off <= tolerance).then_some(course)
            }
            Self::Arc(arc) => {
                let ellipse = &arc.ellipse;
                let (angle, off, above) = ellipse.angle(p);
                let on = off <= tolerance && above <= tolerance;
                let (sine, cosine) = (angle.sin(), angle.cos());
                let [a, b] = ellipse.radii;
                (on && positive_angle(angle - arc.start) <= arc.sweep)
                    .then(|| plus(times(-a * sine, ellipse.x), times(b * cosine, ellipse.y())))
            }
            Self::Points(line) => line.direction_at(p),
        }
    }
}

/// The plane in which all points lie within a length; `None` if they do not, or lie in a line.
pub fn common_plane(points: &[Vector], tolerance: f64) -> Option<PlaneOf> {
    let first = *points.first()?;
    let line = unit(minus(farthest(points, |p| distance(p, first))?, first));
    let third = farthest(points, |p| length(cross(minus(p, first), line)))?;
    let normal = cross(line, minus(third, first));
    if length(normal) <= 100.0 * tolerance {
        return None;
    }
    let normal = unit(normal);
    let mut all = points.iter();
    all.all(|p| distance(*p, onto_plane(*p, first, normal)) <= tolerance)
        .then_some((first, normal))
}
