//! How far an object reaches in a direction, in floating point.
//!
//! A cut quadric reaches farthest where a plane across the direction touches the quadric, or touches its section with
//! a cut, or at a corner: where two cuts meet the quadric, or three cuts meet. All these points are found; those that
//! another cut removes are left out.

use super::frame::cut_quadric;
use super::object::Object;
use super::shape::{Shape, Surface};
use super::transform::{Transform, WholeTransform};
use imogene_algebra::rational::{from_decimal, to_f64};
use imogene_algebra::vector::{cross, dot, length, normalised};
use imogene_algebra::whole::{greatest, scaled};

type Vector = [f64; 3];

/// A point counts as within a cut, and on a quadric, if it is off by so much of its size.
const TOLERANCE: f64 = 1e-6;
/// A matrix whose determinant is less, in relation to its entries, has no inverse.
const SINGULAR: f64 = 1e-9;
/// What is added to such a matrix: the quadric then closes far away and is the same nearby.
const CLOSING: f64 = 1e-8;

/// An object, for the question how far it reaches.
#[derive(Clone, Debug)]
pub enum Body {
    /// The image of the unit ball: its middle, and the images of its axes.
    Ball(Vector, [Vector; 3]),
    /// The hull of points.
    Points(Vec<Vector>),
    /// A quadric with cuts.
    Cut(Box<CutBody>),
}

/// A quadric with cuts and the sides of a great box.
#[derive(Clone, Debug)]
pub struct CutBody {
    /// The factors of the squares and products, of the coordinates, and the constant.
    square: [Vector; 3],
    linear: Vector,
    constant: f64,
    planes: Vec<(Vector, f64)>,
    /// How far a point may be beyond a plane, at least.
    spare: f64,
    corners: Vec<Vector>,
}

impl Body {
    /// A sphere.
    pub fn ball(middle: Vector, radius: f64) -> Body {
        let unit = |axis: usize| std::array::from_fn(|k| if k == axis { radius } else { 0.0 });
        Body::Ball(middle, [unit(0), unit(1), unit(2)])
    }

    /// A flattened scene's object, seen from a point, and what of it lies within `size` of that point in each
    /// coordinate.
    pub fn of(object: &Object, from: Vector, size: f64) -> Body {
        let moved = Transform::translation(from.map(|v| -from_decimal(v)));
        let placed = || {
            let place = moved.after(&Transform::placement(&object.place));
            let rows = place.rows.each_ref().map(|row| row.each_ref().map(to_f64));
            move |[x, y, z]: Vector, w: f64| -> Vector {
                std::array::from_fn(|k| {
                    let [a, b, c, d] = rows[k];
                    a * x + b * y + c * z + d * w
                })
            }
        };
        let ball = |[a, b, c]: Vector| {
            let place = placed();
            let axes = [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]];
            Body::Ball(place([0.0; 3], 1.0), axes.map(|axis| place(axis, 0.0)))
        };
        match &object.shape {
            Shape::Mesh(mesh) => {
                let place = placed();
                Body::Points(mesh.vertices.iter().map(|v| place(*v, 1.0)).collect())
            }
            Shape::Sphere { radius } if object.cuts.is_empty() => ball([*radius; 3]),
            Shape::Ellipsoid(radii) if object.cuts.is_empty() => ball(*radii),
            _ => Body::Cut(Box::new(CutBody::of(object, &moved, size))),
        }
    }

    /// The greatest scalar product of its points with a direction; minus infinity if it has no point.
    pub fn reach(&self, along: Vector) -> f64 {
        match self {
            Body::Ball(middle, axes) => {
                let parts = axes.map(|axis| dot(axis, along));
                dot(*middle, along) + length(parts)
            }
            Body::Points(points) => farthest(points.iter().copied(), along),
            Body::Cut(body) => body.reach(along),
        }
    }
}

fn farthest(points: impl Iterator<Item = Vector>, along: Vector) -> f64 {
    let reaches = points.map(|point| dot(point, along));
    reaches.fold(f64::NEG_INFINITY, f64::max)
}

fn plus(a: Vector, factor: f64, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] + factor * b[k])
}

impl CutBody {
    fn of(object: &Object, moved: &Transform, size: f64) -> CutBody {
        let exact = cut_quadric(object, 0, &WholeTransform::new(moved));
        let [a, b, c, d, e, f, g, h, i, j] = scaled(exact.quadric.coefficients());
        let cuts = exact.planes.iter().map(|plane| {
            let most = greatest([&plane.a, &plane.b, &plane.c]);
            let [a, b, c, d] = plane.coefficients().map(|v| to_f64(&(v / &most)));
            let length = length([a, b, c]);
            ([a, b, c].map(|v| v / length), d / length)
        });
        let sides = (0..6).map(|side| {
            let normal = |k: usize| f64::from(u8::from(k == side / 2)) * [1.0, -1.0][side % 2];
            (std::array::from_fn(normal), -size)
        });
        let mut body = CutBody {
            square: [[a, d, e], [d, b, f], [e, f, c]],
            linear: [g, h, i],
            constant: j,
            planes: cuts.chain(sides).collect(),
            spare: size * SINGULAR,
            corners: vec![],
        };
        body.corners = body.all_corners(exact.surface == Surface::Solid);
        body
    }

    fn reach(&self, along: Vector) -> f64 {
        let sections = self.planes.iter();
        let touched = sections.flat_map(|plane| self.touched_in(*plane, along));
        let touched = touched.chain(self.touched(along)).flatten();
        let seen = touched.filter(|point| self.is_on(*point) && self.is_kept(*point));
        farthest(self.corners.iter().copied().chain(seen), along)
    }

