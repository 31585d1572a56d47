//! What planes leave of a quadric.

use super::clamped::Clamped;
use super::ends::{fits, is_behind_near_end};
use super::{Limits, Roots, Seen, absent, end};
use imogene_contract::words::{
    CAP, FAR_ROOT, FRONT, NEAR_ROOT, PATCH, PRISM, SIDE, near_end, saturated_near,
};
use imogene_hdl::{Bits, Bundle, Ports, Value, bundle, module, net};

bundle! {
    /// What of the line of sight is in the object before planes cut it.
    Parts() {
        between: Bits(1), "from root to root";
        before: Bits(1), "from the near end to the near root";
        behind: Bits(1), "from the far root to the far end, perhaps with what is before the near root";
        all: Bits(1), "from end to end";
        near_point: Bits(1), "the near root alone";
        far_point: Bits(1), "the far root alone";
        near_is_low: Bits(1), "the near root is before the near end";
        far_is_low: Bits(1), "the far root is before the near end";
    }

    /// Both roots within the depth word.
    Within(depth) {
        near_root: Int(depth), "near root";
        far_root: Int(depth), "far root";
    }

    /// How planes lie to the roots and the ends.
    Order() {
        front_hides_near: Bits(1), "the near root lies before a front plane";
        front_hides_far: Bits(1), "the far root lies before a front plane";
        back_hides_near: Bits(1), "the near root lies behind a back plane";
        back_hides_far: Bits(1), "the far root lies behind a back plane";
        has_front: Bits(1), "a front plane lies behind the near end";
        front_is_last: Bits(1), "a front plane lies at the far end";
        nothing_left: Bits(1), "the planes leave nothing of the whole line";
    }

    /// Where both ends of what is left are.
    Sources(depth) {
        front_is_root: Bits(1), "the front is a root, or with front_is_plane the near end";
        front_is_plane: Bits(1), "the front is a plane, or with front_is_root the near end";
        back_is_root: Bits(1), "the back is a root";
        back_is_plane: Bits(1), "the back is a plane";
        front_root: Int(depth), "the root";
        back_root: Int(depth), "the root";
        face: Bits(4), "face of the root or of the near end";
    }
}

/// The visible front and its back of a quadric, of which planes leave what lies between two limits.
///
/// The source opens an interval, or two, and cuts them plane by plane. A chain of cuts looks only for the farthest
/// front plane and the nearest back plane, so the roots are compared with these two. Where nothing is left before the
/// near root, what is left behind the far one is seen. Latency 5: roots within the depth word in two clocks, the
/// comparisons, the choice, the depths. Section 2.4.2.
pub fn quadric_cut(at: &str, roots: Roots, object_class: Bits, limits: Limits) -> Seen {
    let meaning = "class of the object: 0 side, 1 front, 2 patch, 3 prism";
    let object_class = ("object_class", object_class, meaning);
    let limits = ("", limits, "two clocks after the roots");
    let inputs = (roots, (object_class, limits));
    module(
        "quadric_cut",
        at,
        inputs,
        |(roots, (object_class, limits))| {
            let (parts, within) = opened(roots, object_class);
            let order = ordered(within, limits);
            let parts = ("parts", parts).delayed(1).bare();
            let sources = chosen(parts, order, within.delayed(1));
            let sources = ("sources", sources).delayed(1).bare();
            let limits = limits.delayed(2);
            let width = limits.front.width();
            let (is_root, is_plane) = (sources.front_is_root, sources.front_is_plane);
            let low = end(near_end, width);
            let front = is_plane.select(limits.front, absent(width));
            let back = sources.back_is_plane.select(limits.back, absent(width));
            let plane = is_plane.select(limits.front_number, Bits::new(0, 4));
            let seen = Seen {
                zf: is_root.select(is_plane.select(low, sources.front_root), front),
                zb: sources.back_is_root.select(sources.back_root, back),
                number: is_root.select(sources.face, plane),
            };
            seen.registered()
        },
    )
}

