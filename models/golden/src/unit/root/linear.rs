//! The piecewise linear estimate, Hashemian's made continuous (source: 2.3.3).

use super::root_length;

/// With `m` from [`root_length`]: `floor((X + 4^m) / 2^(m+1))` for `2m` bits, `floor((X + 4^(m-1)) / 2^m)` for `2m - 1`.
///
/// These are the printed `X / 2^(m+1) + 2^(m-1)` and `X / 2^m + 2^(m-1) - 2^(m-2)`: a shift and one addition. The sum takes `2 K + 1`
/// bits before the shift, or `K` bits after it, because the constant is a multiple of the divisor but for `m = 1`. Error: 0 to 6.066 % of
/// the root before the floor, most at the middle `X = 2^(2m-1)`.
pub fn linear_estimate(radicand: u128) -> u64 {
    let m = root_length(radicand);
    if m == 0 {
        return 0;
    }
    let is_odd_length = radicand >> (2 * m - 1) == 0;
    let estimate = if is_odd_length {
        (radicand + (1 << (2 * m - 2))) >> m
    } else {
        (radicand + (1 << (2 * m))) >> (m + 1)
    };
    estimate as u64
}
