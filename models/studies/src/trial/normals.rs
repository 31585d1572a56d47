//! Trial of the bound of a normal's direction.

use super::case::Case;
use super::tally::{Tally, Term};
use imogene_algebra::rational::from_f64_exact;
use imogene_algebra::vector::{cross, dot, length};
use imogene_analysis::bounds::quadric_sine;
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR};
use imogene_golden::unit::normal::select;
use imogene_golden::unit::root::fast_root;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

/// Compares the directions of both faces' normals at a place of the box, where both signs of f2 are not negative.
pub(super) fn try_normals(case: &Case, place: (i64, i64), tally: &mut Tally) {
    let (x, y) = case.pixel(place);
    let words = &case.words;
    let f2 = words.f2_at(x, y, &case.format);
    let true_f2 = case.f2.at(place.0, place.1);
    if f2 < 0 || true_f2 < 0 {
        return;
    }
    let root = case.format.keep_rows(fast_root(f2));
    let g = words
        .normal
        .g
        .map(|g| g.wrapped_at(x, y, case.format.normal_linear) as i64);
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

/// `p + q s`, exactly, with the positive root s of the radicand.
type WithRoot = (BigRational, BigRational);

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
        let ratio = |(n, d): (i128, i128)| BigRational::new(n.into(), d.into());
        let radicand = ratio(self.radicand);
        let n: [WithRoot; 3] =
            std::array::from_fn(|k| (ratio(self.linear[k]), ratio(self.factor[k])));
        let u = normal.map(|v| BigRational::from_integer(BigInt::from(v)));
        let times = |k: usize, j: usize| -> WithRoot { (&u[k] * &n[j].0, &u[k] * &n[j].1) };
        let minus = |a: WithRoot, b: WithRoot| (a.0 - b.0, a.1 - b.1);
        let across = [(1, 2), (2, 0), (0, 1)].map(|(k, j)| minus(times(k, j), times(j, k)));
        let along = [0, 1, 2].map(|k| times(k, k));
        let along = sum(along);
        let squared = |(p, q): &WithRoot| -> WithRoot {
            (
                p * p + q * q * &radicand,
                BigRational::from_integer(2.into()) * p * q,
            )
        };
        let limit = from_f64_exact(sine);
        let size: BigRational = u.iter().map(|v| v * v).sum();
        let factor = &limit * &limit * size;
        let left = sum(across.each_ref().map(squared));
        let right = sum(n.each_ref().map(squared));
        let rest = (right.0 * &factor - left.0, right.1 * &factor - left.1);
        !is_negative(&rest, &radicand) && is_positive(&along, &radicand)
    }
}

fn sum(parts: [WithRoot; 3]) -> WithRoot {
    let [a, b, c] = parts;
    (a.0 + b.0 + c.0, a.1 + b.1 + c.1)
}

/// True if `p + q sqrt(b) < 0`.
fn is_negative((p, q): &WithRoot, b: &BigRational) -> bool {
    let root = q * q * b;
    match (p.is_negative(), q.is_negative()) {
        (false, false) => false,
        (true, true) => true,
        // The greater square wins.
        (true, false) => root < p * p,
        (false, true) => root > p * p,
    }
}

fn is_positive((p, q): &WithRoot, b: &BigRational) -> bool {
    is_negative(&(-p, -q), b)
}
