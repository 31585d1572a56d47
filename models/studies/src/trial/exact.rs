//! Exact expressions of the trial: integers over one denominator, in coordinates centred on the anchor, so that 128
//! bits hold everything.
//!
//! Denominators are at most 2^20, values at most 2^63 and coordinates at most 2^10, so numerators stay below 2^84.

use imogene_algebra::rational::from_f64_exact;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use num_rational::BigRational;

/// Factors of an expression, numerators over a denominator.
#[derive(Clone, Copy, Debug)]
pub struct Exact<const N: usize> {
    /// In the order of the terms.
    pub factors: [i128; N],
    /// Common denominator, positive.
    pub denominator: i128,
}

/// `a u + b v + c`.
pub type ExactLinear = Exact<3>;
/// `a u^2 + b v^2 + c u v + d u + e v + f`.
pub type ExactQuadratic = Exact<6>;

/// floor(n / d + 1/2), for d > 0.
pub(super) fn rounded(numerator: i128, denominator: i128) -> i128 {
    (2 * numerator + denominator).div_euclid(2 * denominator)
}

impl<const N: usize> Exact<N> {
    /// Each factor rounded as the preparation does.
    pub fn rounded(&self) -> [i128; N] {
        self.factors.map(|n| rounded(n, self.denominator))
    }

    /// The expression as the preparation has it.
    pub fn form(&self) -> [BigRational; N] {
        let over = |n: i128| BigRational::new_raw(n.into(), self.denominator.into());
        self.factors.map(over)
    }
}

impl ExactLinear {
    /// The words that it is rounded to.
    pub fn words(&self) -> Linear {
        let [a, b, c] = self.rounded();
        Linear::new(a, b, c)
    }

    /// Numerator of the value at a point.
    pub fn at(&self, u: i64, v: i64) -> i128 {
        let [a, b, c] = self.factors;
        a * i128::from(u) + b * i128::from(v) + c
    }
}

impl ExactQuadratic {
    /// The words that it is rounded to.
    pub fn words(&self) -> Quadratic {
        Quadratic::new(self.rounded())
    }

    /// Numerator of the value at a point.
    pub fn at(&self, u: i64, v: i64) -> i128 {
        at(&self.factors, u, v)
    }
}

/// Value of a quadratic expression of integer factors.
pub(super) fn at(factors: &[i128; 6], u: i64, v: i64) -> i128 {
    let [a, b, c, d, e, f] = *factors;
    let (u, v) = (i128::from(u), i128::from(v));
    (a * u + c * v + d) * u + (b * v + e) * v + f
}

/// `numerator / denominator <= bound`, exactly, for numerators from 0 to 2^127 and positive denominators and bounds.
pub fn at_most(numerator: i128, denominator: i128, bound: f64) -> bool {
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
