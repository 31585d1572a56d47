//! Digits of the exact root: by the restoring network, the source's cellular array, all of them, the first, or the
//! leading (source: 2.3.3, B.10; restatement 4.3); by rows of controlled add/subtract cells (source: 2.3.3; restatement
//! 4.1); and by the processor's floating-point unit, for whole pictures.

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

/// floor(sqrt(radicand)), exact for every radicand from 0 below 2^63. No branch, so that lanes of it run side by side.
///
/// Let `s` be the true root, below 2^31.6. The radicand as a double is off by a factor of at most 1 + 2^-53, its root
/// by half of that, and rounding the root adds as much as the first: together less than 2^-20. The sum with 2^52 is an
/// integer, the one that is nearest. So `|nearest - s| < 1/2 + 2^-20`, and the floor of `s` is `nearest`, or one less
/// if `nearest^2 > radicand`. The difference is less than 2^33 either way; its sign is right although both may wrap.
#[inline(always)]
pub fn fast_root(radicand: i64) -> i64 {
    const INTEGERS: f64 = (1u64 << 52) as f64;
    let sum = (radicand as u64 as f64).sqrt() + INTEGERS;
    let nearest = i64::from(sum.to_bits() as u32);
    let remainder = radicand.wrapping_sub(nearest.wrapping_mul(nearest));
    nearest + (remainder >> 63)
}
