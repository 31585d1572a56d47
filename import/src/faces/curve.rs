//! Curves of edges.

use super::vector::{
    Vector, along, cross, distance, dot, length, minus, onto_plane, plus, positive_angle, times,
    unit,
};
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
    /// `centre + radii[0] cos(a) x + radii[1] sin(a) (normal x x)`, a from `start` to `start + sweep`.
    Arc {
        /// Centre.
        centre: Vector,
        /// Unit normal of its plane; angles run counter-clockwise about it.
        normal: Vector,
        /// Unit vector of the angle 0.
        x: Vector,
        /// Half axes; equal for a circle.
        radii: [f64; 2],
        /// First angle, radians.
        start: f64,
        /// Angle from start to end, 0 to 2 pi; 2 pi for a whole one.
        sweep: f64,
    },
    /// Points along the edge, close enough that what is between two of them is theirs alone.
    Points {
        /// At least two, the first and last are the ends; closed curves do not repeat the first.
        points: Vec<Vector>,
        /// Whether the last point is followed by the first.
        closed: bool,
        /// The plane they all lie in, if they do.
        plane: Option<PlaneOf>,
        /// What is farther off the points than this is not on the curve.
        slack: f64,
    },
}

impl Curve {
    /// A curve through points; its plane is found.
    pub fn through(points: Vec<Vector>, closed: bool, tolerance: f64) -> Curve {
        let plane = common_plane(&points, tolerance);
        let steps = points.windows(2).map(|pair| distance(pair[0], pair[1]));
        let last = points.last().map(|p| distance(*p, points[0]));
        let slack = steps.chain(last.filter(|_| closed)).fold(0.0, f64::max);
        Curve::Points {
            points,
            closed,
            plane,
            slack,
        }
    }

    /// It has no ends.
    pub fn is_closed(&self) -> bool {
        match self {
            Self::Line { .. } => false,
            Self::Arc { sweep, .. } => *sweep >= TAU,
            Self::Points { closed, .. } => *closed,
        }
    }

    /// The plane the curve spans; nothing for a line, which lies in many, and for a curve in space.
    pub fn plane(&self) -> Option<PlaneOf> {
        match self {
            Self::Line { .. } => None,
            Self::Arc { centre, normal, .. } => Some((*centre, *normal)),
            Self::Points { plane, .. } => *plane,
        }
    }

    /// Where it starts and ends; twice the same point if it is closed.
    pub fn ends(&self) -> [Vector; 2] {
        match self {
            Self::Line { from, to } => [*from, *to],
            Self::Arc { start, sweep, .. } => {
                [*start, start + sweep].map(|angle| self.at_angle(angle))
            }
            Self::Points { points, closed, .. } => {
                let last = if *closed { 0 } else { points.len() - 1 };
                [points[0], points[last]]
            }
        }
    }

    fn at_angle(&self, angle: f64) -> Vector {
        let Self::Arc {
            centre,
            normal,
            x,
            radii,
            ..
        } = self
        else {
            unreachable!("only arcs have angles")
        };
        let y = cross(*normal, *x);
        let (sine, cosine) = angle.sin_cos();
        plus(
            *centre,
            plus(times(radii[0] * cosine, *x), times(radii[1] * sine, y)),
        )
    }

    /// Points along the curve from its start to its end, `count` steps for an arc; a closed curve comes back to its start.
    pub fn sampled(&self, count: usize) -> Vec<Vector> {
        match self {
            Self::Line { from, to } => (0..=count)
                .map(|k| along(*from, k as f64 / count as f64, minus(*to, *from)))
                .collect(),
            Self::Arc { start, sweep, .. } => (0..=count)
                .map(|k| self.at_angle(start + sweep * k as f64 / count as f64))
                .collect(),
            Self::Points { points, closed, .. } => {
                let mut all = points.clone();
                if *closed {
                    all.push(points[0]);
                }
                all
            }
        }
    }

