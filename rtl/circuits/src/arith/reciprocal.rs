//! The reciprocal.

use super::segment_curve::{Curve, segment_curve};
use imogene_hdl::{Bits, Int, Value, join};

const RECIPROCAL: Curve = Curve {
    function: |t| 1.0 / (1.0 + t),
    length: 1.0 / 16.0,
    fraction: 16,
};

/// `1 / (1 + t)` in 18 bits, 16 of them after the point, of the 16 bits t after a point.
///
/// A curve of 16 segments, with 12 bits of place. Latency 7.
pub fn reciprocal(at: &str, number: Bits) -> Int {
    let place = join([number.slice(11, 0), Bits::new(0, 2)]);
    segment_curve(at, number.slice(15, 12), place, &RECIPROCAL).low(18)
}
