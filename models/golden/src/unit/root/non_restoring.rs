//! The non-restoring network: rows of controlled add/subtract cells (source: 2.3.3; restatement 4.1).

use super::restoring::Root;

/// The non-restoring recurrence, most significant digit first.
///
/// Row k takes the next pair: `A = 4 rem + pair` with a signed `rem`; if `rem >= 0` then `rem = A - (4 root + 1)`, else
/// `rem = A + (4 root + 3)`; the digit is `rem >= 0`. No row waits for its own sign to choose a remainder. `|rem| <= 2
/// root + 1`, so after k rows k + 2 bits with the sign hold it, and `root` has k live bits. A negative remainder at the
/// end is one subtraction too far: `2 root + 1` is added back. Error: below 1, and never negative.
///
/// `radicand` has `2 * root_bits` bits, `root_bits` is at most 62.
pub fn non_restoring_root(radicand: u128, root_bits: u32) -> Root {
    let mut root: i128 = 0;
    let mut remainder: i128 = 0;
    for row in (0..root_bits).rev() {
        let pair = (radicand >> (2 * row)) as i128 & 3;
        let partial = 4 * remainder + pair;
        remainder = if remainder >= 0 {
            partial - (4 * root + 1)
        } else {
            partial + (4 * root + 3)
        };
        root = 2 * root + i128::from(remainder >= 0);
    }
    if remainder < 0 {
        remainder += 2 * root + 1;
    }
    Root {
        root: root as u64,
        remainder: remainder as u64,
    }
}
