//! Two numbers (u, v) for each point of a surface: planes cut out the lines u = constant.

use super::cell::Separator;
use super::curve::PlaneOf;
use super::polynomial::{harmonic, quadratic};
use super::surface::{Form, Surface};
use super::vector::*;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A surface with coordinates. u runs eastwards, v northwards, and both turn counter-clockwise seen from the side of
/// the surface's own normal.
///
/// On a plane u and v are lengths, on the others u is the angle about the axis; v is the height on a cylinder, the
/// distance from the apex on a cone, the latitude on a sphere and the angle about the tube, from outside, on a torus.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The surface; the axis of a sphere is that of the chart.
    pub surface: Surface,
    /// Two unit vectors across the axis, of the angles 0 and a quarter of a turn.
    pub e: [Vector; 2],
}

impl Chart {
    /// Of a surface; `north` is the direction of growing v on a plane, and the pole of a sphere.
    pub fn of(surface: &Surface, north: Option<Vector>) -> Chart {
        let mut surface = surface.clone();
        if surface.is_sphere() {
            surface.axis = north.unwrap_or([0.0, 0.0, 1.0]);
        }
        let e = match north {
            Some(north) if surface.is_plane() => [cross(north, surface.axis), north],
            _ => frame(surface.axis, 0.0),
        };
        Chart { surface, e }
    }

    /// A chart of a plane or a quadric in which none of the separators lies along a line that matters.
    pub fn free(surface: &Surface, separators: &[Separator]) -> Chart {
        let mut chart = Chart::of(surface, free_pole(surface, separators));
        if surface.is_plane() {
            // Away from the directions that edges of parts have.
            chart.e = frame(surface.axis, 0.387_161_9);
        }
        chart
    }

    /// u is an angle.
    pub fn is_round(&self) -> bool {
        !self.surface.is_plane()
    }

