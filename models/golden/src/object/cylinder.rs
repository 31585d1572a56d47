//! The cylinder processor of the first machine: body and front disc in one exact outline, a parabolic body (source:
//! Chaillou, IV.2.5).

use super::paraboloid::*;
use super::screen_box::ScreenBox;
use super::words::{Expression, Object, ObjectPixel, Parts, Words};
use crate::format::Format;
use crate::unit::depth_interval::{FACE_NEAR, FACE_PLANE};
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use imogene_algebra::rational::{integer, round_half_up};
use num_rational::BigRational;
use num_traits::ToPrimitive;
use serde::{Deserialize, Serialize};

/// A cylinder of an orthographic view, neither end-on nor side-on.
///
/// Its unit axis, from the front disc to the back, is `(level cos, level sin, deep)` with cos^2 + sin^2 = 1 and
/// level^2 + deep^2 = 1, all rational, level and deep positive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CylinderShape {
    /// Centre of the front disc: column, line, depth in pixels.
    pub centre: [BigRational; 3],
    /// Direction of the axis on the screen: cosine and sine.
    pub direction: [BigRational; 2],
    /// Part of the unit axis in the screen plane.
    pub level: BigRational,
    /// Part of the unit axis away from the viewer.
    pub deep: BigRational,
    /// Radius in pixels, positive.
    pub radius: BigRational,
    /// Length in pixels, positive.
    pub length: BigRational,
    /// Depth words per pixel, positive.
    pub scale: BigRational,
}

/// All coefficient words of one cylinder for one zone.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct CylinderWords {
    /// Where the cylinder can be on the screen.
    pub screen_box: ScreenBox,
    /// Sides of the rectangle between the discs, P bits, not negative inside.
    pub sides: [Linear; 4],
    /// Outlines of the front and the back disc, F bits, not negative inside.
    pub discs: [Quadratic; 2],
    /// Depth of the body, in units of `2^-(W-2)` depth words.
    pub body: Quadratic,
    /// Normal of the body, F bits.
    pub normal: [Quadratic; 3],
    /// Depth of the front disc, in units of `2^-10` depth words.
    pub disc: Linear,
    /// Normal of the front disc.
    pub disc_normal: [i16; 3],
}

/// `p x + q y + r`.
type Affine = [BigRational; 3];

/// `factor p + constant`.
fn affine(factor: &BigRational, [a, b, c]: &Affine, constant: BigRational) -> Affine {
    [factor * a, factor * b, factor * c + constant]
}

/// `factor p^2 + q` as an expression of degree two.
fn square_and(factor: &BigRational, p: &Affine, q: &Affine) -> Exact {
    let two = integer(2) * factor;
    [
        factor * &p[0] * &p[0],
        factor * &p[1] * &p[1],
        &two * &p[0] * &p[1],
        &two * &p[0] * &p[2] + &q[0],
        &two * &p[1] * &p[2] + &q[1],
        factor * &p[2] * &p[2] + &q[2],
    ]
}

fn plus(mut sum: Exact, other: &Exact) -> Exact {
    for (total, term) in sum.iter_mut().zip(other) {
        *total += term;
    }
    sum
}

impl CylinderShape {
    /// Pixels along the axis on the screen from the centre of the front disc.
    fn along(&self) -> Affine {
        let [cos, sin] = &self.direction;
        let offset = -(cos * &self.centre[0] + sin * &self.centre[1]);
        [cos.clone(), sin.clone(), offset]
    }

    /// Pixels across the axis.
    fn across(&self) -> Affine {
        let [cos, sin] = &self.direction;
        let offset = sin * &self.centre[0] - cos * &self.centre[1];
        [-sin, cos.clone(), offset]
    }

    /// The half height of the parabolic body, `a R - b t^2 / R`, times a factor, plus a first-degree rest.
    fn bulge_and(&self, factor: &BigRational, rest: &Affine) -> Exact {
        let (a, b) = bulge();
        let mut rest = rest.clone();
        rest[2] += a * &self.radius * factor;
        square_and(&(-b * factor / &self.radius), &self.across(), &rest)
    }

    /// The parabolic body's front depth in depth words.
    pub fn body(&self) -> Exact {
        let slope = &self.scale * &self.deep / &self.level;
        let middle = &self.scale * &self.centre[2];
        let axis = affine(&slope, &self.along(), middle);
        self.bulge_and(&(-&self.scale / &self.level), &axis)
    }

    /// `R^2 deep^2 - deep^2 t^2 - (a - shift)^2`.
    fn ellipse(&self, shift: BigRational) -> Exact {
        let mut along = self.along();
        along[2] -= shift;
        let square = &self.deep * &self.deep;
        let none = [0, 0, 0].map(integer);
        let mut constant = none.clone();
        constant[2] = &square * &self.radius * &self.radius;
        let across = square_and(&-square, &self.across(), &constant);
        plus(across, &square_and(&integer(-1), &along, &none))
    }

