//! One product of a solid: what several convex objects have in common, without what others take away.

use crate::object::absent;
use crate::tree::tree;
use imogene_hdl::{Bits, Bundle, Int, Value, bundle, module, net, ports};

/// Bits of a face word: is a back, id, number.
pub(super) const FACE: u32 = 13;

bundle! {
    /// A convex object on a line of sight.
    Extent(depth) {
        zf: Int(depth), "front, the far end where it is absent";
        zb: Int(depth), "back";
        face: Bits(FACE), "face that can be seen: the front of an intersected object, the back of one taken away";
    }

    /// A place where a solid can be seen first.
    Sight(depth) {
        depth: Int(depth), "depth, the far end where nothing is seen";
        face: Bits(FACE), "face, 0 where nothing is seen";
    }
}

/// The depths at which a product can be seen first: the front of the intersection, and the back of every object taken
/// away. Objects taken away come `ceil(log2 intersected)` clocks after the others. Latency one more.
///
/// A candidate survives if nothing that is taken away covers the line behind it; a back, if it lies within the
/// intersection. The nearest survivor is the front of the product: where the line before a front that is not the
/// intersection's is outside, it is inside some object taken away that ends there.
pub fn csg_product(at: &str, intersected: Vec<Extent>, subtracted: Vec<Extent>) -> Vec<Sight> {
    let inputs = ports!(intersected, subtracted);
    module("csg_product", at, inputs, |(intersected, subtracted)| {
        let common = tree(intersected, overlap, "overlap_register");
        ("candidate", candidates(common, &subtracted))
    })
}

/// Where an intersection less some objects can be seen first.
fn candidates(common: Extent, subtracted: &[Extent]) -> Vec<Sight> {
    // The line behind a place is inside an object.
    let covers = |other: &Extent, place: Int| !place.less(other.zf) & place.less(other.zb);
    let end = absent(common.zf.width());
    net! {
        let is_there = !common.zb.less(common.zf) & common.zf.less(end);
        let is_sheet = common.zf.equals(common.zb);
        // What has no thickness is covered by an object that ends at it, too.
        let front_is_seen = subtracted.iter().fold(is_there, |is_seen, other| {
            let ends = is_sheet & common.zf.equals(other.zb) & !common.zf.less(other.zf);
            is_seen & !(covers(other, common.zf) | ends)
        });
    }
    let mut candidates = vec![(front_is_seen, common.zf, common.face)];
    for (index, own) in subtracted.iter().enumerate() {
        // What has no thickness, or is absent, takes nothing away and has no back to show.
        let is_within = own.zf.less(own.zb) & common.zf.less(own.zb) & own.zb.less(common.zb);
        let others = [&subtracted[..index], &subtracted[index + 1..]].concat();
        let others = others.iter();
        let is_seen = others.fold(is_within, |all, other| all & !covers(other, own.zb));
        let is_seen = is_seen.named(&format!("back_{index}_is_seen"));
        candidates.push((is_seen, own.zb, own.face));
    }
    let nothing = Sight {
        depth: end,
        face: Bits::new(0, FACE),
    };
    let sight = |(is_seen, depth, face): (Bits, Int, Bits)| {
        is_seen.select(Sight { depth, face }, nothing).registered()
    };
    candidates.into_iter().map(sight).collect()
}

/// What two convex objects have in common: the farther front, of two at one depth the one of the smaller face word, and
/// the nearer back. Latency 1.
fn overlap(at: &str, a: Extent, b: Extent) -> Extent {
    module("overlap", at, ports!(a, b), |(a, b)| {
        net! { let b_is_front = a.zf.less(b.zf) | (a.zf.equals(b.zf) & b.face.less(a.face)); }
        let common = Extent {
            zf: b_is_front.select(b.zf, a.zf),
            zb: b.zb.less(a.zb).select(b.zb, a.zb),
            face: b_is_front.select(b.face, a.face),
        };
        common.registered()
    })
}
