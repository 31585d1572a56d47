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
/// The excess `root^2 - radicand` stands in the bits of the radicand: a root in error by 7 % at most leaves it below
/// an eighth of their range. Latency 2: the square, then the subtractions. Section 2.3.3.
fn root_correction(at: &str, estimate: Estimate) -> Estimate {
    module("root_correction", at, estimate, |estimate| {
        let square = square("squarer", estimate.root, estimate.radicand.width());
        let late = estimate.delayed(1);
        net! {
            let kept_square = square.reg();
            let excess = kept_square - late.radicand;
            let places = late.length + Bits::new(1, LENGTH);
            let is_negative = excess.top();
            // The floor of a negative number is the complement of the shifted complement.
            let magnitude = is_negative.select(!excess, excess);
            let shifted = magnitude.right_by(places);
            let narrow = shifted.low(late.root.width());
            let taken = is_negative.select(!narrow, narrow);
        }
        let root = late.root - taken;
        ("next", Estimate { root, ..late }.registered())
    })
}