    /// If `p`, a point of the curve's endless continuation, is between its ends: the direction in which the curve passes it.
    pub fn direction_at(&self, p: Vector, tolerance: f64) -> Option<Vector> {
        match self {
            Self::Line { from, to } => {
                let course = minus(*to, *from);
                let share = dot(minus(p, *from), course) / dot(course, course);
                let off = distance(p, along(*from, share, course));
                ((0.0..=1.0).contains(&share) && off <= tolerance).then_some(course)
            }
            Self::Arc {
                centre,
                normal,
                x,
                radii,
                start,
                sweep,
            } => {
                let y = cross(*normal, *x);
                let from = minus(p, *centre);
                let (a, b) = (dot(from, *x) / radii[0], dot(from, y) / radii[1]);
                let off = (a.hypot(b) - 1.0).abs() * radii[0].max(radii[1]);
                let angle = b.atan2(a);
                let on = off <= tolerance
                    && dot(from, *normal).abs() <= tolerance
                    && positive_angle(angle - start) <= *sweep;
                on.then(|| {
                    plus(
                        times(-radii[0] * angle.sin(), *x),
                        times(radii[1] * angle.cos(), y),
                    )
                })
            }
            Self::Points {
                points,
                closed,
                slack,
                ..
            } => passing(points, *closed, p, *slack),
        }
    }
}

/// Direction of the polyline at the place nearest to `p`; nothing if that is one of its ends, or farther off than `slack`.
fn passing(points: &[Vector], closed: bool, p: Vector, slack: f64) -> Option<Vector> {
    let segments = if closed {
        points.len()
    } else {
        points.len() - 1
    };
    let mut best: Option<(f64, usize, f64)> = None;
    for k in 0..segments {
        let (from, to) = (points[k], points[(k + 1) % points.len()]);
        let course = minus(to, from);
        let share = (dot(minus(p, from), course) / dot(course, course)).clamp(0.0, 1.0);
        let off = distance(p, along(from, share, course));
        if best.is_none_or(|(least, ..)| off < least) {
            best = Some((off, k, share));
        }
    }
    let (off, k, share) = best?;
    let (from, to) = (points[k], points[(k + 1) % points.len()]);
    let beyond = !closed && ((k == 0 && share == 0.0) || (k == segments - 1 && share == 1.0));
    (!beyond && off <= slack).then(|| minus(to, from))
}

/// The plane in which all points lie within a length; nothing if they do not, or lie in a line.
pub fn common_plane(points: &[Vector], tolerance: f64) -> Option<PlaneOf> {
    let first = *points.first()?;
    let farthest = |measure: &dyn Fn(Vector) -> f64| {
        points
            .iter()
            .copied()
            .max_by(|p, q| measure(*p).total_cmp(&measure(*q)))
    };
    let second = farthest(&|p| distance(p, first))?;
    let line = unit(minus(second, first));
    let third = farthest(&|p| length(cross(minus(p, first), line)))?;
    let normal = cross(line, minus(third, first));
    if length(normal) <= 100.0 * tolerance {
        return None;
    }
    let normal = unit(normal);
    points
        .iter()
        .all(|p| distance(*p, onto_plane(*p, first, normal)) <= tolerance)
        .then_some((first, normal))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn half_circle() -> Curve {
        Curve::Arc {
            centre: [1.0, 0.0, 0.0],
            normal: [0.0, 0.0, 1.0],
            x: [1.0, 0.0, 0.0],
            radii: [2.0, 2.0],
            start: 0.0,
            sweep: std::f64::consts::PI,
        }
    }

    #[test]
    fn arcs_pass_their_own_half_alone() {
        let arc = half_circle();
        let direction = arc.direction_at([1.0, 2.0, 0.0], 1e-9).unwrap();
        assert!(distance(unit(direction), [-1.0, 0.0, 0.0]) < 1e-12);
        assert!(arc.direction_at([1.0, -2.0, 0.0], 1e-9).is_none());
        assert!(arc.direction_at([1.0, 1.0, 0.0], 1e-9).is_none());
    }

    #[test]
    fn points_in_a_plane_have_it() {
        let arc = half_circle().sampled(20);
        let (_, normal) = common_plane(&arc, 1e-12).unwrap();
        assert!((normal[2].abs() - 1.0).abs() < 1e-12);
        let mut twisted = arc;
        twisted[7][2] = 0.1;
        assert!(common_plane(&twisted, 1e-3).is_none());
        assert!(common_plane(&[[0.0; 3], [1.0; 3], [2.0; 3]], 1e-9).is_none());
    }

    #[test]
    fn polylines_pass_between_their_ends() {
        let curve = Curve::through(half_circle().sampled(20), false, 1e-12);
        let direction = curve.direction_at([1.0, 2.0, 0.0], 1e-9).unwrap();
        assert!(direction[0] < 0.0 && direction[1].abs() < 0.2);
        assert!(curve.direction_at([3.0, -0.5, 0.0], 1e-9).is_none());
    }
}
