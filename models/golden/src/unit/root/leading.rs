//! The leading significant digits of the root: the source's 12-bit experiment (source: B.10).

use super::restoring_root;

/// The exact root with only its `kept` leading significant bits; shorter roots are untouched.
///
/// Error: relative, below `2^(1 - kept)`, never negative. Hardware needs no more than `kept` rows behind a shift of the radicand by an
/// even count, and one shift back: both floors fall on the same digits.
pub fn leading_root(radicand: u128, root_bits: u32, kept: u32) -> u64 {
    let exact = restoring_root(radicand, root_bits).root;
    let dropped = (64 - exact.leading_zeros()).saturating_sub(kept);
    exact >> dropped << dropped
}
