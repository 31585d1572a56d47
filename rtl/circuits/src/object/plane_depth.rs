//! Depth of a cut plane.

use super::ends::{absent, end};
use crate::raster::{Flags, Linear, pe1};
use imogene_contract::words::{far_end, saturated_near};
use imogene_hdl::{Int, Value, module, net};

/// A plane by a PE1, clamped to a depth word: to the far end, or to one below the near end.
///
/// Latency 2. Section 2.4.2.
pub fn plane_depth(at: &str, flags: Flags, words: Linear, width: u32) -> Int {
    let inputs = (flags, ("", words, "read with start"));
    module("plane_depth", at, inputs, |(flags, words)| {
        let plane = pe1("plane", flags, words);
        let [largest, smallest] = [far_end, saturated_near].map(|end| end(width));
        net! {
            let above = Int::new(largest, plane.width()).less(plane);
            let below = plane.less(Int::new(smallest, plane.width()));
        }
        let nearest = end(saturated_near, width);
        let clamped = above.select(absent(width), below.select(nearest, plane.low(width)));
        let meaning =
            "a x + b y + c modulo the width of its words, clamped to [-2^(W-1), 2^(W-1) - 1]";
        ("depth", clamped.reg(), meaning)
    })
}
