//! From two roots to intervals, by class.

use super::{Interval, absent, depth};
use imogene_contract::words::{
    CAP, FAR_ROOT, FRONT, NEAR_ROOT, PATCH, PRISM, SIDE, far_end, near_end,
};
use imogene_hdl::{Bits, Bundle, Int, Value, bundle, bundles, module, net};

bundle! {
    /// What the roots of a quadric say of a pixel.
    Roots(sum) {
        near_sum: Int(sum), "depth of the near root";
        far_sum: Int(sum), "depth of the far root";
        is_inside: Bits(1), "the discriminant is not negative";
        in_box: Bits(1), "the pixel lies in the screen box";
        object_class: Bits(2), "class of the object";
    }
}

bundles! {
    /// The two halves of an object.
    Halves {
        a: Interval as "_a", "half A, the one of all classes";
        b: Interval as "_b", "half B, behind the far root of the class front";
    }
}

/// One root within the range of the depth: clamped to the near end, where its face is the cap, and to the far end.
struct Clamped {
    is_low: Bits,
    is_far: Bits,
    depth: Int,
    face: Bits,
}

/// The intervals of an object between the ends of the depth, by its class.
///
/// Latency 1. Section 2.4.2.
pub fn depth_interval(at: &str, roots: Roots, width: u32) -> Halves {
    module("depth_interval", at, roots, |roots| {
        let [low, far] = [near_end, far_end].map(|end| end(width as usize));
        let face = |number: u64| Bits::new(number, 4);
        let clamped = |name: &str, sum: Int, number: u64| {
            let is_low = sum
                .less(Int::new(low, sum.width()))
                .named(&format!("{name}_is_low"));
            let is_far = (!sum.less(Int::new(far, sum.width()))).named(&format!("{name}_is_far"));
            let within = is_far.select(absent(width), sum.low(width));
            Clamped {
                depth: is_low
                    .select(depth(low, width), within)
                    .named(&format!("{name}_depth")),
                face: is_low
                    .select(face(CAP), face(number))
                    .named(&format!("{name}_face")),
                is_low,
                is_far,
            }
        };
        let near = clamped("near", roots.near_sum, NEAR_ROOT);
        let far = clamped("far", roots.far_sum, FAR_ROOT);
        let is = |class: u64| roots.object_class.is(class);
        net! {
            let near_visible = !(near.is_low | near.is_far);
            let far_visible = !(far.is_low | far.is_far);
            let is_front = is(FRONT);
        }
        let interval = |[zf, zb]: [Int; 2], [nf, nb]: [Bits; 2]| Interval { zf, nf, zb, nb };
        let nothing = Interval::absent(width);
        let all = interval([depth(low, width), absent(width)], [face(CAP), face(CAP)]);
        let side = interval([near.depth, far.depth], [near.face, face(FAR_ROOT)]);
        let before = interval(
            [depth(low, width), near.depth],
            [face(CAP), face(NEAR_ROOT)],
        );
        let behind = interval([far.depth, absent(width)], [far.face, face(CAP)]);
        // A bare surface has a point at each root that is between the ends.
        let at = |root: &Clamped, number: u64| (root.depth, face(number));
        let patch = {
            let (zf, nf) = at(&near, NEAR_ROOT);
            let (zb, nb) = at(&far, FAR_ROOT);
            let zf = near_visible.select(zf, zb);
            let nf = near_visible.select(nf, nb);
            interval(
                [zf, far_visible.select(zb, zf)],
                [nf, far_visible.select(nb, nf)],
            )
        };
        let inside = [
            (is(SIDE) & !(near.is_far | far.is_low), &side),
            (is_front & !near.is_low, &before),
            (is(PATCH) & (near_visible | far_visible), &patch),
            (is(PRISM), &all),
        ];
        let inside = inside
            .iter()
            .rev()
            .fold(nothing, |other, (holds, one)| holds.select(**one, other));
        let outside = is_front.select(all, nothing);
        let a = roots.is_inside.select(inside, outside);
        let has_b = roots.is_inside & is_front & !far.is_far;
        Halves {
            a: roots.in_box.select(a, nothing).registered(),
            b: (roots.in_box & has_b).select(behind, nothing).registered(),
        }
    })
}
