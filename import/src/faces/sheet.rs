//! Coordinates (u, v) of a surface of which planes cut out the lines u = constant: turned about an axis, or plane.

use super::chart::Separator;
use super::planes::Planes;
use super::polynomial::{harmonic, quadratic};
use super::surface::Surface;
use super::vector::{Vector, along, cross, dot, frame, length, minus, plus, positive_angle, times};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// What v is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Profile {
    /// A plane: u and v are lengths along two unit vectors.
    Flat,
    /// A cylinder of this radius: v is the height.
    Wall(f64),
    /// A cone with this sine and cosine: v is the distance from the apex.
    Ray(f64, f64),
    /// A sphere of this radius: v is the latitude.
    Ball(f64),
    /// A torus of these radii: v is the angle about the middle of the tube, from the outside.
    Tube(f64, f64),
}

/// A surface with coordinates. u runs eastwards, v northwards, and both turn counter-clockwise seen from the side of
/// the surface's own normal.
#[derive(Clone, Debug)]
pub struct Sheet {
    origin: Vector,
    axis: Vector,
    e: [Vector; 2],
    profile: Profile,
}

impl Sheet {
    /// Of a surface; `north` is the direction of growing v on a plane, and the pole of a sphere.
    pub fn of(surface: &Surface, north: Option<Vector>) -> Option<Sheet> {
        let (origin, axis, profile) = match *surface {
            Surface::Plane { origin, normal } => (origin, normal, Profile::Flat),
            Surface::Cylinder {
                origin,
                axis,
                radius,
            } => (origin, axis, Profile::Wall(radius)),
            Surface::Cone {
                apex,
                axis,
                half_angle,
            } => {
                let (sine, cosine) = half_angle.sin_cos();
                (apex, axis, Profile::Ray(sine, cosine))
            }
            Surface::Sphere { centre, radius } => (
                centre,
                north.unwrap_or([0.0, 0.0, 1.0]),
                Profile::Ball(radius),
            ),
            Surface::Torus {
                centre,
                axis,
                major,
                minor,
            } => (centre, axis, Profile::Tube(major, minor)),
            Surface::Other(_) => return None,
        };
        let mut e = frame(axis, 0.0);
        if let (Profile::Flat, Some(north)) = (profile, north) {
            e = [cross(north, axis), north];
        }
        Some(Sheet {
            origin,
            axis,
            e,
            profile,
        })
    }

    /// u is an angle.
    pub fn is_round(&self) -> bool {
        self.profile != Profile::Flat
    }

    /// v is an angle without ends.
    pub fn is_tube(&self) -> bool {
        matches!(self.profile, Profile::Tube(..))
    }

    /// Planes may cross a line u = constant more than once on it.
    pub fn is_ball(&self) -> bool {
        matches!(self.profile, Profile::Ball(_))
    }

