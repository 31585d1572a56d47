//! The nearer of two intervals.

use super::Interval;
use imogene_hdl::{Bundle, Value, module, net};

/// Of the two halves of an object the one whose front is nearer, the first of two equal ones. Latency 1.
/// Section 2.4.2.
pub fn two_volume_merge(at: &str, a: Interval, b: Interval) -> Interval {
    let inputs = (("_a", a, "half A"), ("_b", b, "half B"));
    module("two_volume_merge", at, inputs, |(a, b)| {
        net! { let b_in_front = b.zf.less(a.zf); }
        ("", b_in_front.select(b, a).registered(), "half in front")
    })
}
