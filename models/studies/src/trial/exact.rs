//! Exact expressions of the trial: integers over one denominator, in coordinates centred on the anchor, so that 128
//! bits hold everything.
//!
//! Denominators are at most 2^20, values at most 2^63 and coordinates at most 2^10, so numerators stay below 2^84 and
//! the products below (of residuals, at most half a denominator per factor) below 2^90.

use imogene_algebra::rational::from_f64_exact;
use imogene_golden::object::quadric::ScreenBox;
use num_rational::BigRational;

/// Factors of an expression, numerators over a denominator.
#[derive(Clone, Copy, Debug)]
pub(super) struct Exact<const N: usize> {
    /// In the order of the terms.
    pub factors: [i128; N],
    /// Common denominator, positive.
    pub denominator: i128,
}

/// `a u + b v + c`.
pub(super) type ExactLinear = Exact<3>;
/// `a u^2 + b v^2 + c u v + d u + e v + f`.
pub(super) type ExactQuadratic = Exact<6>;

/// floor(n / d + 1/2), for d > 0.
pub(super) fn rounded(numerator: i128, denominator: i128) -> i128 {
    (2 * numerator + denominator).div_euclid(2 * denominator)
}

impl<const N: usize> Exact<N> {
    /// Each factor rounded as the preparation does.
    pub fn rounded(&self) -> [i128; N] {
        self.factors.map(|n| rounded(n, self.denominator))
    }

    /// Rounded minus exact.
    pub fn residual(&self) -> Exact<N> {
        let words = self.rounded();
        Exact {
            factors: std::array::from_fn(|k| words[k] * self.denominator - self.factors[k]),
            ..*self
        }
    }

    /// Greatest magnitude of a numerator in the corners of the box, as a value, rounded up.
    fn most_in_corners(&self, window: &ScreenBox, at: impl Fn(i64, i64) -> i128) -> f64 {
        let corners = corners(window).map(|(u, v)| ratio_up(at(u, v), self.denominator));
        corners.into_iter().fold(0.0, f64::max)
    }
}

impl ExactLinear {
    /// Numerator of the value at a point.
    pub fn at(&self, u: i64, v: i64) -> i128 {
        let [a, b, c] = self.factors;
        a * i128::from(u) + b * i128::from(v) + c
    }

    /// Greatest magnitude on the box, rounded up.
    pub fn max_abs_on(&self, window: &ScreenBox) -> f64 {
        self.most_in_corners(window, |u, v| self.at(u, v))
    }
}

impl ExactQuadratic {
    /// Numerator of the value at a point.
    pub fn at(&self, u: i64, v: i64) -> i128 {
        at(&self.factors, u, v)
    }

    /// Greatest magnitude on the rectangle of the box, rounded up: in a corner, on an edge where the derivative along
    /// it is zero, or where both derivatives are zero. For residuals, whose factors are small.
    pub fn max_abs_on(&self, window: &ScreenBox) -> f64 {
        let [a, b, c, d, e, f] = self.factors;
        let mut most = self.most_in_corners(window, |u, v| self.at(u, v));
        for v in [window.y0, window.y1].map(i128::from) {
            let rest = (b * v + e) * v + f;
            let top = summit([a, c * v + d, rest], window.x0, window.x1, self.denominator);
            most = most.max(top);
        }
        for u in [window.x0, window.x1].map(i128::from) {
            let rest = (a * u + d) * u + f;
            let top = summit([b, c * u + e, rest], window.y0, window.y1, self.denominator);
            most = most.max(top);
        }
        most.max(self.stationary(window))
    }

    /// Magnitude where both derivatives are zero, if that is inside.
    fn stationary(&self, window: &ScreenBox) -> f64 {
        let [a, b, c, d, e, f] = self.factors;
        let determinant = 4 * a * b - c * c;
        if determinant == 0 {
            return 0.0;
        }
        let sign = determinant.signum();
        let (u, v) = ((c * e - 2 * b * d) * sign, (c * d - 2 * a * e) * sign);
        let size = determinant.abs();
        let inside = |n: i128, low: i64, high: i64| {
            n >= i128::from(low) * size && n <= i128::from(high) * size
        };
        if !inside(u, window.x0, window.x1) || !inside(v, window.y0, window.y1) {
            return 0.0;
        }
        ratio_up(2 * f * size + d * u + e * v, 2 * size * self.denominator)
    }
}

/// Value of a quadratic expression of integer factors.
pub(super) fn at(factors: &[i128; 6], u: i64, v: i64) -> i128 {
    let [a, b, c, d, e, f] = *factors;
    let (u, v) = (i128::from(u), i128::from(v));
    (a * u + c * v + d) * u + (b * v + e) * v + f
}

/// Magnitude of `(a t^2 + b t + c) / denominator` where its derivative is zero, if that is between `low` and `high`.
fn summit([a, b, c]: [i128; 3], low: i64, high: i64, denominator: i128) -> f64 {
    if a == 0 {
        return 0.0;
    }
    let at = -b * a.signum();
    let size = 2 * a.abs();
    if at < i128::from(low) * size || at > i128::from(high) * size {
        return 0.0;
    }
    ratio_up(4 * a * c - b * b, 4 * a * denominator)
}

fn corners(window: &ScreenBox) -> [(i64, i64); 4] {
    let ScreenBox { x0, x1, y0, y1 } = *window;
    [(x0, y0), (x1, y0), (x0, y1), (x1, y1)]
}

/// `|numerator / denominator|`, not below the true value and at most a few last bits above it.
pub(super) fn ratio_up(numerator: i128, denominator: i128) -> f64 {
    (numerator as f64 / denominator as f64).abs() * (1.0 + 4.0 * f64::EPSILON)
}

/// `numerator / denominator <= bound`, exactly, for numerators from 0 to 2^127 and positive denominators and bounds.
pub(super) fn at_most(numerator: i128, denominator: i128, bound: f64) -> bool {
    // bound = mantissa / 2^shift
    let bits = bound.to_bits();
    let shift = 1075 - (bits >> 52) as i64;
    let mantissa = i128::from(bits & ((1 << 52) - 1) | 1 << 52);
    let room = i64::from(numerator.leading_zeros()) - 1;
    let product = mantissa.checked_mul(denominator);
    match product {
        Some(product) if bound.is_normal() && (0..=room).contains(&shift) => {
            numerator << shift <= product
        }
        _ => {
            let ratio = BigRational::new(numerator.into(), denominator.into());
            ratio <= from_f64_exact(bound)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn comparisons_with_a_bound_are_exact(n in 0i128..1 << 60, d in 1i128..1 << 50, off in -3i64..=3, far in any::<bool>()) {
            let near = n as f64 / d as f64;
            let bound = if far { near * 1.5 } else { f64::from_bits((near.to_bits() as i64 + off).max(0) as u64) };
            let exact = BigRational::new(n.into(), d.into()) <= from_f64_exact(bound);
            prop_assert_eq!(at_most(n, d, bound), exact);
        }
    }

    #[test]
    fn bounds_that_are_reached_hold() {
        assert!(at_most(3, 4, 0.75) && !at_most(3, 4, 0.75f64.next_down()));
        assert!(at_most(0, 1, 0.0) && !at_most(1, 1 << 100, 0.0));
        assert!(at_most(1 << 100, 1 << 100, 1.0) && !at_most((1 << 100) + 1, 1 << 100, 1.0));
    }
}
