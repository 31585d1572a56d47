//! Trial of the bounds at one place of a box: of the depth term by term, of the displacement of the silhouette and of a
//! normal's direction.

use super::case::Case;
use super::exact::at_most;
use super::tally::{Tally, Term};
use imogene_algebra::rational::{from_f64_exact, integer};
use imogene_algebra::vector::{cross, dot, length};
use imogene_analysis::bounds::{
    depth_terms, displacement_at, face_bound, quadric_sine, worst_case,
};
use imogene_analysis::exact::number::{Number, Surd, SurdReal};
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR};
use imogene_golden::unit::normal::select;
use imogene_golden::unit::pe2::Quadratic;
use imogene_prepare::forms::QuadraticForm;
use imogene_prepare::rounding::Anchor;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;
use std::cmp::Ordering;

struct Pixel<'a> {
    case: &'a Case,
    at: (i64, i64),
    /// Computed values with their guard bits.
    q1: i128,
    q2: i128,
    /// Exact numerators, in the same units.
    n1: i128,
    n2: i128,
    /// Computed minus exact, as numerators.
    r1: i128,
    r2: i128,
    /// Denominators of the exact values in output units.
    d1: i128,
    d2: i128,
}

/// Compares every term of the depth error at a place of the box, centred on the anchor.
pub fn try_pixel(case: &Case, place: (i64, i64), tally: &mut Tally) {
    let (x, y) = case.pixel(place);
    let (f1, f2, format) = (&case.f1, &case.f2, &case.format);
    let q1 = case.words.f1.wrapped_at(x, y, format.pe1_width());
    let q2 = case.words.f2.wrapped_at(x, y, format.pe2_width());
    let [n1, n2] = [f1.at(place.0, place.1), f2.at(place.0, place.1)];
    let pixel = Pixel {
        case,
        at: (x, y),
        q1,
        q2,
        n1,
        n2,
        r1: q1 * f1.denominator - n1,
        r2: q2 * f2.denominator - n2,
        d1: f1.denominator << format.guard_linear,
        d2: f2.denominator << format.guard_quadratic,
    };
    tally.pixels += 1;
    pixel.coefficients(tally);
    match (pixel.q2 >= 0, pixel.n2 >= 0) {
        (true, true) => pixel.depth(tally),
        (false, false) => {}
        _ => tally.sign_differences += 1,
    }
}

/// Compares the bounds of the coefficients with those known before the coefficients are.
pub(super) fn try_beforehand(case: &Case, tally: &mut Tally) {
    let unit = |guards: u32| 0.5f64.powi(guards as i32);
    let linear = Anchor::ORIGIN.linear_bound(&case.reach) * unit(case.format.guard_linear);
    let quadratic = Anchor::ORIGIN.quadratic_bound(&case.reach) * unit(case.format.guard_quadratic);
    let bounds = &case.bounds;
    let slack = 1.0 + 1e-12;
    let place = case.pixel((0, 0));
    let holds = || bounds.f1 <= linear * slack;
    tally.compare(Term::LinearBeforehand, place, (bounds.f1, linear), holds);
    let (term, holds) = (Term::QuadraticBeforehand, || bounds.f2 <= quadratic * slack);
    tally.compare(term, place, (bounds.f2, quadratic), holds);
}