    /// The ends of v, of both nappes of a cone.
    pub fn reach(&self) -> [f64; 2] {
        match self.surface.form {
            Form::Sphere(_) => [-FRAC_PI_2, FRAC_PI_2],
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// u and v of a point of the surface.
    pub fn coordinates(&self, p: Vector) -> [f64; 2] {
        let from = minus(p, self.surface.origin);
        let [x, y] = self.e.map(|e| dot(from, e));
        let (out, up) = (x.hypot(y), dot(from, self.surface.axis));
        let v = match self.surface.form {
            Form::Plane => return [x, y],
            Form::Cone(angle) => out * angle.sin() + up * angle.cos(),
            Form::Sphere(_) => up.atan2(out),
            Form::Torus(major, _) => up.atan2(out - major),
            _ => up,
        };
        [positive_angle(y.atan2(x)), v]
    }

    /// u of a point of the surface.
    pub fn u_of(&self, p: Vector) -> f64 {
        self.coordinates(p)[0]
    }

    /// The point of the surface at u and v.
    pub fn point(&self, u: f64, v: f64) -> Vector {
        let Surface { origin, axis, .. } = self.surface;
        if self.surface.is_plane() {
            return along(along(origin, u, self.e[0]), v, self.e[1]);
        }
        let (out, up) = self.meridian(v);
        along(along(origin, out, self.radial(u)), up, axis)
    }

    /// Distance from the axis, and height along it.
    pub fn meridian(&self, v: f64) -> (f64, f64) {
        match self.surface.form {
            Form::Cylinder(radius) => (radius, v),
            Form::Cone(angle) => (v * angle.sin(), v * angle.cos()),
            Form::Sphere(radius) => (radius * v.cos(), radius * v.sin()),
            Form::Torus(major, minor) => (major + minor * v.cos(), minor * v.sin()),
            Form::Plane | Form::Other(_) => (0.0, 0.0),
        }
    }

    /// The point of the axis at a height.
    pub fn on_axis(&self, height: f64) -> Vector {
        along(self.surface.origin, height, self.surface.axis)
    }

    /// The unit vector across the axis at the angle u.
    pub fn radial(&self, u: f64) -> Vector {
        let (sine, cosine) = u.sin_cos();
        plus(times(cosine, self.e[0]), times(sine, self.e[1]))
    }

    /// The direction of growing u at a point of the surface.
    pub fn eastwards(&self, p: Vector) -> Vector {
        match self.surface.form {
            Form::Plane => self.e[0],
            _ => cross(self.surface.axis, minus(p, self.surface.origin)),
        }
    }

    /// The plane of the line u, with its normal eastwards.
    pub fn meridian_plane(&self, u: f64) -> PlaneOf {
        let Surface { origin, axis, .. } = self.surface;
        match self.is_round() {
            true => (origin, cross(axis, self.radial(u))),
            false => (along(origin, u, self.e[0]), self.e[0]),
        }
    }

    /// The plane of the line v, with its normal northwards.
    pub fn parallel_plane(&self, v: f64) -> PlaneOf {
        match self.is_round() {
            true => self.level_plane(self.meridian(v).1),
            false => (along(self.surface.origin, v, self.e[1]), self.e[1]),
        }
    }

    /// The plane across the axis at a height, with its normal along the axis.
    pub fn level_plane(&self, height: f64) -> PlaneOf {
        (self.on_axis(height), self.surface.axis)
    }

    /// The cone or cylinder that joins the circles of two parallels; `None` if both are in one plane.
    pub fn chord(&self, low: f64, high: f64) -> Option<Surface> {
        let Surface { origin, axis, .. } = self.surface;
        let [(out, up), (other, higher)] = [self.meridian(low), self.meridian(high)];
        let (rise, spread) = (higher - up, other - out);
        let size = length([rise, spread, 0.0]);
        if spread.abs() <= 1e-3 * size {
            let form = Form::Cylinder(0.5 * (out + other));
            return Some(Surface::new(origin, axis, form));
        }
        if rise.abs() <= 1e-3 * size {
            return None;
        }
        // From the apex, where the distance from the axis is 0, towards the wider circle.
        let widening = spread.signum() * rise.signum();
        let apex = along(self.on_axis(up), -out * rise / spread, axis);
        let form = Form::Cone((spread / rise).abs().atan());
        Some(Surface::new(apex, times(widening, axis), form))
    }

    /// A line u = constant as start and direction in v; nothing on a sphere and a torus, where it is round.
    fn line(&self, u: f64) -> Option<(Vector, Vector)> {
        let Surface { origin, axis, .. } = self.surface;
        match self.surface.form {
            Form::Plane => Some((along(origin, u, self.e[0]), self.e[1])),
            Form::Cylinder(_) | Form::Cone(_) => {
                let out = self.radial(u);
                let [(start, _), (end, up)] = [self.meridian(0.0), self.meridian(1.0)];
                let direction = plus(times(end - start, out), times(up, axis));
                Some((along(origin, start, out), direction))
            }
            _ => None,
        }
    }

    /// The v at which a separator passes zero on the line u, ascending.
    pub fn crossings(&self, u: f64, separator: &Separator) -> Vec<f64> {
        match (&self.surface.form, self.line(u), separator) {
            (_, Some((from, along)), Separator::Plane((normal, offset))) => {
                let slope = dot(*normal, along);
                if slope.abs() <= 1e-13 {
                    return vec![];
                }
                vec![(offset - dot(*normal, from)) / slope]
            }
            (_, Some((from, along)), Separator::Quadric(implicit)) => {
                let [a, b, c] = implicit.on_line(from, along);
                quadratic(a, b, c)
            }
            (Form::Sphere(radius), None, Separator::Plane((normal, offset))) => {
                let rest = (offset - dot(*normal, self.surface.origin)) / radius;
                let [out, up] = [self.radial(u), self.surface.axis].map(|d| dot(*normal, d));
                let turned = |v: f64| if v > PI { v - TAU } else { v };
                let all = harmonic(out, up, rest).into_iter().map(turned);
                let mut roots: Vec<f64> = all.filter(|v| v.abs() < FRAC_PI_2).collect();
                roots.sort_by(f64::total_cmp);
                roots
            }
            _ => vec![],
        }
    }

    /// A path without jumps of u, and of v on a tube.
    pub fn path(&self, points: &[Vector]) -> Vec<[f64; 2]> {
        let mut path: Vec<[f64; 2]> = vec![];
        for p in points {
            let mut next = self.coordinates(*p);
            if let Some(last) = path.last() {
                let turns = [self.is_round(), self.surface.is_torus()];
                for k in (0..2).filter(|k| turns[*k]) {
                    next[k] = nearest_turn(next[k], last[k]);
                }
            }
            path.push(next);
        }
        if !self.is_round() || path.len() < 2 {
            return path;
        }
        // A point of the axis has every u: that of its neighbour is taken.
        let on_axis = |p: Vector| {
            let from = minus(p, self.surface.origin);
            dot(from, self.e[0]).hypot(dot(from, self.e[1])) <= 1e-9 * length(from).max(1e-3)
        };
        let last = path.len() - 1;
        for (end, beside) in [(0, 1), (last, last - 1)] {
            if on_axis(points[end]) {
                path[end][0] = path[beside][0];
            }
        }
        path
    }
}

/// Adds to ascending angles the first again, a whole turn on.
pub fn close_round(angles: &mut Vec<f64>) {
    match angles.first() {
        Some(first) => angles.push(first + TAU),
        None => *angles = vec![0.0, TAU],
    }
}

/// An angle as many turns on as makes it nearest to another.
pub fn nearest_turn(v: f64, at: f64) -> f64 {
    at + (v - at + PI).rem_euclid(TAU) - PI
}

/// A pole of a sphere that is far from all separators, out of a fixed set of directions; nothing for other surfaces.
pub fn free_pole(surface: &Surface, separators: &[Separator]) -> Option<Vector> {
    let Form::Sphere(radius) = surface.form else {
        return None;
    };
    let far = |axis: &Vector, separator: &Separator| match separator {
        Separator::Plane((normal, offset)) => {
            let rest = (offset - dot(*normal, surface.origin)) / radius;
            let up = dot(*normal, *axis);
            (up - rest).abs().min((up + rest).abs())
        }
        Separator::Quadric(_) => f64::INFINITY,
    };
    let nearest = |axis: &Vector| {
        let each = separators.iter().map(|separator| far(axis, separator));
        each.fold(f64::INFINITY, f64::min)
    };
    // Directions spread evenly over the sphere by the golden angle.
    let directions = (0..64).map(|k| {
        let z = 1.0 - (2.0 * f64::from(k) + 1.0) / 64.0;
        let angle = 2.399_963_229_728_653 * f64::from(k) + 0.31;
        let across = (1.0 - z * z).sqrt();
        [across * angle.cos(), across * angle.sin(), z]
    });
    let best = directions.max_by(|p, q| nearest(p).total_cmp(&nearest(q)));
    best.map(unit)
}