    /// The ends of v.
    pub fn reach(&self) -> [f64; 2] {
        match self.profile {
            Profile::Ball(_) => [-FRAC_PI_2, FRAC_PI_2],
            Profile::Ray(..) => [0.0, f64::INFINITY],
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// The coordinates of a point of the surface.
    pub fn coordinates(&self, p: Vector) -> [f64; 2] {
        let from = minus(p, self.origin);
        let [x, y] = self.e.map(|e| dot(from, e));
        if self.profile == Profile::Flat {
            return [x, y];
        }
        let (out, up) = (x.hypot(y), dot(from, self.axis));
        let v = match self.profile {
            Profile::Ray(sine, cosine) => out * sine + up * cosine,
            Profile::Ball(_) => up.atan2(out),
            Profile::Tube(major, _) => up.atan2(out - major),
            _ => up,
        };
        [positive_angle(y.atan2(x)), v]
    }

    /// The point of two coordinates.
    pub fn point(&self, u: f64, v: f64) -> Vector {
        if self.profile == Profile::Flat {
            return along(along(self.origin, u, self.e[0]), v, self.e[1]);
        }
        let (out, up) = self.meridian(v);
        along(along(self.origin, out, self.radial(u)), up, self.axis)
    }

    /// Distance from the axis, and height along it.
    pub fn meridian(&self, v: f64) -> (f64, f64) {
        match self.profile {
            Profile::Flat => (0.0, 0.0),
            Profile::Wall(radius) => (radius, v),
            Profile::Ray(sine, cosine) => (v * sine, v * cosine),
            Profile::Ball(radius) => (radius * v.cos(), radius * v.sin()),
            Profile::Tube(major, minor) => (major + minor * v.cos(), minor * v.sin()),
        }
    }

    /// The point of the axis at a height.
    pub fn on_axis(&self, height: f64) -> Vector {
        along(self.origin, height, self.axis)
    }

    fn radial(&self, u: f64) -> Vector {
        let (sine, cosine) = u.sin_cos();
        plus(times(cosine, self.e[0]), times(sine, self.e[1]))
    }

    /// The plane of the line u, with its normal eastwards.
    pub fn meridian_plane(&self, u: f64, planes: &mut Planes) -> usize {
        match self.profile {
            Profile::Flat => planes.find_or_add(along(self.origin, u, self.e[0]), self.e[0]),
            _ => planes.find_or_add(self.origin, cross(self.axis, self.radial(u))),
        }
    }

    /// The plane of the line v, with its normal northwards.
    pub fn parallel_plane(&self, v: f64, planes: &mut Planes) -> usize {
        match self.profile {
            Profile::Flat => planes.find_or_add(along(self.origin, v, self.e[1]), self.e[1]),
            _ => self.level_plane(self.meridian(v).1, planes),
        }
    }

    /// The plane across the axis at a height, with its normal along the axis.
    pub fn level_plane(&self, height: f64, planes: &mut Planes) -> usize {
        planes.find_or_add(along(self.origin, height, self.axis), self.axis)
    }

    /// The cone, cylinder or nothing that joins the circles of two parallels, and that is nothing if both are in one
    /// plane.
    pub fn chord(&self, low: f64, high: f64) -> Option<Surface> {
        let [(out, up), (other, higher)] = [self.meridian(low), self.meridian(high)];
        let (rise, spread) = (higher - up, other - out);
        let size = length([rise, spread, 0.0]);
        let foot = along(self.origin, up, self.axis);
        if spread.abs() <= 1e-3 * size {
            return Some(Surface::Cylinder {
                origin: self.origin,
                axis: self.axis,
                radius: 0.5 * (out + other),
            });
        }
        if rise.abs() <= 1e-3 * size {
            return None;
        }
        // From the apex, where the distance from the axis is 0, towards the wider circle.
        let widening = if (spread > 0.0) == (rise > 0.0) {
            1.0
        } else {
            -1.0
        };
        Some(Surface::Cone {
            apex: along(foot, -out * rise / spread, self.axis),
            axis: times(widening, self.axis),
            half_angle: (spread / rise).abs().atan(),
        })
    }

    /// All v at which the line u crosses a separator that may cross it twice: a conic of a plane, a plane of a sphere.
    pub fn crossings(&self, u: f64, separator: &Separator) -> Vec<f64> {
        match (self.profile, separator) {
            (Profile::Flat, Separator::Quadric(implicit)) => {
                let [a, b, c] = implicit.on_line(self.point(u, 0.0), self.e[1]);
                quadratic(a, b, c)
            }
            (Profile::Ball(radius), Separator::Plane { normal, offset }) => {
                let rest = (offset - dot(*normal, self.origin)) / radius;
                let [out, up] = [self.radial(u), self.axis].map(|d| dot(*normal, d));
                let turned = |v: f64| if v > PI { v - TAU } else { v };
                let all = harmonic(out, up, rest).into_iter().map(turned);
                all.filter(|v| v.abs() < FRAC_PI_2).collect()
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
                let near =
                    |value: f64, before: f64| before + (value - before + PI).rem_euclid(TAU) - PI;
                if self.is_round() {
                    next[0] = near(next[0], last[0]);
                }
                if self.is_tube() {
                    next[1] = near(next[1], last[1]);
                }
            }
            path.push(next);
        }
        self.settle_poles(&mut path, points);
        path
    }

    /// A point of the axis has every u: that of its neighbour is taken.
    fn settle_poles(&self, path: &mut [[f64; 2]], points: &[Vector]) {
        if !self.is_round() || path.len() < 2 {
            return;
        }
        let on_axis = |p: Vector| {
            let from = minus(p, self.origin);
            let out = dot(from, self.e[0]).hypot(dot(from, self.e[1]));
            out <= 1e-9 * length(from).max(1e-3)
        };
        let last = path.len() - 1;
        if on_axis(points[0]) {
            path[0][0] = path[1][0];
        }
        if on_axis(points[last]) {
            path[last][0] = path[last - 1][0];
        }
    }
}
