//! The restoring network, the source's cellular array (source: 2.3.3).

use super::Root;

/// The cellular array's recurrence, one row per root digit, most significant digit first.
///
/// Row k takes the next pair of radicand bits: `A = 4 rem + pair`, `B = 4 root + 1`; if `A >= B` the digit is 1 and `rem = A - B`,
/// else it is 0 and `rem = A`. After k rows `root` has k live bits and `rem <= 2 root` has k + 1, so the subtraction of row k needs
/// k + 2 cells (2 in the first row): 347 for 24 digits. Error: below 1, and never negative.
///
/// `radicand` has `2 * root_bits` bits, `root_bits` is at most 63.
pub fn restoring_root(radicand: u128, root_bits: u32) -> Root {
    let mut root: u64 = 0;
    let mut remainder: u64 = 0;
    for row in (0..root_bits).rev() {
        let pair = (radicand >> (2 * row)) as u64 & 3;
        let partial = (u128::from(remainder) << 2) | u128::from(pair);
        let divisor = (u128::from(root) << 2) | 1;
        let digit = partial >= divisor;
        remainder = if digit { partial - divisor } else { partial } as u64;
        root = (root << 1) | u64::from(digit);
    }
    Root { root, remainder }
}
