//! Points of surfaces, and whether cells keep them.

use imogene_import::faces::vector::{Vector, along, dot, frame, minus, plus, times};
use imogene_import::faces::{Cell, Form, Part, Surface};
use std::f64::consts::TAU;

/// Whether a point of the surface is in one of the cells: the half-spaces as they stand in the scene.
pub fn kept(part: &Part, cells: &[Cell], p: Vector) -> bool {
    cells.iter().any(|cell| {
        let planes = cell.cuts.iter().all(|(plane, positive)| {
            let (point, normal) = part.planes.get(*plane);
            (dot(minus(p, point), normal) > 0.0) == *positive
        });
        // Of a flat cell the quadric is a side; of others it is the surface itself.
        let conic = cell.flat.is_none() || cell.quadric.is_none_or(|q| q.value(p) <= 0.0);
        planes && conic
    })
}

/// A small generator of even numbers (splitmix64), so that every run has the same points.
pub struct Even(pub u64);

impl Even {
    /// The next, 0 to 1.
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A point of a surface in or near a ball.
pub fn point_of(surface: &Surface, middle: Vector, size: f64, even: &mut Even) -> Vector {
    let reach = 0.75 * size;
    let Surface { origin, axis, .. } = *surface;
    let [e, f] = frame(axis, 0.0);
    let round = |angle: f64| plus(times(angle.cos(), e), times(angle.sin(), f));
    match surface.form {
        Form::Plane => {
            let foot = along(middle, -dot(minus(middle, origin), axis), axis);
            let (a, b) = (even.next() - 0.5, even.next() - 0.5);
            along(along(foot, 2.0 * reach * a, e), 2.0 * reach * b, f)
        }
        Form::Cylinder(radius) => {
            let (angle, height) = (TAU * even.next(), 2.0 * reach * (even.next() - 0.5));
            let foot = along(origin, dot(minus(middle, origin), axis) + height, axis);
            along(foot, radius, round(angle))
        }
        Form::Cone(half_angle) => {
            let (angle, t) = (TAU * even.next(), 4.0 * reach * (even.next() - 0.5));
            let (sine, cosine) = half_angle.sin_cos();
            along(along(origin, t * cosine, axis), t * sine, round(angle))
        }
        Form::Sphere(radius) => {
            let z = 2.0 * even.next() - 1.0;
            let angle = TAU * even.next();
            let r = (1.0 - z * z).sqrt();
            along(origin, radius, [r * angle.cos(), r * angle.sin(), z])
        }
        Form::Torus(..) | Form::Other(_) => unreachable!("not drawn as one surface"),
    }
}
