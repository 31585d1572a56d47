//! From a quadric or a plane in the camera frame to its expressions on the screen (source: 2.1.1, 2.3.1; factors of Exp. 7 and
//! root order corrected).

use super::forms::{LinearForm, QuadraticForm};
use crate::rational::integer;
use crate::scene::{Plane, Projection, Quadric};
use num_rational::BigRational;
use num_traits::Zero;

/// 1/D, or zero for an orthographic view: the one number in which the two projections differ.
pub fn inverse_distance(projection: &Projection) -> BigRational {
    match projection {
        Projection::Perspective { distance } => distance.recip(),
        Projection::Orthographic { .. } => BigRational::zero(),
    }
}

/// The depth (in pixels) that fills the depth word: the viewer distance, or the stated half depth.
pub fn full_depth(projection: &Projection) -> BigRational {
    match projection {
        Projection::Perspective { distance } => distance.clone(),
        Projection::Orthographic { half_depth } => half_depth.clone(),
    }
}

/// A quadric after perspective, `a x^2 + b y^2 + c z^2 + 2d xy + 2e xz + 2f yz + 2g x + 2h y + 2i z + j` in screen x, y and depth z_p.
#[derive(Clone, Debug)]
pub struct ScreenQuadric {
    /// The transformed coefficients.
    pub q: Quadric,
    inverse_distance: BigRational,
}

/// A plane after perspective, kept where `a x + b y + c z + d <= 0`.
pub fn project_plane(plane: &Plane, inverse_distance: &BigRational) -> Plane {
    Plane {
        c: &plane.c - &plane.d * inverse_distance,
        ..plane.clone()
    }
}

impl ScreenQuadric {
    /// Transforms a quadric of the camera frame.
    pub fn new(quadric: &Quadric, inverse_distance: &BigRational) -> ScreenQuadric {
        let (o, k) = (quadric, inverse_distance);
        let q = Quadric {
            e: &o.e - &o.g * k,
            f: &o.f - &o.h * k,
            i: &o.i - &o.j * k,
            c: &o.c - integer(2) * &o.i * k + &o.j * k * k,
            ..o.clone()
        };
        ScreenQuadric {
            q,
            inverse_distance: k.clone(),
        }
    }

    /// Factor of z^2; its sign is that of the quadric at the eye: positive outside, negative inside.
    pub fn eye_value(&self) -> &BigRational {
        &self.q.c
    }

    /// True if the depth appears in no term.
    pub fn is_free_of_depth(&self) -> bool {
        self.q.c.is_zero() && self.polar().is_zero_everywhere()
    }

    /// e x + f y + i, half the factor of z.
    fn polar(&self) -> LinearForm {
        LinearForm::new(self.q.e.clone(), self.q.f.clone(), self.q.i.clone())
    }

    /// The terms without z.
    pub fn depth_free_part(&self) -> QuadraticForm {
        let (q, two) = (&self.q, integer(2));
        QuadraticForm {
            a: q.a.clone(),
            b: q.b.clone(),
            c: &two * &q.d,
            d: &two * &q.g,
            e: &two * &q.h,
            f: q.j.clone(),
        }
    }

    /// f1: depth on the polar plane of the viewing direction. The factor of z^2 must not be zero.
    pub fn f1(&self) -> LinearForm {
        self.polar().scaled(&-self.q.c.recip())
    }

    /// f2: the depths are f1 -+ sqrt(f2). The factor of z^2 must not be zero.
    pub fn f2(&self) -> QuadraticForm {
        let (q, two) = (&self.q, integer(2));
        QuadraticForm {
            a: &q.e * &q.e - &q.a * &q.c,
            b: &q.f * &q.f - &q.b * &q.c,
            c: &two * (&q.e * &q.f - &q.d * &q.c),
            d: &two * (&q.e * &q.i - &q.g * &q.c),
            e: &two * (&q.f * &q.i - &q.h * &q.c),
            f: &q.i * &q.i - &q.j * &q.c,
        }
        .scaled(&(&q.c * &q.c).recip())
    }

    /// Half the outward normal *before* perspective, as `linear(x, y) + factor * z_p`, each component times the positive (D - z_p)/D.
    pub fn normal(&self) -> [(LinearForm, BigRational); 3] {
        let (q, k) = (&self.q, &self.inverse_distance);
        let form = |a: &BigRational, b: &BigRational, c: &BigRational| {
            LinearForm::new(a.clone(), b.clone(), c.clone())
        };
        [
            (form(&q.a, &q.d, &q.g), q.e.clone()),
            (form(&q.d, &q.b, &q.h), q.f.clone()),
            (
                form(&(&q.e + &q.g * k), &(&q.f + &q.h * k), &(&q.i + &q.j * k)),
                &q.c + &q.i * k,
            ),
        ]
    }
}
