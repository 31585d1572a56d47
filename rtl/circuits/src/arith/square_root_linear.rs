//! Piecewise linear square root with corrections.

use super::RADICAND;
use super::root_correction::{Estimate, LINEAR};
use super::root_length::root_length;
use imogene_hdl::{Bits, Bundle, Value, module, net};

/// An approximate root of one bit more than the exact one, `2^digits` at most: two straight lines per pair of
/// octaves, joined, and corrections behind them.
///
/// A radicand of `2m` bits gets `X / 2^(m+1) + 2^(m-1)`, one of `2m - 1` bits `X / 2^m + 2^(m-1) - 2^(m-2)`: a shift
/// and an addition. The greatest error is 6.07, 1.65 and 0.47 % after 0, 1 and 2 corrections, besides the floors; the
/// root is monotone in the radicand. Latency `1 + 2 corrections`. Section 2.3.3.
pub fn square_root_linear(at: &str, radicand: Bits, corrections: u32) -> Bits {
    let inputs = ("radicand", radicand, RADICAND);
    module("square_root_linear", at, inputs, |radicand| {
        let width = radicand.width() / 2 + 1;
        let halved = |word: Bits| word.slice(width - 1, 1).extend(width);
        let length = root_length("measured", radicand);
        net! {
            let power = Bits::new(1, width).left_by(length);
            let half = halved(power);
            let quarter = halved(half);
            let shifted = radicand.right_by(length);
            let scaled = shifted.low(width);
            let is_even = !(scaled & half).is(0);
            let slope = is_even.select(halved(scaled), scaled);
            let offset = is_even.select(half, half - quarter);
        }
        let root = slope + offset;
        let estimate = Estimate {
            radicand,
            length,
            root,
        };
        let root = estimate.registered().corrected(corrections, LINEAR);
        ("root", root, "approximate root, at most 2^W")
    })
}