impl Pixel<'_> {
    fn coefficients(&self, tally: &mut Tally) {
        let bounds = &self.case.bounds;
        for (term, r, d, bound) in [
            (Term::Linear, self.r1, self.d1, bounds.f1),
            (Term::QuadraticValue, self.r2, self.d2, bounds.f2),
        ] {
            let observed = (r as f64 / d as f64).abs();
            let holds = || at_most(r.abs(), d, bound);
            tally.compare(term, self.at, (observed, bound), holds);
        }
    }

    fn depth(&self, tally: &mut Tally) {
        let format = &self.case.format;
        let bounds = &self.case.bounds;
        let f1 = format.drop_linear(self.q1 as i64);
        let f2 = format.drop_quadratic(self.q2 as i64);
        let root = format.root_of(f2);
        let stated = depth_terms(bounds, f2);

        let linear = self.r1 as f64 / self.d1 as f64;
        let dropped = self.q1 - (i128::from(f1) << format.guard_linear);
        let truncation = dropped as f64 / (1u64 << format.guard_linear) as f64;
        // Differences of roots as quotients, so that nothing cancels.
        let unit = (1u64 << format.guard_quadratic) as f64;
        let computed_root = (self.q2 as f64 / unit).sqrt();
        let true_root = (self.n2 as f64 / self.d2 as f64).sqrt();
        let off = self.r2 as f64 / self.d2 as f64;
        let quadratic = quotient(off, computed_root + true_root);
        let above = self.q2 - (i128::from(root).pow(2) << format.guard_quadratic);
        let floor = quotient(above as f64 / unit, computed_root + root as f64);

        let at = self.at;
        let most = stated.truncation;
        let holds = || dropped >= 0 && at_most(dropped, 1 << format.guard_linear, most);
        tally.compare(Term::Truncation, at, (truncation, most), holds);
        tally.compare(Term::RootFloor, at, (floor, stated.root_floor), || {
            let next = i128::from(root + (1 << format.dropped_rows));
            above >= 0 && self.q2 < next.pow(2) << format.guard_quadratic
        });
        let holds = || self.roots_within(stated.quadratic);
        let both = (quadratic.abs(), stated.quadratic);
        tally.compare(Term::QuadraticRoot, at, both, holds);
        let closed = worst_case(bounds);
        for (face, sign) in [(FACE_NEAR, -1), (FACE_FAR, 1)] {
            let off = linear - truncation + f64::from(sign) * (quadratic - floor);
            let depth = f1 + i64::from(sign) * root;
            let bound = face_bound(bounds, face, f2);
            for (term, bound) in [(Term::Depth, bound), (Term::DepthClosedForm, closed)] {
                let holds = || self.depth_within(depth, sign, bound);
                tally.compare(term, at, (off.abs(), bound), holds);
            }
        }
    }

    /// `|sqrt(q2) - sqrt(f2)| <= bound`, exactly.
    fn roots_within(&self, bound: f64) -> bool {
        let computed = |added| root_plus(self.q2, 1 << self.case.format.guard_quadratic, added);
        let exact = |added| root_plus(self.n2, self.d2, added);
        computed(0.0) <= exact(bound) && exact(0.0) <= computed(bound)
    }

    /// `|depth - (f1 + sign sqrt(f2))| <= bound`, exactly.
    fn depth_within(&self, depth: i64, sign: i32, bound: f64) -> bool {
        let [n1, n2, d1, d2] = [self.n1, self.n2, self.d1, self.d2].map(BigInt::from);
        // f1 + sign sqrt(f2) = (n1 d2 + sign sqrt(n2 d2 d1^2)) / (d1 d2)
        let exact = SurdReal::new(&n1 * &d2, sign, n2 * &d2 * &d1 * &d1, d1 * d2);
        let bound = from_f64_exact(bound);
        let depth = BigRational::from_integer(depth.into());
        let (low, high) = (&depth - &bound, depth + bound);
        exact.cmp_ratio(low.numer(), low.denom()) != Ordering::Less
            && exact.cmp_ratio(high.numer(), high.denom()) != Ordering::Greater
    }
}

fn quotient(numerator: f64, denominator: f64) -> f64 {
    match numerator == 0.0 {
        true => 0.0,
        false => numerator / denominator,
    }
}

/// `sqrt(n / d) + added`.
fn root_plus(n: i128, d: i128, added: f64) -> SurdReal {
    let (n, d) = (BigInt::from(n), BigInt::from(d));
    let added = from_f64_exact(added);
    let (p, q) = (added.numer(), added.denom());
    // (p d + sqrt(n d q^2)) / (d q)
    SurdReal::new(p * &d, 1, n * &d * q * q, d * q)
}

