//! Length of a root, before the root is known.

use imogene_hdl::{Bits, Value, module};

/// Bits of a root length.
pub(super) const LENGTH: u32 = 6;

/// Bits of the root of a radicand: m where it has `2m` or `2m - 1` significant bits, 0 for radicand 0. Without
/// registers.
pub(super) fn root_length(at: &str, radicand: Bits) -> Bits {
    let inputs = ("radicand", radicand);
    module("root_length", at, inputs, |radicand| {
        let pairs = 0..radicand.width() / 2;
        let none = Bits::new(0, LENGTH);
        // The highest pair that is not zero.
        let length = pairs.fold(none, |lower, pair| {
            let is_zero = radicand.slice(2 * pair + 1, 2 * pair).is(0);
            is_zero.select(lower, Bits::new(u64::from(pair) + 1, LENGTH))
        });
        ("length", length)
    })
}
