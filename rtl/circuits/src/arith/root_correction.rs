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
    /// The root behind so many corrections, before which the excess is as stated; before later ones as before the
    /// last. Floors take more of roots of fewer than nine digits: there all are as before the first one of a linear
    /// root. Latency `2 count`.
    pub(super) fn corrected(self, count: u32, stated: [Excess; 2]) -> Bits {
        let [first, later] = match self.radicand.width() / 2 {
            0..9 => [LINEAR[0]; 2],
            _ => stated,
        };
        let excesses = std::iter::once(first).chain(std::iter::repeat(later));
        let corrections = numbered("corrections", excesses.take(count as usize));
        let last = corrections.fold(self, |own, (at, excess)| root_correction(&at, own, excess));
        last.root
    }
}

/// What `root^2 - radicand` is before a correction.
#[derive(Clone, Copy)]
pub(super) struct Excess {
    /// Bits by which it is shorter than the radicand, besides its sign.
    shorter: u32,
    is_signed: bool,
}

/// Of linear roots of W digits: at most `2^(2 W - 4)` either way, which the first estimate reaches; behind a correction
/// 0 to `2^(2 W - 5)`.
pub(super) const LINEAR: [Excess; 2] = [
    Excess {
        shorter: 3,
        is_signed: true,
    },
    Excess {
        shorter: 5,
        is_signed: false,
    },
];

/// Of quadratic roots of W digits: below `2^(2 W - 6)` either way, and behind a correction below `2^(2 W - 7)`.
pub(super) const QUADRATIC: [Excess; 2] = [
    Excess {
        shorter: 6,
        is_signed: true,
    },
    Excess {
        shorter: 7,
        is_signed: true,
    },
];

/// One correction of a root: `root - floor((root^2 - radicand) / 2^(length + 1))`. What is taken of the root is shorter
/// than the excess by its digits and one. Latency 2: the square, then the subtractions. Section 2.3.3.
fn root_correction(at: &str, estimate: Estimate, excess: Excess) -> Estimate {
    module("root_correction", at, estimate, |estimate| {
        let digits = estimate.radicand.width() / 2;
        let bits = 2 * digits - excess.shorter;
        let excess_bits = bits + u32::from(excess.is_signed);
        let square = square("squarer", estimate.root, excess_bits);
        let late = estimate.delayed(1);
        net! {
            let kept_square = square.reg();
            let difference = kept_square - late.radicand.low(excess_bits);
            let places = late.length + Bits::new(1, LENGTH);
            let taken = match excess.is_signed {
                true => {
                    let taken = difference.int().right_by(places).low(bits - digits);
                    taken.extend(digits + 1).bits()
                }
                false => {
                    let taken = difference.right_by(places).low(bits - digits - 1);
                    taken.extend(digits + 1)
                }
            };
        }
        let root = late.root - taken;
        ("next", Estimate { root, ..late }.registered())
    })
}
