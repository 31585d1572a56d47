//! Correction of an approximate root.

use super::root_length::LENGTH;
use super::square::square;
use crate::rows::numbered;
use imogene_hdl::{Bits, Bundle, Value, bundle, module, net};

bundle! {
    /// An approximate root, and what it is the root of.
    Estimate(digits) {
        radicand: Bits(2 * digits), "the number whose root is taken";
        length: Bits(LENGTH), "bits of the root";
        root: Bits(digits + 1), "root so far, `2^digits` at most because of its floor";
    }
}

impl Estimate {
    /// The root behind so many corrections. Latency `2 count`.
    pub(super) fn corrected(self, count: u32) -> Bits {
        let corrections = numbered("corrections", 0..count);
        let last = corrections.fold(self, |own, (at, _)| root_correction(&at, own));
        last.root
    }
}

/// One correction of a root: `root - floor((root^2 - radicand) / 2^(length + 1))`.
///
/// The excess `root^2 - radicand` of `digits` digits is at most `2^(2 digits - 4)` either way, as much as the first
/// linear estimate has, and what is taken of the root at most `2^(digits - 5)`. Latency 2: the square, then the
/// subtractions. Section 2.3.3.
fn root_correction(at: &str, estimate: Estimate) -> Estimate {
    module("root_correction", at, estimate, |estimate| {
        let digits = estimate.radicand.width() / 2;
        let excess_bits = 2 * digits - 2;
        let square = square("squarer", estimate.root, excess_bits);
        let late = estimate.delayed(1);
        net! {
            let kept_square = square.reg();
            let excess = (kept_square - late.radicand.low(excess_bits)).int();
            let places = late.length + Bits::new(1, LENGTH);
            let shifted = excess.right_by(places);
            let taken = shifted.low(digits - 3).extend(digits + 1).bits();
        }
        let root = late.root - taken;
        ("next", Estimate { root, ..late }.registered())
    })
}