/// Relative allowance for a direction that is rounded to `f64`: it misses the gradient's by so little that the slope
/// along it is this much less.
const DIRECTION_MARGIN: f64 = 1e-12;

/// Compares the displacement at the pixel on the computed silhouette, if there is one with room around it.
pub(super) fn try_outline(case: &Case, tally: &mut Tally) {
    let Some((u, v)) = case.on_silhouette else {
        return;
    };
    let (x, y) = case.pixel((u, v));
    let q = &case.words.f2;
    let from_here = q.from_zone(x, y);
    let gradient = [from_here.d as f64, from_here.e as f64];
    let error = case.bounds.f2 * (1u64 << case.format.guard_quadratic) as f64;
    let Some(distance) = displacement_at(q, gradient, error) else {
        return;
    };
    let reach = &case.reach;
    let spare = [u - reach.x0, reach.x1 - u, v - reach.y0, reach.y1 - v];
    if spare.iter().any(|&s| (s as f64) < distance) {
        return;
    }
    let length = gradient[0].hypot(gradient[1]);
    let unit = gradient.map(|g| g / length);
    let stretched = distance * (1.0 + DIRECTION_MARGIN);
    let step = unit.map(|n| n * stretched);
    let observed = crossing(case, (u, v), unit).abs();
    tally.compare(Term::Silhouette, (x, y), (observed, distance), || {
        let ahead = exact_at(case, (u, v), step);
        let behind = exact_at(case, (u, v), step.map(|s| -s));
        !ahead.is_negative() && !behind.is_positive()
    });
}

/// Where the true f2 is zero along the direction, nearest to the pixel; infinite if nowhere.
fn crossing(case: &Case, (u, v): (i64, i64), [n, m]: [f64; 2]) -> f64 {
    let Quadratic { a, b, c, d, e, f } = Quadratic::new(case.f2.factors).from_zone(u, v);
    let [a, b, c, d, e, value] = [a, b, c, d, e, f].map(|v| v as f64);
    let slope = d * n + e * m;
    let second = (a * n + c * m) * n + b * m * m;
    // second t^2 + slope t + value = 0, the smaller root without cancellation.
    let inside = slope * slope - 4.0 * second * value;
    if inside < 0.0 || slope == 0.0 {
        return f64::INFINITY;
    }
    2.0 * value / (slope.abs() + inside.sqrt())
}

/// The true f2 a step beside a place of the box, exactly but for a positive factor.
fn exact_at(case: &Case, (u, v): (i64, i64), step: [f64; 2]) -> BigRational {
    let at = |start: i64, s: f64| integer(start) + from_f64_exact(s);
    let form = QuadraticForm::of_words(&Quadratic::new(case.f2.factors));
    form.at(&at(u, step[0]), &at(v, step[1]))
}

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
            tally.normals_undetermined += 1;
            continue;
        }
        let truth = TrueNormal::at(case, place, sign);
        let holds = || truth.within(normal, sine);
        tally.compare(Term::Normal, (x, y), (truth.sine(normal), sine), holds);
    }
}

/// The true normal, `linear + factor * sqrt(radicand)` for each component.
struct TrueNormal {
    linear: [(i128, i128); 3],
    factor: [(i128, i128); 3],
    radicand: (i128, i128),
}

impl TrueNormal {
    fn at(case: &Case, (u, v): (i64, i64), sign: i128) -> TrueNormal {
        let unit = 1i128 << (u32::from(case.words.normal.shift) + case.format.product_fraction());
        let normal = &case.normal;
        TrueNormal {
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
        match dot(u, n) > 0.0 {
            true => length(cross(u, error)) / (length(u) * length(n)),
            false => f64::INFINITY,
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
