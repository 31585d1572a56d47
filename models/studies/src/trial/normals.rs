//! Trial of the bound of a normal's direction.

use super::case::Case;
use super::tally::{Tally, Term};
use imogene_algebra::rational::from_f64_exact;
use imogene_algebra::vector::{cross, dot, length};
use imogene_analysis::bounds::quadric_sine;
use imogene_analysis::exact::number::{Number, Surd};
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR};
use imogene_golden::unit::normal::select;
use num_bigint::BigInt;
use num_rational::BigRational;
use std::cmp::Ordering;

/// Compares the directions of both faces' normals at a place of the box, where both signs of f2 are not negative.
pub(super) fn try_normals(case: &Case, place: (i64, i64), tally: &mut Tally) {
    let (x, y) = case.pixel(place);
    let words = &case.words;
    let f2 = words.f2_at(x, y, &case.format);
    let true_f2 = case.f2.at(place.0, place.1);
    if f2 < 0 || true_f2 < 0 {
        return;
    }
    let root = case.format.root_of(f2);
    let bits = case.format.normal_linear;
    let g = words.normal.g.map(|g| g.wrapped_at(x, y, bits) as i64);
    for (face, sign) in [(FACE_NEAR, -1), (FACE_FAR, 1)] {
        let normal = select(face, true, g, root, &words.normal, &[], &case.format);
        let sine = quadric_sine(&words.normal, &case.bounds, f2, normal);
        if sine.is_nan() || sine >= 1.0 {
            tally.undetermined += 1;
            continue;
        }
        let truth = Truth::at(case, place, sign);
        let observed = truth.sine(normal);
        tally.compare(Term::Normal, (x, y), (observed, sine), || {
            truth.within(normal, sine)
        });
    }
}

/// The true normal, `linear + factor * sqrt(radicand)` for each component.
struct Truth {
    linear: [(i128, i128); 3],
    factor: [(i128, i128); 3],
    radicand: (i128, i128),
}

impl Truth {
    fn at(case: &Case, (u, v): (i64, i64), sign: i128) -> Truth {
        let unit = 1i128 << (u32::from(case.words.normal.shift) + case.format.product_fraction());
        let normal = &case.normal;
        Truth {
            linear: normal.g.each_ref().map(|g| (g.at(u, v), g.denominator)),
            factor: normal.k.map(|k| (sign * k, normal.denominator * unit)),
            radicand: (
                case.f2.at(u, v),
                case.f2.denominator << case.format.guard_quadratic,
            ),
        }
    }

    /// Sine of the angle to a computed normal, in `f64`.
    fn sine(&self, normal: [i16; 3]) -> f64 {
        let float = |(n, d): (i128, i128)| n as f64 / d as f64;
        let root = float(self.radicand).sqrt();
        let n: [f64; 3] =
            std::array::from_fn(|k| float(self.linear[k]) + float(self.factor[k]) * root);
        // The cross product of the error, which is small, instead of the vector: u x N = -(u x e) with e = 256 u - N.
        let u = normal.map(f64::from);
        let error: [f64; 3] = std::array::from_fn(|k| 256.0 * u[k] - n[k]);
        let across = length(cross(u, error)) / (length(u) * length(n));
        if dot(u, n) > 0.0 {
            across
        } else {
            f64::INFINITY
        }
    }

    /// The angle is less than a right one and its sine at most `sine`, exactly: `|u x N|^2 <= sine^2 |u|^2 |N|^2` and
    /// `u N > 0`.
    fn within(&self, normal: [i16; 3], sine: f64) -> bool {
        // Times a positive factor, which changes neither, all is whole.
        let [radicand, unit] = [self.radicand.0, self.radicand.1].map(BigInt::from);
        let n: [Surd; 3] = std::array::from_fn(|k| {
            let ((p, d), (q, e)) = (self.linear[k], self.factor[k]);
            let [p, d, q, e] = [p, d, q, e].map(BigInt::from);
            Surd::new(p * e * &unit, q * d, &radicand * &unit)
        });
        let u = normal.map(BigInt::from);
        let across =
            [(1, 2), (2, 0), (0, 1)].map(|(k, j)| n[j].times(&u[k]).minus(&n[k].times(&u[j])));
        let along = sum([0, 1, 2].map(|k| n[k].times(&u[k])));
        let square = |n: &[Surd; 3]| sum(n.each_ref().map(|v| v.product(v)));
        let limit = from_f64_exact(sine).pow(2) * BigRational::from_integer(dot(&u, &u));
        let part = square(&across).times(limit.denom());
        let rest = square(&n).times(limit.numer()).minus(&part);
        rest.sign() != Ordering::Less && along.sign() == Ordering::Greater
    }
}

fn sum([a, b, c]: [Surd; 3]) -> Surd {
    a.plus(&b).plus(&c)
}
