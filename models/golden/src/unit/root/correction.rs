//! The correction step: Newton's with the doubled root replaced by a power of two (source: 2.3.3).

use super::root_length;

/// `R' = R - floor((R^2 - X) / 2^(m+1))`, `corrections` times, in floor arithmetic.
///
/// Widths for a radicand of `2 K` bits: `R` has `K + 1` bits, because the floor of a negative excess can round a root up to `2^m`; the
/// excess `R^2 - X` is less than a quarter of the radicand's range and stands in `2 K` bits, two's complement; what is taken from `R` has
/// `K` bits and a sign. The error shrinks by the factor `1 - (R + s) / 2^(m+1)` about the true root `s`: a half at worst.
pub fn corrected(radicand: u128, estimate: u64, corrections: u32) -> u64 {
    let m = root_length(radicand);
    (0..corrections).fold(estimate, |root, _| {
        let excess = i128::from(root) * i128::from(root) - radicand as i128;
        (i128::from(root) - (excess >> (m + 1))) as u64
    })
}
