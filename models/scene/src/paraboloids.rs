//! Spheres and circular cylinders of an orthographic view, for the processors that draw them by paraboloids.
//!
//! A length that no fraction holds is cut once after 64 significant bits, an angle is computed once in `f64`, and both
//! are exact from then on, as the entries of a rotation are; a direction becomes a rational point of the unit circle by
//! the tangent of its half angle. The object *is* the exact sphere or cylinder with these numbers.

use super::error::SceneError;
use super::quadric::{FramedQuadric, Plane, Quadric};
use super::shape::Surface;
use super::transform::Transform;
use imogene_algebra::rational::{from_decimal, from_f64_exact, integer};
use imogene_algebra::vector::{dot, minus, square};
use imogene_algebra::whole::scaled;
use num_rational::BigRational;
use num_traits::Signed;

/// Greatest relative difference of lengths, and greatest cosine between directions, that count as the rounding of
/// rotations.
const ROUNDING: f64 = 1e-9;
/// Least part of the unit axis in and across the screen plane: a cylinder nearer to end-on or side-on has no
/// expressions.
const LEAST_PART: f64 = 1e-6;

type Vector = [BigRational; 3];

/// A sphere in the camera frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FramedSphere {
    /// Unique name.
    pub name: String,
    /// Index of the material.
    pub material: usize,
    /// Centre.
    pub centre: Vector,
    /// Radius, positive.
    pub radius: BigRational,
}

/// A circular cylinder between two discs across its axis, in the camera frame.
///
/// Its unit axis, from the front disc to the back, is `(level cos, level sin, deep)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FramedCylinder {
    /// Unique name.
    pub name: String,
    /// Index of the material.
    pub material: usize,
    /// Centre of the front disc.
    pub centre: Vector,
    /// Direction of the axis on the screen: cosine and sine, exactly on the unit circle.
    pub direction: [BigRational; 2],
    /// Part of the unit axis in the screen plane, positive.
    pub level: BigRational,
    /// Part of the unit axis away from the viewer, positive; exactly on the unit circle with `level`.
    pub deep: BigRational,
    /// Radius, positive.
    pub radius: BigRational,
    /// Length, positive.
    pub length: BigRational,
}

pub(super) fn keeps_spheres(place: &Transform) -> bool {
    let [x, y, z] = place.columns();
    alike(&x, &y) && alike(&x, &z) && across(&x, &y) && across(&x, &z) && across(&y, &z)
}

/// True if a placement turns the elliptic cylinder of these radii along y, with ends across it, into a right circular
/// one.
pub(super) fn makes_circular_cylinder(place: &Transform, radii: [f64; 2]) -> bool {
    let [x, y, z] = place.columns();
    let [a, c] = [(x, radii[0]), (z, radii[1])].map(|(v, r)| v.map(|part| part * from_decimal(r)));
    alike(&a, &c) && across(&a, &c) && across(&a, &y) && across(&c, &y)
}

impl FramedSphere {
    pub(super) fn new(
        name: &str,
        material: usize,
        radius: f64,
        to_camera: &Transform,
    ) -> FramedSphere {
        let [x, y, z] = to_camera.columns().map(|v| square(&v));
        FramedSphere {
            name: name.to_owned(),
            material,
            centre: to_camera.point(&Default::default()),
            radius: from_decimal(radius) * root(&((x + y + z) / integer(3))),
        }
    }

    /// The sphere itself.
    pub fn cut_quadric(&self, surface: Surface) -> FramedQuadric {
        let [x, y, z] = &self.centre;
        let constant = square(&self.centre) - &self.radius * &self.radius;
        let mut quadric = Quadric::diagonal([1, 1, 1].map(integer), constant);
        (quadric.g, quadric.h, quadric.i) = (-x, -y, -z);
        FramedQuadric {
            name: self.name.clone(),
            surface,
            quadric: quadric.primitive(),
            planes: vec![],
            material: self.material,
            casts_shadow: false,
        }
    }
}

