//! The first rows of the fixed network (restatement 4.3).

use super::restoring_root;

/// The first `kept` of `root_bits` digits of the exact root; the lower digits are zero.
///
/// The first `kept` rows read the upper `2 kept` bits of the radicand only, so this is the exact network with rows left out. Error: at
/// most `2^(root_bits - kept)` of the last place, never negative, whatever the radicand: a small root is lost altogether.
pub fn rows_root(radicand: u128, root_bits: u32, kept: u32) -> u64 {
    let missing = root_bits.saturating_sub(kept);
    restoring_root(radicand >> (2 * missing), root_bits - missing).root << missing
}
