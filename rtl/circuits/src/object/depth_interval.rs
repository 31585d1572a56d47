//! From two roots to intervals, by class.

use super::clamped::Clamped;
use super::{Interval, Roots, end};
use imogene_contract::words::{
    CAP, FAR_ROOT, FRONT, NEAR_ROOT, PATCH, PRISM, SIDE, far_end, near_end,
};
use imogene_hdl::{Bits, Bundle, Int, Ports, Value, bundles, module, net};

bundles! {
    /// The two halves of an object.
    Halves {
        a: Interval as "_a", "half A, the one of all classes";
        b: Interval as "_b", "half B, behind the far root of the class front";
    }
}

/// Bits that say from where a depth is taken: -1 and 1, the ends of a depth word of as many bits, stand for the ends;
/// what such a word has besides stands for the roots. Bit 0 is set at an end, bit 1 for the far root and the near end.
const SOURCE: u32 = 2;
const FROM_NEAR: i64 = 0;
const FROM_FAR: i64 = -2;

/// The intervals of an object between the ends of the depth, by its class.
///
/// The roots are compared with the ends; then the source of each depth is chosen, in two bits; then one multiplexer a
/// depth takes it. Latency 3. Section 2.4.2.
pub fn depth_interval(at: &str, roots: Roots, object_class: Bits) -> Halves {
    let meaning = "class of the object: 0 side, 1 front, 2 patch, 3 prism";
    let inputs = (roots, ("object_class", object_class, meaning));
    module("depth_interval", at, inputs, |(roots, object_class)| {
        let width = roots.depth();
        let face = |number: u64| Bits::new(number, 4);
        let ends = |name: &str, sum: Int| {
            let [is_low, is_far] = Clamped::ends(name, sum);
            let late = |bit: Bits, what: &str| bit.delayed_as(&format!("{name}_{what}_late"), 1);
            [late(is_low, "is_low"), late(is_far, "is_far")]
        };
        let [near, far] = [ends("near", roots.near_sum), ends("far", roots.far_sum)];
        let roots = roots.delayed(1);
        let object_class = object_class.delayed_as("object_class_late", 1);
        let near = Clamped::with("near_late", near, roots.near_sum, NEAR_ROOT);
        let far = Clamped::with("far_late", far, roots.far_sum, FAR_ROOT);
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
            let from_near = near.source(Int::new(FROM_NEAR, SOURCE));
            let from_far = far.source(Int::new(FROM_FAR, SOURCE));
        }
        let [low, last] = [near_end, far_end].map(|of| end(of, SOURCE));
        let interval = |[zf, zb]: [Int; 2], [nf, nb]: [Bits; 2]| Interval { zf, nf, zb, nb };
        let absent = Interval::absent(SOURCE);
        let all = interval([low, last], [face(CAP), face(CAP)]);
        let side = interval([from_near, from_far], [near.face, face(FAR_ROOT)]);
        let before = interval([low, from_near], [face(CAP), face(NEAR_ROOT)]);
        let surface = Interval::of_surface([near_visible, far_visible], [from_near, from_far]);
        let kinds = [
            (is_prism, all),
            (is_surface, surface),
            (is_before, before),
            (is_side, side),
        ];
        let choose = |other: Interval, (holds, one): (Bits, Interval)| holds.select(one, other);
        let inside = kinds.into_iter().fold(absent, choose).called("inside");
        let outside = is_front.select(all, absent);
        let a = roots.is_inside.select(inside, outside);
        let a = roots.in_box.select(a, absent);
        let a = ("source_a", a).delayed(1).bare();
        net! {
            let source_b_zf = has_b.select(from_far, last).reg();
            let near_bits = roots.near_sum.low(width).reg();
            let far_bits = roots.far_sum.low(width).reg();
        }
        let [near_end, far_end] = [near_end, far_end].map(|of| end(of, width));
        let depth = |source: Int| {
            let [is_end, is_other] = [0, 1].map(|at| source.bit(at));
            let other = is_end.select(near_end, far_bits);
            is_other.select(other, is_end.select(far_end, near_bits))
        };
        let a = interval([a.zf, a.zb].map(depth), [a.nf, a.nb]);
        let faces_b = [far.face, face(CAP)].map(|one| has_b.select(one, face(0)).delay(2));
        Halves {
            a: a.registered(),
            // The same where it is absent: no register.
            b: interval([depth(source_b_zf).reg(), far_end], faces_b),
        }
    })
}
