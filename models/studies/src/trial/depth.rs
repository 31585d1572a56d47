//! Trial of the depth bounds at one pixel, term by term.

use super::case::Case;
use super::exact::at_most;
use super::tally::{Tally, Term};
use imogene_algebra::rational::from_f64_exact;
use imogene_analysis::bounds::{depth_terms, face_bound, worst_case};
use imogene_analysis::exact::number::SurdReal;
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR};
use imogene_prepare::rounding::Anchor;
use num_bigint::BigInt;
use num_rational::BigRational;
use std::cmp::Ordering;

/// Everything known of a pixel.
struct Pixel<'a> {
    case: &'a Case,
    /// Its place on the screen.
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
        _ => tally.signs += 1,
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
    if numerator == 0.0 {
        0.0
    } else {
        numerator / denominator
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
