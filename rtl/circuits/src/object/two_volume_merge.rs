//! The nearer of two intervals.

use super::Interval;
use imogene_hdl::{Bundle, Ports, Value, module, net};

/// Of the two halves of an object the one whose front is nearer, the first of two equal ones. Latency 2.
/// Section 2.4.2.
pub fn two_volume_merge(at: &str, a: Interval, b: Interval) -> Interval {
    let inputs = (("_a", a, "half A"), ("_b", b, "half B"));
    module("two_volume_merge", at, inputs, |(a, b)| {
        net! { let b_in_front = b.zf.less(a.zf).reg(); }
        let (a, b) = (("a", a).delayed(1).bare(), ("b", b).delayed(1).bare());
        ("", b_in_front.select(b, a).registered(), "half in front")
    })
}
