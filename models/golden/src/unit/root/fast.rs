//! The same root through the processor's floating-point unit, for whole pictures.

/// floor(sqrt(radicand)), exact for every `radicand < 2^63`: the estimate is off by at most one, which the remainder
/// shows.
#[inline]
pub fn fast_root(radicand: i64) -> i64 {
    let estimate = (radicand as f64).sqrt() as i64;
    let remainder = radicand.wrapping_sub(estimate.wrapping_mul(estimate));
    estimate - i64::from(remainder < 0) + i64::from(remainder > 2 * estimate)
}
