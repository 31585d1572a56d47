//! Conics in the plane of a face, and straight lines that part two of them.

use super::curve::{Curve, Ellipse, PlaneOf};
use super::surface::{Form, Implicit, Surface};
use super::vector::*;
use std::f64::consts::PI;

/// Most sides of a polygon between two circles, one in the other.
const MAX_SIDES: usize = 60;

/// A conic as a quadric that meets the plane in it.
#[derive(Clone, Debug)]
pub struct Conic {
    pub implicit: Implicit,
    pub centre: Vector,
    /// Least and greatest distance of the conic from it.
    pub radii: [f64; 2],
}

impl Conic {
    /// The conic of an edge in which a quadric meets the plane.
    pub fn of(implicit: Implicit, curve: &Curve, origin: Vector, normal: Vector) -> Conic {
        let (centre, radii) = match curve {
            Curve::Arc(arc) => (arc.ellipse.centre, range(arc.ellipse.radii.into_iter())),
            _ => {
                let points = curve.sampled(64);
                let centre = middle(&implicit, origin, normal).unwrap_or_else(|| mean(&points));
                (centre, range(points.iter().map(|p| distance(*p, centre))))
            }
        };
        Conic {
            implicit,
            centre,
            radii,
        }
    }

    /// The cylinder upright on an ellipse.
    pub fn upright(ellipse: &Ellipse, normal: Vector) -> Conic {
        let Ellipse {
            centre, x, radii, ..
        } = *ellipse;
        let round = Surface::new(centre, normal, Form::Cylinder(radii[0])).implicit();
        let round = round.filter(|_| radii[0] == radii[1]);
        Conic {
            implicit: round.unwrap_or_else(|| elliptic(centre, [x, cross(normal, x)], radii)),
            centre,
            radii: range(radii.into_iter()),
        }
    }
}

/// `(x.(p - c))^2 / a^2 + (y.(p - c))^2 / b^2 - 1`
fn elliptic(centre: Vector, axes: [Vector; 2], radii: [f64; 2]) -> Implicit {
    let mut all = [0.0; 10];
    for (axis, radius) in axes.into_iter().zip(radii) {
        let weight = 1.0 / (radius * radius);
        let offset = dot(axis, centre);
        let [x, y, z] = axis;
        let own = [x * x, y * y, z * z, x * y, x * z, y * z];
        let linear = axis.map(|v| -offset * v);
        let terms = own.into_iter().chain(linear).chain([offset * offset]);
        for (sum, term) in all.iter_mut().zip(terms) {
            *sum += weight * term;
        }
    }
    all[9] -= 1.0;
    Implicit(all)
}

/// Centre of the conic in which a quadric meets a plane; nothing for a parabola.
fn middle(implicit: &Implicit, origin: Vector, normal: Vector) -> Option<Vector> {
    let [e, f] = frame(normal, 0.0);
    let gradient = |p: Vector| {
        let g = implicit.half_gradient(p);
        [dot(g, e), dot(g, f)]
    };
    let [p, q] = gradient(origin);
    let [a, b] = gradient(plus(origin, e));
    let [c, d] = gradient(plus(origin, f));
    let (a, b, c, d) = (a - p, b - q, c - p, d - q);
    let determinant = a * d - b * c;
    if determinant.abs() <= 1e-12 * (a * a + b * b + c * c + d * d) {
        return None;
    }
    let u = -(p * d - q * c) / determinant;
    let v = -(a * q - b * p) / determinant;
    Some(along(along(origin, u, e), v, f))
}

/// Planes upright on the face, so that no region between them needs both conics.
///
/// Side by side: one line between them. Crossing circles: the line through both points. One in the other: a polygon
/// around the inner one, inside the outer one.
pub fn between(one: &Conic, other: &Conic, normal: Vector) -> Vec<PlaneOf> {
    let swapped = one.radii[1] > other.radii[1];
    let (small, large) = if swapped { (other, one) } else { (one, other) };
    let gap = across(minus(large.centre, small.centre), normal);
    let (d, r, s) = (length(gap), small.radii[1], large.radii[1]);
    let line = |share: f64| vec![(along(small.centre, share, unit(gap)), unit(gap))];
    if d >= r + s {
        return line(r + 0.5 * (d - r - s));
    }
    if d + r < large.radii[0] {
        return polygon(small, large.radii[0] - d, normal);
    }
    if d == 0.0 {
        return vec![];
    }
    // The radical axis of two circles; of ellipses, the line halfway, which the rounds of splitting go on from.
    line((d * d + r * r - s * s) / (2.0 * d))
}

/// Sides of a regular polygon around a conic within a circle of a radius about its centre; too many sides end at the
/// most there may be.
fn polygon(small: &Conic, within: f64, normal: Vector) -> Vec<PlaneOf> {
    let inner = small.radii[1];
    let fits = |n: &usize| (PI / *n as f64).cos() * within > inner * 1.000_001;
    let sides = [4, 6, 8, 10, 12, 16, 20, 28, 40, MAX_SIDES];
    let Some(n) = sides.into_iter().find(fits) else {
        return vec![];
    };
    let reach = 0.5 * (inner + within * (PI / n as f64).cos());
    let [e, f] = frame(normal, 0.0);
    let side = |k: usize| {
        let (sine, cosine) = (2.0 * PI * k as f64 / n as f64).sin_cos();
        let out = plus(times(cosine, e), times(sine, f));
        (along(small.centre, reach, out), out)
    };
    (0..n).map(side).collect()
}
