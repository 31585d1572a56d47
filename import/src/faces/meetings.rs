//! Where separators turn and meet on a surface, by the coordinate u of its chart.

use super::polynomial::{harmonic, quadratic, roots_between};
use super::vector::{Vector, along, cross, dot, length, minus, plus, positive_angle, times};
use super::{Chart, Form, Implicit, Separator, Surface};
use std::f64::consts::PI;

impl Chart {
    /// All u at which the number of crossings of a separator may change, or at which it lies along the line u.
    pub fn turns(&self, separator: &Separator) -> Vec<f64> {
        let Surface { origin, axis, .. } = self.surface;
        let (normal, offset) = match separator {
            Separator::Plane(plane) => *plane,
            Separator::Quadric(implicit) => return self.turns_of_conic(implicit),
        };
        let [n1, n2] = self.e.map(|e| dot(normal, e));
        let (up, rest) = (dot(normal, axis), offset - dot(normal, origin));
        match self.surface.form {
            Form::Plane if n2.abs() <= 1e-12 && n1 != 0.0 => vec![rest / n1],
            Form::Cylinder(radius) => harmonic(radius * n1, radius * n2, rest),
            Form::Cone(angle) => {
                let (sine, cosine) = angle.sin_cos();
                harmonic(sine * n1, sine * n2, -cosine * up)
            }
            Form::Sphere(radius) => {
                let rest = rest / radius;
                let root = (rest * rest - up * up).sqrt();
                let rests = [root, -root, 0.0].into_iter().filter(|rest| !rest.is_nan());
                rests.flat_map(|rest| harmonic(n1, n2, rest)).collect()
            }
            _ => vec![],
        }
    }

    fn turns_of_conic(&self, implicit: &Implicit) -> Vec<f64> {
        let (a, b, c) = self.conic(implicit);
        // Discriminant of the quadratic in v, as a polynomial in u.
        let disc = [
            b[0] * b[0] - 4.0 * a * c[0],
            2.0 * b[0] * b[1] - 4.0 * a * c[1],
            b[1] * b[1] - 4.0 * a * c[2],
        ];
        let mut turns = quadratic(disc[2], disc[1], disc[0]);
        turns.extend(quadratic(0.0, b[1], b[0]));
        turns
    }

    /// All u at which two separators cross each other on the surface.
    pub fn meetings(&self, one: &Separator, other: &Separator) -> Vec<f64> {
        match (one, other) {
            (Separator::Plane(one), Separator::Plane(other)) => self.two_planes(*one, *other),
            (Separator::Quadric(one), Separator::Quadric(other)) => self.two_conics(one, other),
            (Separator::Plane(plane), Separator::Quadric(implicit))
            | (Separator::Quadric(implicit), Separator::Plane(plane)) => {
                self.plane_and_conic(*plane, implicit)
            }
        }
    }

    fn two_planes(&self, (n, c): (Vector, f64), (m, d): (Vector, f64)) -> Vec<f64> {
        let direction = cross(n, m);
        let square = dot(direction, direction);
        if square <= 1e-24 {
            return vec![];
        }
        let sum = plus(times(c, cross(m, direction)), times(d, cross(direction, n)));
        let start = times(1.0 / square, sum);
        let u_at = |t: f64| self.u_of(along(start, t, direction));
        if let Some((origin, normal)) = self.surface.plane() {
            let slope = dot(direction, normal);
            if slope.abs() <= 1e-13 * length(direction) {
                return vec![];
            }
            return vec![u_at(dot(minus(origin, start), normal) / slope)];
        }
        let Some(implicit) = self.surface.implicit() else {
            return vec![];
        };
        let [a, b, c] = implicit.on_line(start, direction);
        let meetings = quadratic(a, b, c).into_iter().map(u_at);
        // A point of the other nappe lies on the line of the opposite angle.
        let opposite = |u: f64| self.surface.is_cone().then(|| positive_angle(u + PI));
        let both = meetings.flat_map(|u| [Some(u), opposite(u)]);
        both.flatten().collect()
    }

    fn plane_and_conic(&self, (n, c): (Vector, f64), implicit: &Implicit) -> Vec<f64> {
        let [n1, n2] = self.e.map(|e| dot(n, e));
        let square = n1 * n1 + n2 * n2;
        if square <= 1e-24 {
            return vec![];
        }
        let rest = (c - dot(n, self.surface.origin)) / square;
        let start = self.point(rest * n1, rest * n2);
        let direction = along(times(-n2, self.e[0]), n1, self.e[1]);
        let [a, b, c] = implicit.on_line(start, direction);
        let u_at = |t: f64| self.u_of(along(start, t, direction));
        quadratic(a, b, c).into_iter().map(u_at).collect()
    }

    /// Roots of the resultant of the two quadratics in v.
    fn two_conics(&self, one: &Implicit, other: &Implicit) -> Vec<f64> {
        let [(a, b, c), (d, f, g)] = [one, other].map(|implicit| self.conic(implicit));
        let combine = |factor: f64, u: &[f64], by: f64, v: &[f64]| -> Vec<f64> {
            let at = |list: &[f64], k: usize| list.get(k).copied().unwrap_or(0.0);
            let each = 0..u.len().max(v.len());
            each.map(|k| factor * at(u, k) - by * at(v, k)).collect()
        };
        let product = |u: &[f64], v: &[f64]| -> Vec<f64> {
            let mut all = vec![0.0; u.len() + v.len() - 1];
            for (i, x) in u.iter().enumerate() {
                for (j, y) in v.iter().enumerate() {
                    all[i + j] += x * y;
                }
            }
            all
        };
        let ag = combine(a, &g, d, &c);
        let af = combine(a, &f, d, &b);
        let bg: Vec<f64> = combine(1.0, &product(&b, &g), 1.0, &product(&f, &c));
        let resultant = combine(1.0, &product(&ag, &ag), 1.0, &product(&af, &bg));
        let turns = [one, other].map(|implicit| self.turns_of_conic(implicit));
        let mut turns = turns.concat();
        turns.sort_by(f64::total_cmp);
        let [Some(low), Some(high)] = [turns.first(), turns.last()] else {
            return vec![];
        };
        let margin = high - low;
        roots_between(&resultant, low - margin, high + margin)
    }

    /// A quadric on a plane as a quadratic in v: `a`, and the coefficients of `b` and `c` in u, lowest power first.
    fn conic(&self, implicit: &Implicit) -> (f64, [f64; 2], [f64; 3]) {
        let (origin, e) = (self.surface.origin, self.e);
        let [uu, u, one] = implicit.on_line(origin, e[0]);
        let [vv, v, _] = implicit.on_line(origin, e[1]);
        let [_, both, _] = implicit.on_line(along(origin, 1.0, e[0]), e[1]);
        (vv, [v, both - v], [one, u, uu])
    }
}
