//! Intersection of half-spaces along the line of sight.

use super::ends::is_behind_near_end;
use super::{HalfSpace, Interval, Limits, end};
use crate::raster::Flags;
use crate::rows::numbered;
use crate::tree::tree;
use imogene_contract::words::{CAP, FIRST_PLANE, far_end, near_end, saturated_near};
use imogene_hdl::{Bits, Bundle, Ports, Value, module, net, ports};

impl Limits {
    /// Those of no plane.
    fn none(depth: u32) -> Limits {
        let number = Bits::new(0, 4);
        Limits {
            front: end(saturated_near, depth),
            front_number: number,
            back: end(far_end, depth),
            back_number: number,
            removed: Bits::new(0, 1),
        }
    }

    /// Those of planes: a tree over the greatest depth of the front planes and the least of the back planes. At equal
    /// depths the smaller index wins. `3 + ceil(log2 planes)` clocks after the flags.
    pub(crate) fn of(flags: Flags, planes: &[HalfSpace], depth: u32) -> Limits {
        if planes.is_empty() {
            return Limits::none(depth);
        }
        let planes = numbered("planes", planes).zip(FIRST_PLANE..);
        let limits = planes.map(|((at, plane), number)| plane.limits(&at, flags, depth, number));
        tree(limits.collect(), half_space_node, "half_space_register")
    }
}

/// The interval of depth that all planes keep, `is_there` said with its limits: the planes, and where none is the two
/// ends of the depth word. Latency 2.
///
/// The source cuts the whole line in a chain; a chain that begins with the whole line only looks for these two
/// extremes. Annex A.
pub fn half_spaces(at: &str, limits: Limits, is_there: Bits) -> Interval {
    let inputs = (limits, ("is_there", is_there));
    module("half_spaces", at, inputs, |(all, is_there)| {
        let width = all.front.width();
        let [low_limit, low, end] = [saturated_near, near_end, far_end].map(|of| end(of, width));
        let cap = Bits::new(CAP, 4);
        net! {
            let is_front_face = is_behind_near_end(all.front);
            let is_back_face = !all.back.equals(end);
            let is_crossed = all.back.less(all.front);
            let is_before = all.back.equals(low_limit);
            let is_beyond = all.front.equals(end);
            let is_present = (is_there & !(all.removed | is_crossed | is_before | is_beyond)).reg();
        }
        // The depth word ends where no plane does.
        let kept = Interval {
            zf: is_front_face.select(all.front, low),
            nf: is_front_face.select(all.front_number, cap),
            zb: is_back_face.select(all.back, end),
            nb: is_back_face.select(all.back_number, cap),
        };
        let kept = ("kept", kept).delayed(1).bare();
        let nothing = Interval::absent(width);
        is_present.select(kept, nothing).registered()
    })
}

/// What two groups of half-spaces leave. Latency 1. Annex A.
fn half_space_node(at: &str, a: Limits, b: Limits) -> Limits {
    module("half_space_node", at, ports!(a, b), |(a, b)| {
        net! {
            let b_is_deeper = a.front.less(b.front);
            let b_is_nearer = b.back.less(a.back);
        }
        let limits = Limits {
            front: b_is_deeper.select(b.front, a.front),
            front_number: b_is_deeper.select(b.front_number, a.front_number),
            back: b_is_nearer.select(b.back, a.back),
            back_number: b_is_nearer.select(b.back_number, a.back_number),
            removed: a.removed | b.removed,
        };
        limits.registered()
    })
}
