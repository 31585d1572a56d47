//! The decider of solids: a union of products of convex objects.

use super::csg_product::{Extent, Sight, csg_product};
use crate::tree::tree;
use imogene_hdl::{Bits, Bundle, Value, bundle, join, module, net, ports};

bundle! {
    /// A convex object on a line of sight.
    Convex(depth) {
        zf: Int(depth), "front depth; 2^(W-1) - 1 where it is absent";
        zb: Int(depth), "back depth";
        id: Bits(8), "number of the object";
        number: Bits(4), "face at the front of an intersected object, at the back of one taken away";
    }

    /// What is seen of a solid.
    Solid(depth) {
        depth: Int(depth), "depth that is seen; 2^(W-1) - 1 where nothing is";
        id: Bits(8), "number of the object whose face is seen; 0 where nothing is";
        number: Bits(4), "face that is seen; 0 where nothing is";
        is_back: Bits(1), "it is the back of an object taken away: its normal is to be turned";
    }
}

/// What is seen of the union of products, each of which has as many objects intersected and as many taken away. Objects
/// taken away come `ceil(log2 intersected)` clocks after the others.
///
/// Normals are not passed on: shading makes them from id, number, depth and pixel, and turns them where `is_back` is
/// set. At equal depth a front goes before a back, then the smaller id. With the numbers of one product the latency is
/// `ceil(log2 intersected) + 1 + ceil(log2(products (subtracted + 1)))`. Chaillou 1991, III.1.1.4 and IV.3.5.
pub fn csg_decider(
    at: &str,
    products: usize,
    intersected: Vec<Convex>,
    subtracted: Vec<Convex>,
) -> Solid {
    let common = "intersected object #, product by product";
    let taken_away =
        "object # taken away, product by product, ceil(log2 I) clocks after the intersected";
    let subtracted = ("subtracted", subtracted, taken_away);
    let inputs = (("intersected", intersected, common), subtracted);
    module("csg_decider", at, inputs, |(intersected, subtracted)| {
        let own = |all: &[Convex], product: usize, is_back: u64| {
            let count = all.len() / products;
            let own = all[product * count..][..count].iter();
            own.map(|one| one.extent(is_back)).collect()
        };
        let candidates = (0..products).flat_map(|product| {
            let intersected = own(&intersected, product, 0);
            let subtracted = own(&subtracted, product, 1);
            csg_product(&format!("products_{product}"), intersected, subtracted)
        });
        let nearest = tree(candidates.collect(), nearer_face, "face_register");
        Solid {
            depth: nearest.depth,
            id: nearest.face.slice(11, 4),
            number: nearest.face.low(4),
            is_back: nearest.face.top(),
        }
    })
}

impl Convex {
    fn extent(&self, is_back: u64) -> Extent {
        Extent {
            zf: self.zf,
            zb: self.zb,
            face: join([Bits::new(is_back, 1), self.id, self.number]),
        }
    }
}

/// The nearer of two places, of two equally near the one of the smaller face word. Latency 1.
fn nearer_face(at: &str, a: Sight, b: Sight) -> Sight {
    module("nearer_face", at, ports!(a, b), |(a, b)| {
        net! {
            let depths_are_equal = b.depth.equals(a.depth);
            let b_wins = b.depth.less(a.depth) | (depths_are_equal & b.face.less(a.face));
        }
        b_wins.select(b, a).registered()
    })
}
