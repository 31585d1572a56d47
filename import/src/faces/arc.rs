//! Arcs of circles and ellipses between two points.

use super::curve::Curve;
use super::vector::{Vector, cross, dot, minus, positive_angle};
use std::f64::consts::TAU;

/// A whole ellipse, or a circle with both radii equal.
#[derive(Clone, Copy, Debug)]
pub struct Ellipse {
    /// Centre.
    pub centre: Vector,
    /// Unit normal; arcs run counter-clockwise about it.
    pub normal: Vector,
    /// Unit vector across it, of the first radius.
    pub x: Vector,
    /// Half axes, above 0.
    pub radii: [f64; 2],
}

/// What an arc has to keep to, scene units.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance {
    /// An end may miss the ellipse by so much.
    pub missed: f64,
    /// Least length of an arc.
    pub shortest: f64,
}

/// What is wrong with an arc, and what would be accepted.
pub type Problem = (String, &'static str);

impl Ellipse {
    /// The part from the first end to the second; the whole without ends, or if both are one vertex.
    pub fn arc(
        &self,
        ends: Option<[Vector; 2]>,
        one_vertex: bool,
        tolerance: Tolerance,
    ) -> Result<Curve, Problem> {
        let y = cross(self.normal, self.x);
        let most = self.radii[0].max(self.radii[1]);
        let mut angles = vec![];
        for p in ends.into_iter().flatten() {
            let from = minus(p, self.centre);
            let (a, b) = (
                dot(from, self.x) / self.radii[0],
                dot(from, y) / self.radii[1],
            );
            let off = (a.hypot(b) - 1.0).abs() * most;
            let off = off.max(dot(from, self.normal).abs());
            if off > tolerance.missed {
                return Err((
                    format!("an end is {off:e} off the curve"),
                    "vertices on the curve are needed",
                ));
            }
            angles.push(b.atan2(a));
        }
        let (start, sweep) = match angles[..] {
            [from, to] if !one_vertex => (from, positive_angle(to - from)),
            [from, _] => (from, TAU),
            _ => (0.0, TAU),
        };
        if sweep * self.radii[0].min(self.radii[1]) <= tolerance.shortest {
            return Err((
                "the arc has no length".into(),
                "two vertices at different places, counter-clockwise about `axis`, are needed",
            ));
        }
        Ok(Curve::Arc {
            centre: self.centre,
            normal: self.normal,
            x: self.x,
            radii: self.radii,
            start,
            sweep,
        })
    }
}
