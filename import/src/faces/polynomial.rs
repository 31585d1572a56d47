//! Real roots of small polynomials and of the trigonometric equations of a cut.

use super::vector::positive_angle;

/// Real roots of `a x^2 + b x + c`, ascending, a double root once; none if all are zero.
pub fn quadratic(a: f64, b: f64, c: f64) -> Vec<f64> {
    let least = 1e-14 * a.abs().max(b.abs()).max(c.abs());
    if a.abs() <= least {
        let is_linear = b.abs() > least;
        return if is_linear { vec![-c / b] } else { vec![] };
    }
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < -1e-14 * (b * b).max((4.0 * a * c).abs()) {
        return vec![];
    }
    let root = discriminant.max(0.0).sqrt();
    if root == 0.0 {
        return vec![-b / (2.0 * a)];
    }
    // The root without cancellation first, the other from the product of both.
    let q = -0.5 * (b + root.copysign(b));
    let mut roots = vec![q / a, if q == 0.0 { 0.0 } else { c / q }];
    roots.sort_by(f64::total_cmp);
    roots
}

/// Angles from 0 to 2 pi with `a cos u + b sin u = c`.
pub fn harmonic(a: f64, b: f64, c: f64) -> Vec<f64> {
    let size = a.hypot(b);
    let ratio = c / size;
    if size == 0.0 || ratio.abs() > 1.0 + 1e-13 {
        return vec![];
    }
    let (middle, half) = (b.atan2(a), ratio.clamp(-1.0, 1.0).acos());
    [middle - half, middle + half].map(positive_angle).to_vec()
}

/// Value of a polynomial, lowest power first.
fn value(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// Real roots between `from` and `to` of a polynomial, lowest power first, double ones among them.
pub fn roots_between(coefficients: &[f64], from: f64, to: f64) -> Vec<f64> {
    if coefficients.len() < 2 {
        return vec![];
    }
    let terms = || coefficients.iter().enumerate();
    let derivative: Vec<f64> = terms().skip(1).map(|(power, c)| power as f64 * c).collect();
    let turns = roots_between(&derivative, from, to);
    let ends = [&[from], &turns[..], &[to]].concat();
    let stretches = ends.windows(2);
    let passed = stretches.filter_map(|pair| bisected(coefficients, pair[0], pair[1]));
    let mut roots: Vec<f64> = passed.collect();
    let reach = from.abs().max(to.abs());
    let sizes = terms().map(|(power, c)| c.abs() * reach.powi(power as i32));
    let least = 1e-10 * sizes.sum::<f64>();
    let touches = |x: &f64| value(coefficients, *x).abs() <= least;
    roots.extend(turns.into_iter().filter(touches));
    roots.sort_by(f64::total_cmp);
    roots
}

/// The root between two ends of different signs, on a stretch without turn.
fn bisected(coefficients: &[f64], mut low: f64, mut high: f64) -> Option<f64> {
    let (at_low, at_high) = (value(coefficients, low), value(coefficients, high));
    if at_low * at_high > 0.0 || !(at_low.is_finite() && at_high.is_finite()) {
        return None;
    }
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if (value(coefficients, middle) < 0.0) == (at_low < 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(0.5 * (low + high))
}