impl FramedCylinder {
    /// The image of an elliptic cylinder of `radii` that [`makes_circular_cylinder`], between the local heights `ends`.
    pub(super) fn new(
        name: &str,
        material: usize,
        radii: [f64; 2],
        ends: [BigRational; 2],
        to_camera: &Transform,
    ) -> Result<FramedCylinder, SceneError> {
        let disc = |height| to_camera.point(&[integer(0), height, integer(0)]);
        let [mut front, mut back] = ends.map(disc);
        if front[2] > back[2] {
            std::mem::swap(&mut front, &mut back);
        }
        let axis = minus(&back, &front);
        let [x, y, z] = scaled(axis.each_ref());
        let (level, length) = (x.hypot(y), x.hypot(y).hypot(z));
        let least = LEAST_PART * length;
        if level < least || z < least {
            let seen = if level < least { "end-on" } else { "side-on" };
            return Err(SceneError::value(
                format!("object `{name}`, processor"),
                format!(
                    "the cylinder is seen {seen}, which the processor \"paraboloid\" has no expressions for"
                ),
                "turn it or the camera, or draw it by the processor \"quadric\"",
            ));
        }
        let [cos, sin] = on_unit_circle(x, y);
        let [level, deep] = on_unit_circle(level, z);
        let [across, _, other] = to_camera.columns();
        let [a, c] = radii.map(|r| from_decimal(r).pow(2));
        let radius = square(&across) * a + square(&other) * c;
        Ok(FramedCylinder {
            name: name.to_owned(),
            material,
            centre: front,
            direction: [cos, sin],
            level,
            deep,
            radius: root(&(radius / integer(2))),
            length: root(&square(&axis)),
        })
    }

    /// The unit axis.
    pub fn axis(&self) -> Vector {
        let [cos, sin] = &self.direction;
        [&self.level * cos, &self.level * sin, self.deep.clone()]
    }

    /// The cylinder itself: `|p|^2 - (p . axis)^2 - radius^2` from the centre of the front disc, and the planes of the
    /// front and the back disc.
    pub fn cut_quadric(&self) -> FramedQuadric {
        let (c, u) = (&self.centre, self.axis());
        let along: BigRational = dot(c, &u);
        let entry = |i: usize, j: usize| integer(i64::from(i == j)) - &u[i] * &u[j];
        // M c for the matrix of the second-degree terms: c - u (u . c).
        let [g, h, i]: Vector = std::array::from_fn(|k| &u[k] * &along - &c[k]);
        let constant = square(c) - &along * &along - &self.radius * &self.radius;
        let [a, b, c] = [0, 1, 2].map(|k| entry(k, k));
        let [d, e, f] = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| entry(i, j));
        let quadric = Quadric::from_array([a, b, c, d, e, f, g, h, i, constant]);
        let plane = |sign: i64, d: BigRational| {
            let [a, b, c] = u.each_ref().map(|v| v * integer(sign));
            Plane { a, b, c, d }.primitive()
        };
        FramedQuadric {
            name: self.name.clone(),
            surface: Surface::Solid,
            quadric: quadric.primitive(),
            planes: vec![plane(-1, along.clone()), plane(1, -&along - &self.length)],
            material: self.material,
            casts_shadow: false,
        }
    }
}

/// Of the same length.
fn alike(u: &Vector, v: &Vector) -> bool {
    let (one, other) = (square(u), square(v));
    (&one - other).abs() <= one * from_f64_exact(ROUNDING)
}

/// At right angles.
fn across(u: &Vector, v: &Vector) -> bool {
    let bound = from_f64_exact(ROUNDING * ROUNDING);
    dot(u, v).pow(2) <= square(u) * square(v) * bound
}

/// The square root, exact where it is a fraction, else cut after at least 64 significant bits.
pub fn root(value: &BigRational) -> BigRational {
    // sqrt(n / d) = sqrt(n d) / d.
    let product = value.numer() * value.denom();
    let whole = product.sqrt();
    if &whole * &whole == product {
        return BigRational::new(whole, value.denom().clone());
    }
    let shift = 128u64.saturating_sub(product.bits()).div_ceil(2);
    BigRational::new((product << (2 * shift)).sqrt(), value.denom() << shift)
}

/// The direction (x, y) as a rational point of the unit circle: cosine and sine from the tangent of half its angle.
pub fn on_unit_circle(x: f64, y: f64) -> [BigRational; 2] {
    // Half the angle to the nearer end of the x axis, so that the tangent is at most 1.
    let t = from_f64_exact(y / (x.hypot(y) + x.abs()));
    let square = &t * &t;
    let below = integer(1) + &square;
    let cos = (integer(1) - square) / &below;
    let sin = integer(2) * t / below;
    [if x < 0.0 { -cos } else { cos }, sin]
}