    /// Sides of the rectangle between the discs' centres, not negative inside.
    pub fn sides(&self) -> [[BigRational; 3]; 4] {
        let (one, minus) = (integer(1), integer(-1));
        let (a, t) = (self.along(), self.across());
        let end = &self.length * &self.level;
        [
            affine(&one, &a, integer(0)),
            affine(&minus, &a, end),
            affine(&one, &t, self.radius.clone()),
            affine(&minus, &t, self.radius.clone()),
        ]
    }

    /// Outlines of the front and the back disc, not negative inside.
    pub fn discs(&self) -> [Exact; 2] {
        [integer(0), &self.length * &self.level].map(|shift| self.ellipse(shift))
    }

    /// Normal of the body, outward, of length [`NORMAL_LENGTH`] where it is exact: t across the axis, and the bulge
    /// times (deep cos, deep sin, -level).
    pub fn body_normal(&self) -> [Exact; 3] {
        let [cos, sin] = &self.direction;
        let per_radius = integer(NORMAL_LENGTH) / &self.radius;
        let normal = |across: BigRational, bulge: BigRational| {
            let rest = affine(&across, &self.across(), integer(0));
            self.bulge_and(&bulge, &rest)
        };
        [
            normal(-sin * &per_radius, &self.deep * cos * &per_radius),
            normal(cos * &per_radius, &self.deep * sin * &per_radius),
            normal(integer(0), -&self.level * &per_radius),
        ]
    }

    /// Depth of the front disc in depth words.
    pub fn disc(&self) -> [BigRational; 3] {
        let slope = -&self.scale * &self.level / &self.deep;
        let middle = &self.scale * &self.centre[2];
        affine(&slope, &self.along(), middle)
    }

    /// Normal of the front disc.
    pub fn disc_normal(&self) -> [i16; 3] {
        let [cos, sin] = &self.direction;
        let component = |v: BigRational| {
            let rounded = round_half_up(&(-v * integer(NORMAL_LENGTH))).to_i16();
            rounded.expect("a unit vector's component")
        };
        [&self.level * cos, &self.level * sin, self.deep.clone()].map(component)
    }

    /// The coefficient words.
    pub fn words(&self, screen_box: ScreenBox, format: &Format) -> CylinderWords {
        let conic = |exact: &Exact| Quadratic::new(contour(exact));
        let side = |exact: &Affine| {
            let [a, b, c] = contour(exact);
            Linear::new(a, b, c)
        };
        let normal = |exact: &Exact| second_degree(exact, normal_guard(format));
        CylinderWords {
            screen_box,
            sides: self.sides().each_ref().map(side),
            discs: self.discs().each_ref().map(conic),
            body: second_degree(&self.body(), depth_guard(format)),
            normal: self.body_normal().each_ref().map(normal),
            disc: first_degree(&self.disc(), plane_guard(format)),
            disc_normal: self.disc_normal(),
        }
    }
}

impl Words for CylinderWords {
    fn screen_box(&self) -> &ScreenBox {
        &self.screen_box
    }

    fn parts_mut(&mut self) -> Parts<'_> {
        let first = self.sides.iter_mut().chain([&mut self.disc]);
        let second = self.discs.iter_mut().chain([&mut self.body]);
        let second = second.chain(&mut self.normal).map(Expression::Second);
        let all = first.map(Expression::First).chain(second);
        (vec![&mut self.screen_box], all.collect())
    }
}

/// Latency in clocks from the raster flags to the outputs: processors, selection of the part, ends of the depth word.
pub const LATENCY: u32 = 3;
/// Number of the front disc among the faces.
pub const FACE_DISC: u8 = FACE_PLANE;

impl Object for CylinderWords {
    /// Front and back depth are the same, that of the visible part.
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel {
        let linear = |l: &Linear| l.wrapped_at(x, y, format.plane);
        let quadratic = |q: &Quadratic| q.wrapped_at(x, y, format.quadratic);
        let [front, back] = self.discs.each_ref().map(|disc| quadratic(disc) >= 0);
        let between = || self.sides.iter().all(|side| linear(side) >= 0);
        let there = self.screen_box.contains(x, y) && (front || back || between());
        let (z, number) = match front {
            true => (linear(&self.disc) >> plane_guard(format), FACE_DISC),
            false => (quadratic(&self.body) >> depth_guard(format), FACE_NEAR),
        };
        let face = one_face(z as i64, number, there, format);
        let component = |n: &Quadratic| (quadratic(n) >> normal_guard(format)) as i16;
        let normal = || match front {
            true => self.disc_normal,
            false => self.normal.each_ref().map(component),
        };
        ObjectPixel::of(face, normal, format)
    }
}
