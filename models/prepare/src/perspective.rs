//! From a quadric or a plane in the camera frame to its expressions on the screen (source: 2.1.1, 2.3.1; factors of
//! Exp. 7 and root order corrected).

use super::forms::{LinearForm, QuadraticForm, sum, times, unreduced};
use imogene_algebra::whole::common_denominator;
use imogene_scene::{Plane, Quadric};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;

/// A quadric after perspective, `a x^2 + b y^2 + c z^2 + 2d xy + 2e xz + 2f yz + 2g x + 2h y + 2i z + j` in screen x,
/// y and depth z_p.
#[derive(Clone, Debug)]
pub struct ScreenQuadric {
    /// The transformed coefficients.
    pub q: Quadric,
    inverse_distance: BigRational,
}

/// A quadric and its planes after perspective.
pub(super) fn on_screen(
    quadric: &Quadric,
    planes: &[Plane],
    inverse_distance: &BigRational,
) -> (ScreenQuadric, Vec<Plane>) {
    let planes = planes
        .iter()
        .map(|plane| project_plane(plane, inverse_distance));
    (
        ScreenQuadric::new(quadric, inverse_distance),
        planes.collect(),
    )
}

/// A plane after perspective, kept where `a x + b y + c z + d <= 0`.
fn project_plane(plane: &Plane, inverse_distance: &BigRational) -> Plane {
    Plane {
        c: sum(&plane.c, &times(&-&plane.d, inverse_distance)),
        ..plane.clone()
    }
}

impl ScreenQuadric {
    /// Transforms a quadric of the camera frame.
    pub fn new(quadric: &Quadric, inverse_distance: &BigRational) -> ScreenQuadric {
        // e - g k, f - h k, i - j k and c - 2 i k + j k^2 for k = n / m, all over one denominator.
        let ([a, b, c, d, e, f, g, h, i, j], unit) = common_denominator(quadric.coefficients());
        let (n, m) = (inverse_distance.numer(), inverse_distance.denom());
        let square = m * m;
        let less = |value: &BigInt, part: &BigInt| (value * m - part * n) * m;
        let whole = [
            &a * &square,
            &b * &square,
            (&c * m - &i * n * 2) * m + &j * n * n,
            &d * &square,
            less(&e, &g),
            less(&f, &h),
            &g * &square,
            &h * &square,
            less(&i, &j),
            &j * &square,
        ];
        ScreenQuadric {
            q: Quadric::from_array(unreduced(whole, &(unit * square))),
            inverse_distance: inverse_distance.clone(),
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
    pub fn polar(&self) -> LinearForm {
        let ([e, f, i], unit) = common_denominator([&self.q.e, &self.q.f, &self.q.i]);
        LinearForm::over([e, f, i], unit)
    }

    /// The terms without z.
    pub fn depth_free_part(&self) -> QuadraticForm {
        let q = &self.q;
        let ([a, b, d, g, h, j], unit) = common_denominator([&q.a, &q.b, &q.d, &q.g, &q.h, &q.j]);
        QuadraticForm::over([a, b, d * 2, g * 2, h * 2, j], unit)
    }

    /// f1: depth on the polar plane of the viewing direction. The factor of z^2 must not be zero.
    pub fn f1(&self) -> LinearForm {
        let q = &self.q;
        let ([e, f, i, c], _) = common_denominator([&q.e, &q.f, &q.i, &q.c]);
        LinearForm::over([e, f, i], -c)
    }

    /// f2: the depths are f1 -+ sqrt(f2). The factor of z^2 must not be zero.
    pub fn f2(&self) -> QuadraticForm {
        // The common denominator of the coefficients cancels against that of the square below.
        let ([a, b, c, d, e, f, g, h, i, j], _) = common_denominator(self.q.coefficients());
        let square = &c * &c;
        let factors: [BigInt; 6] = [
            &e * &e - &a * &c,
            &f * &f - &b * &c,
            (&e * &f - &d * &c) * 2,
            (&e * &i - &g * &c) * 2,
            (&f * &i - &h * &c) * 2,
            &i * &i - &j * &c,
        ];
        QuadraticForm::over(factors, square)
    }

    /// Half the outward normal *before* perspective, as `linear(x, y) + factor * z_p`, each component times the
    /// positive (D - z_p)/D.
    pub fn normal(&self) -> [(LinearForm, BigRational); 3] {
        let q = &self.q;
        let ([a, b, c, d, e, f, g, h, i, j], unit) = common_denominator(q.coefficients());
        let (n, m) = (self.inverse_distance.numer(), self.inverse_distance.denom());
        let moved = |value: &BigInt, part: &BigInt| value * m + part * n;
        let part = |[a, b, c, k]: [BigInt; 4], unit: BigInt| {
            let linear = LinearForm::over([a, b, c], unit.clone());
            (linear, BigRational::new_raw(k, unit))
        };
        let deep = [moved(&e, &g), moved(&f, &h), moved(&i, &j), moved(&c, &i)];
        let deep = part(deep, &unit * m);
        let across = [a, d.clone(), g, e];
        let down = [d, b, h, f];
        [part(across, unit.clone()), part(down, unit), deep]
    }
}
