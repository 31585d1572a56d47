//! Trial of the displacement of the silhouette: at a pixel on which the computed one lies exactly, the true one must be
//! crossed on both sides within the distance stated.

use super::case::Case;
use super::tally::{Tally, Term};
use imogene_algebra::rational::{from_f64_exact, integer};
use imogene_analysis::bounds::displacement_at;
use imogene_golden::unit::pe2::Quadratic;
use imogene_prepare::forms::QuadraticForm;
use num_rational::BigRational;
use num_traits::Signed;

/// Relative allowance for a direction that is rounded to `f64`: it misses the gradient's by so little that the slope
/// along it is this much less.
const DIRECTION_MARGIN: f64 = 1e-12;

/// Compares the displacement at the pixel on which the computed silhouette lies, if there is one and its neighbourhood
/// is in the box.
pub(super) fn try_outline(case: &Case, tally: &mut Tally) {
    let Some((u, v)) = case.on_silhouette else {
        return;
    };
    let (x, y) = case.pixel((u, v));
    let q = &case.words.f2;
    let (px, py) = (i128::from(x), i128::from(y));
    let gradient = [
        (2 * q.a * px + q.c * py + q.d) as f64,
        (2 * q.b * py + q.c * px + q.e) as f64,
    ];
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
    let [a, b, c, d, e, _] = case.f2.factors;
    let (pu, pv) = (i128::from(u), i128::from(v));
    let value = case.f2.at(u, v) as f64;
    let slope = (2 * a * pu + c * pv + d) as f64 * n + (2 * b * pv + c * pu + e) as f64 * m;
    let second = (a as f64 * n + c as f64 * m) * n + b as f64 * m * m;
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
