//! From two roots to intervals, by class.

use super::clamped::Clamped;
use super::{Interval, Roots, absent, end};
use imogene_contract::words::{CAP, FAR_ROOT, FRONT, NEAR_ROOT, PATCH, PRISM, SIDE, near_end};
use imogene_hdl::{Bits, Bundle, Int, Value, bundles, module, net};

bundles! {
    /// The two halves of an object.
    Halves {
        a: Interval as "_a", "half A, the one of all classes";
        b: Interval as "_b", "half B, behind the far root of the class front";
    }
}

/// The intervals of an object between the ends of the depth, by its class.
///
/// Latency 1. Section 2.4.2.
pub fn depth_interval(at: &str, roots: Roots, object_class: Bits) -> Halves {
    let meaning = "class of the object: 0 side, 1 front, 2 patch, 3 prism";
    let inputs = (roots, ("object_class", object_class, meaning));
    module("depth_interval", at, inputs, |(roots, object_class)| {
        let width = roots.depth();
        let low = end(near_end, width);
        let face = |number: u64| Bits::new(number, 4);
        let near = Clamped::of("near", roots.near_sum, NEAR_ROOT);
        let far = Clamped::of("far", roots.far_sum, FAR_ROOT);
        let is = |class: u64| object_class.is(class);
        net! {
            let near_visible = near.is_visible();
            let far_visible = far.is_visible();
            let is_front = is(FRONT);
            let is_side = is(SIDE) & !(near.is_far | far.is_low);
            let is_before = is_front & !near.is_low;
            let is_surface = is(PATCH);
            let is_prism = is(PRISM);
            let has_b = roots.in_box & roots.is_inside & is_front & !far.is_far;
        }
        let interval = |[zf, zb]: [Int; 2], [nf, nb]: [Bits; 2]| Interval { zf, nf, zb, nb };
        let nothing = Interval::absent(width);
        let all = interval([low, absent(width)], [face(CAP), face(CAP)]);
        let side = interval([near.depth, far.depth], [near.face, face(FAR_ROOT)]);
        let before = interval([low, near.depth], [face(CAP), face(NEAR_ROOT)]);
        let behind = interval([far.depth, absent(width)], [far.face, face(CAP)]);
        let surface = Interval::of_surface([near_visible, far_visible], [near.depth, far.depth]);
        let kinds = [
            (is_prism, all),
            (is_surface, surface.called("surface")),
            (is_before, before),
            (is_side, side),
        ];
        let choose = |other: Interval, (holds, one): (Bits, Interval)| holds.select(one, other);
        let inside = kinds.into_iter().fold(nothing, choose).called("inside");
        let outside = is_front.select(all, nothing);
        let a = roots.is_inside.select(inside, outside);
        Halves {
            a: roots.in_box.select(a, nothing).registered(),
            b: has_b.select(behind, nothing).registered(),
        }
    })
}
