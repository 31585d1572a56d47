//! Intersection of half-spaces along the line of sight.

use super::{Interval, PlaneAt, end};
use crate::rows::numbered;
use crate::tree::tree;
use imogene_contract::words::{
    BACK_PLANE, CAP, FIRST_PLANE, FRONT_PLANE, far_end, near_end, saturated_near,
};
use imogene_hdl::{Bits, Bundle, Ports, Value, bundle, module, net, ports};

bundle! {
    /// What some half-spaces leave of the line of sight.
    Kept(depth) {
        front: Int(depth), "greatest depth of a front plane";
        front_number: Bits(4), "its face";
        back: Int(depth), "least depth of a back plane";
        back_number: Bits(4), "its face";
        removed: Bits(1), "a perpendicular plane removes the pixel";
    }
}

/// The interval of depth that all planes keep, `is_there` said two clocks before the result: a tree over the greatest
/// depth of the front planes and the least of the back planes, then the two ends of the depth word.
///
/// The source cuts the whole line in a chain; a chain that begins with the whole line only looks for these two
/// extremes. At equal depths the smaller index wins. Latency `ceil(log2 planes) + 3`. Annex A.
pub fn half_spaces(at: &str, planes: Vec<PlaneAt>, is_there: Bits) -> Interval {
    let inputs = (("plane", planes), ("is_there", is_there));
    module("half_spaces", at, inputs, |(planes, is_there)| {
        let width = planes[0].zp.width();
        let [lowest, low, end] = [saturated_near, near_end, far_end].map(|of| end(of, width));
        // Where a plane says nothing, a depth that loses to every plane.
        let own = |((at, plane), number): ((String, PlaneAt), u64)| {
            let number = Bits::new(number, 4);
            let front = plane.kind.is(FRONT_PLANE).select(plane.zp, lowest);
            let back = plane.kind.is(BACK_PLANE).select(plane.zp, end);
            Kept {
                front: front.delayed_as(&format!("{at}_front"), 1),
                front_number: number,
                back: back.delayed_as(&format!("{at}_back"), 1),
                back_number: number,
                removed: plane.removes_all().delayed_as(&format!("{at}_removes"), 1),
            }
        };
        let all = numbered("planes", planes).zip(FIRST_PLANE..);
        let all = all.map(own).collect();
        let all = tree(all, half_space_node, "half_space_register");
        let cap = Bits::new(CAP, 4);
        net! {
            let is_front_face = low.less(all.front);
            let is_back_face = all.back.less(end);
            let may_be = (is_there & !all.removed).reg();
        }
        // The depth word ends where no plane does.
        let kept = Interval {
            zf: is_front_face.select(all.front, low),
            nf: is_front_face.select(all.front_number, cap),
            zb: is_back_face.select(all.back, end),
            nb: is_back_face.select(all.back_number, cap),
        };
        let kept = ("kept", kept).delayed(1).bare();
        net! {
            let ends_behind = !kept.zb.less(kept.zf) & kept.zf.less(end);
            let is_present = may_be & ends_behind;
        }
        let nothing = Interval::absent(width);
        is_present.select(kept, nothing).registered()
    })
}

/// What two groups of half-spaces leave. Latency 1. Annex A.
fn half_space_node(at: &str, a: Kept, b: Kept) -> Kept {
    module("half_space_node", at, ports!(a, b), |(a, b)| {
        net! {
            let b_is_deeper = a.front.less(b.front);
            let b_is_nearer = b.back.less(a.back);
        }
        let kept = Kept {
            front: b_is_deeper.select(b.front, a.front),
            front_number: b_is_deeper.select(b.front_number, a.front_number),
            back: b_is_nearer.select(b.back, a.back),
            back_number: b_is_nearer.select(b.back_number, a.back_number),
            removed: a.removed | b.removed,
        };
        kept.registered()
    })
}
