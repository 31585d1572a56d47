//! Depth of a cut plane.

use super::ends::{absent, end, fits};
use crate::raster::{Flags, HELD, Linear, pe1};
use imogene_contract::words::saturated_near;
use imogene_hdl::{Int, Value, module, net};

/// A plane by a PE1, clamped to a depth word: to the far end, or to one below the near end.
///
/// Latency 2. Section 2.4.2.
pub fn plane_depth(at: &str, flags: Flags, words: Linear, width: u32) -> Int {
    let inputs = (flags, ("", words, HELD));
    module("plane_depth", at, inputs, |(flags, words)| {
        let plane = pe1("plane", flags, words);
        net! {
            let is_in_word = fits(plane, width);
            let saturated = plane.is_negative().select(end(saturated_near, width), absent(width));
        }
        let clamped = is_in_word.select(plane.low(width), saturated);
        let meaning =
            "a x + b y + c modulo the width of its words, clamped to [-2^(W-1), 2^(W-1) - 1]";
        ("depth", clamped.reg(), meaning)
    })
}
