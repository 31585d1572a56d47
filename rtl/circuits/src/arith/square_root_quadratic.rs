//! Piecewise quadratic square root with corrections.

use super::RADICAND;
use super::fifteenth::{FIFTEENTH, fifteenth};
use super::root_correction::{Estimate, QUADRATIC};
use super::root_length::{LENGTH, root_length};
use super::square::square;
use imogene_hdl::{Bits, Value, module, net};

/// An approximate root of one bit more than the exact one, `2^digits` at most: one parabola per pair of octaves,
/// joined, and corrections behind it.
///
/// With the length m of the root and `A = floor(X / 2^m)`, `15 R = floor(15 X / 2^m) + 2^(m+2) - floor(A^2 /
/// 2^(m-2))`: the source's polynomial with the sign of its square corrected. The greatest error is 1.35, 0.53 and
/// 0.22 % after 0, 1 and 2 corrections, besides the floors. The root steps down by one at some radicands. Latency `3
/// + 2 corrections`: scaling, square, fifteenth. Section 2.3.3.
pub fn square_root_quadratic(at: &str, radicand: Bits, corrections: u32) -> Bits {
    let inputs = ("radicand", radicand, RADICAND);
    module("square_root_quadratic", at, inputs, |radicand| {
        let digits = radicand.width() / 2;
        // Fifteen roots are below 2^(W + 4).
        let wide = (digits + 4).max(FIFTEENTH);
        let one = Bits::new(1, digits + 1);
        let two_places = Bits::new(2, LENGTH);
        let times_15 = |word: Bits| {
            let word = word.extend(digits + 4);
            word.left(4) - word
        };
        let length = root_length("measured", radicand);
        net! {
            let radicand_1 = radicand.reg();
            let radicand_2 = radicand_1.reg();
            let radicand_3 = radicand_2.reg();
            let length_1 = length.reg();
            let length_2 = length_1.reg();
            let length_3 = length_2.reg();
            let shifted = radicand.right_by(length);
            let mask = one.left_by(length) - one;
            let kept_scaled = shifted.low(digits).reg();
            let kept_rest = (radicand.low(digits) & mask.low(digits)).reg();
            // 15 X does not fit the radicand's width: 15 A, and 15 times the bits below A.
            let scaled_15 = times_15(kept_scaled);
            let rest_15 = times_15(kept_rest);
            let carried = rest_15.right_by(length_1).low(4);
            let slope = scaled_15.extend(wide) + carried.extend(wide);
            let offset = Bits::new(4, wide).left_by(length_1);
            let kept_sum = (slope + offset).reg();
            let kept_square = square("squarer", kept_scaled, radicand.width()).reg();
            // At lengths below 2 the square is 0 or 1, and the fifteenth is the same without a shift.
            let is_short = length_2.less(two_places);
            let places = is_short.select(Bits::new(0, LENGTH), length_2 - two_places);
            let shifted_square = kept_square.right_by(places);
            let fifteenfold = kept_sum - shifted_square.low(digits + 2).extend(wide);
        }
        let root = fifteenth(fifteenfold).low(digits + 1).reg();
        let estimate = Estimate {
            radicand: radicand_3,
            length: length_3,
            root,
        };
        let root = estimate.corrected(corrections, QUADRATIC);
        ("root", root, "approximate root, at most 2^W")
    })
}