    fn image(&self, point: Vector) -> Vector {
        self.square.map(|row| dot(row, point))
    }

    /// The quadric's value at a point, and how great its terms are.
    fn value(&self, point: Vector) -> (f64, f64) {
        let size = |v: Vector| v.map(f64::abs);
        let sizes = self.square.map(|row| dot(size(row), size(point)));
        let terms = dot(sizes, size(point)) + 2.0 * dot(size(self.linear), size(point));
        let value = dot(plus(self.image(point), 2.0, self.linear), point) + self.constant;
        (value, terms + self.constant.abs())
    }

    fn is_on(&self, point: Vector) -> bool {
        let (value, size) = self.value(point);
        value.abs() <= TOLERANCE * size
    }

    fn is_kept(&self, point: Vector) -> bool {
        let spare = self.spare + TOLERANCE * length(point);
        let mut planes = self.planes.iter();
        planes.all(|(normal, d)| dot(*normal, point) + d <= spare)
    }

    /// Where two planes meet the quadric, and of a solid also where three planes meet within it.
    fn all_corners(&self, is_solid: bool) -> Vec<Vector> {
        let mut corners = vec![];
        for (i, (n, d)) in self.planes.iter().enumerate() {
            for (j, (m, e)) in self.planes[..i].iter().enumerate() {
                let across = cross(*n, *m);
                let length = dot(across, across);
                if length < SINGULAR {
                    continue;
                }
                let from = plus([0.0; 3], -d / length, cross(*m, across));
                let from = plus(from, -e / length, cross(across, *n));
                let roots = self.on_line(from, across).into_iter().flatten();
                corners.extend(roots.filter(|point| self.is_on(*point)));
                let others = self.planes[..j].iter().filter(|_| is_solid);
                let meeting = others.filter_map(|(o, f)| {
                    let slope = dot(*o, across);
                    let at = -(dot(*o, from) + f) / slope;
                    (slope.abs() > SINGULAR).then(|| plus(from, at, across))
                });
                corners.extend(meeting.filter(|point| {
                    let (value, size) = self.value(*point);
                    value <= TOLERANCE * size
                }));
            }
        }
        corners.retain(|point| self.is_kept(*point));
        corners
    }

    /// Where a line meets the quadric.
    fn on_line(&self, from: Vector, along: Vector) -> Option<[Vector; 2]> {
        let image = self.image(along);
        let a = dot(image, along);
        let b = dot(image, from) + dot(self.linear, along);
        let (c, _) = self.value(from);
        let root = (b * b - a * c).max(0.0).sqrt();
        // Without cancellation, and also where a is 0.
        let sum = -b - root.copysign(b);
        let points = [c / sum, sum / a].map(|at| plus(from, at, along));
        (sum != 0.0).then_some(points)
    }

    /// Where planes across a direction touch the quadric.
    fn touched(&self, along: Vector) -> Option<[Vector; 2]> {
        let [mut x, mut y, mut z] = self.square;
        let entries = [x, y, z].into_iter().flatten();
        let size = entries.fold(0.0, |most: f64, v| most.max(v.abs()));
        if dot(x, cross(y, z)).abs() < SINGULAR * size.powi(3) {
            (x[0], y[1], z[2]) = (x[0] + CLOSING, y[1] + CLOSING, z[2] + CLOSING);
        }
        let inverse = [cross(y, z), cross(z, x), cross(x, y)];
        let volume = dot(x, inverse[0]);
        // The matrix is symmetric, and so is its inverse.
        let solved = |v: Vector| inverse.map(|row| dot(row, v) / volume);
        let middle = solved(self.linear.map(|v| -v));
        let rest = dot(self.linear, middle) + self.constant;
        let towards = solved(along);
        let factor = (-rest / dot(along, towards)).max(0.0).sqrt();
        (size > 0.0).then(|| [factor, -factor].map(|f| plus(middle, f, towards)))
    }

    /// Where planes across a direction touch the section of the quadric with a plane.
    fn touched_in(&self, (normal, d): (Vector, f64), along: Vector) -> Option<[Vector; 2]> {
        let least = (0..3).min_by(|a, b| normal[*a].abs().total_cmp(&normal[*b].abs()))?;
        let axis: Vector = std::array::from_fn(|k| f64::from(u8::from(k == least)));
        let u = normalised(cross(normal, axis));
        let v = cross(normal, u);
        let origin = normal.map(|part| -d * part);
        let (image, other) = (self.image(u), self.image(v));
        let (mut a, h, mut c) = (dot(image, u), dot(image, v), dot(other, v));
        let size = a.abs().max(h.abs()).max(c.abs());
        if (a * c - h * h).abs() < SINGULAR * size * size {
            (a, c) = (a + CLOSING * size, c + CLOSING * size);
        }
        let area = a * c - h * h;
        let solved = |[p, q]: [f64; 2]| [(c * p - h * q) / area, (a * q - h * p) / area];
        let slope = plus(self.image(origin), 1.0, self.linear);
        let [g, k] = [dot(slope, u), dot(slope, v)];
        let [x, y] = solved([-g, -k]);
        let rest = g * x + k * y + self.value(origin).0;
        let [p, q] = match [dot(along, u), dot(along, v)] {
            // The plane itself lies across: all its points reach as far.
            [p, q] if p.hypot(q) < SINGULAR => [1.0, 0.0],
            other => other,
        };
        let [s, t] = solved([p, q]);
        let factor = (-rest / (p * s + q * t)).max(0.0).sqrt();
        let at = |f: f64| plus(plus(origin, x + f * s, u), y + f * t, v);
        (size > 0.0).then(|| [at(factor), at(-factor)])
    }
}