/// The object before planes cut it, and both roots within the depth word, two clocks later.
fn opened(roots: Roots, object_class: Bits) -> (Parts, Within) {
    let [near_is_low, _] = Clamped::ends("near", roots.near_sum);
    let [far_is_low, far_is_far] = Clamped::ends("far", roots.far_sum);
    // A near root at the far end is drawn as nothing, so it need not be told from one before it.
    let near_is_far = !roots.near_sum.is_negative() & !fits(roots.near_sum, roots.depth());
    let late = |name: &str, bit: Bits| bit.delayed_as(&format!("{name}_late"), 1);
    let near = [
        late("near_is_low", near_is_low),
        late("near_is_far", near_is_far),
    ];
    let far = [
        late("far_is_low", far_is_low),
        late("far_is_far", far_is_far),
    ];
    let object_class = object_class.delayed_as("object_class_late", 1);
    let roots = roots.delayed(1);
    let near = Clamped::with("near_late", near, roots.near_sum, NEAR_ROOT);
    let far = Clamped::with("far_late", far, roots.far_sum, FAR_ROOT);
    let is = |class: u64| object_class.is(class);
    net! {
        let is_inside = roots.in_box & roots.is_inside;
        let is_outside = roots.in_box & !roots.is_inside;
        let is_front = is(FRONT);
        let is_in_front = is_front & is_inside;
        let is_surface = is(PATCH) & is_inside;
    }
    let parts = Parts {
        between: is(SIDE) & is_inside & !(near.is_far | far.is_low),
        before: is_in_front & !near.is_low,
        behind: is_in_front & !far.is_far,
        all: (is(PRISM) & is_inside) | (is_front & is_outside),
        near_point: is_surface & near.is_visible(),
        far_point: is_surface & far.is_visible(),
        near_is_low: near.is_low,
        far_is_low: far.is_low,
    };
    let within = Within {
        near_root: near.depth,
        far_root: far.depth,
    };
    (("parts", parts).delayed(1).bare(), within.delayed(1))
}

/// Latency 1.
fn ordered(within: Within, limits: Limits) -> Order {
    let (near_root, far_root) = (within.near_root, within.far_root);
    let width = near_root.width();
    let Limits { front, back, .. } = limits;
    // No plane lies before the near end but one at the least word, which the near end follows.
    let lowest = end(saturated_near, width);
    let order = Order {
        front_hides_near: near_root.less(front),
        front_hides_far: far_root.less(front),
        back_hides_near: back.less(near_root),
        back_hides_far: back.less(far_root),
        has_front: is_behind_near_end(front),
        front_is_last: front.equals(absent(width)),
        nothing_left: limits.removed | back.less(front) | back.equals(lowest),
    };
    ("order", order).delayed(1).bare()
}

/// Latency 0.
fn chosen(parts: Parts, order: Order, within: Within) -> Sources {
    let (near_root, far_root) = (within.near_root, within.far_root);
    net! {
        let is_left = !order.nothing_left;
        let between = parts.between & is_left & !(order.front_hides_far | order.back_hides_near);
        let before = parts.before & is_left & !order.front_hides_near;
        let all = parts.all & is_left;
        let behind = parts.behind & is_left & !(before | order.back_hides_far | order.front_is_last);
        let near_point = parts.near_point & is_left & !(order.front_hides_near | order.back_hides_near);
        let far_point = parts.far_point & is_left & !(order.front_hides_far | order.back_hides_far);
        let from_end = before | all;
        let at_plane = (between & order.front_hides_near) | (behind & order.front_hides_far);
        let at_root = between | behind | near_point | far_point;
        let cut_behind = (between & order.back_hides_far) | (before & order.back_hides_near);
        let front_is_far = !(parts.between | near_point);
        let back_is_far = parts.between | far_point;
    }
    let face = |is_low: Bits, root: u64| is_low.select(Bits::new(CAP, 4), Bits::new(root, 4));
    let [near_face, far_face] = [
        face(parts.near_is_low, NEAR_ROOT),
        face(parts.far_is_low, FAR_ROOT),
    ];
    let root_face = front_is_far.select(far_face, near_face);
    Sources {
        front_is_root: (at_root & !at_plane) | (from_end & !order.has_front),
        front_is_plane: at_plane | from_end,
        back_is_root: (between | before | near_point | far_point) & !cut_behind,
        back_is_plane: cut_behind | all | behind,
        front_root: front_is_far.select(far_root, near_root),
        back_root: back_is_far.select(far_root, near_root),
        face: from_end.select(Bits::new(CAP, 4), root_face),
    }
}
