//! Digits of the exact root by the restoring network, the source's cellular array: all of them, the first, or the
//! leading (source: 2.3.3, B.10; restatement 4.3).

/// Root and remainder, `radicand = root^2 + remainder`, `0 <= remainder <= 2 root`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Root {
    /// floor(sqrt(radicand)).
    pub root: u64,
    /// radicand - root^2.
    pub remainder: u64,
}

/// The cellular array's recurrence, one row per root digit, most significant digit first.
///
/// Row k takes the next pair of radicand bits: `A = 4 rem + pair`, `B = 4 root + 1`; if `A >= B` the digit is 1 and
/// `rem = A - B`, else it is 0 and `rem = A`. After k rows `root` has k live bits and `rem <= 2 root` has k + 1, so the
/// subtraction of row k needs k + 2 cells (2 in the first row): 347 for 24 digits. Error: below 1, and never negative.
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

/// The first `kept` of `root_bits` digits of the exact root; the lower digits are zero.
///
/// The first `kept` rows read the upper `2 kept` bits of the radicand only, so this is the exact network with rows left
/// out. Error: at most `2^(root_bits - kept)` of the last place, never negative, whatever the radicand: a small root is
/// lost altogether.
pub fn rows_root(radicand: u128, root_bits: u32, kept: u32) -> u64 {
    let missing = root_bits.saturating_sub(kept);
    restoring_root(radicand >> (2 * missing), root_bits - missing).root << missing
}

/// The exact root with only its `kept` leading significant bits; shorter roots are untouched.
///
/// Error: relative, below `2^(1 - kept)`, never negative. Hardware needs no more than `kept` rows behind a shift of the
/// radicand by an even count, and one shift back: both floors fall on the same digits.
pub fn leading_root(radicand: u128, root_bits: u32, kept: u32) -> u64 {
    let exact = restoring_root(radicand, root_bits).root;
    let dropped = (64 - exact.leading_zeros()).saturating_sub(kept);
    exact >> dropped << dropped
}
