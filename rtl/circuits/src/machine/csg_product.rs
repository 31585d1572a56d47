//! One product of a solid: what several convex objects have in common, without what others take away.

use super::Candidate;
use super::decider::NEAREST;
use crate::object::{Visible, absent};
use crate::rows::numbered;
use crate::tree::{levels, tree};
use imogene_contract::object::ProductSlots;
use imogene_contract::words::CAP;
use imogene_hdl::{Bits, Bundle, Int, Value, bundles, module, net};

bundles! {
    /// A convex object on a line of sight.
    #[derive(Copy)]
    Extent(depth: u32, normal: u32, id: u32) {
        /// The face that can be seen: the front of an intersected object, the back of one taken away.
        face: Candidate(depth, normal, id) as "", "face that can be seen: front where intersected, back where taken away";
        end: Int(depth) as "other_end", "depth of its other end";
    }
}

/// Clocks from what each object of a product sees to what is seen of the product.
pub(super) fn product_clocks(product: &ProductSlots) -> Vec<u32> {
    let taken_away = 2 + levels(1 + product.subtracted);
    let kept = levels(product.intersected) + taken_away;
    let (intersected, subtracted) = (product.intersected, product.subtracted);
    [vec![kept; intersected], vec![taken_away; subtracted]].concat()
}

/// What is seen of products, whose objects are those given, product by product.
pub(super) fn products(
    at: &str,
    mut objects: &[Extent],
    products: &[ProductSlots],
) -> Vec<Candidate> {
    let one = |(at, product): (String, &ProductSlots)| {
        let (own, others) = objects.split_at(product.count());
        let (kept, taken_away) = own.split_at(product.intersected);
        let taken_away = taken_away.iter().map(Extent::reversed).collect();
        objects = others;
        csg_product(&at, kept.to_vec(), taken_away)
    };
    numbered(at, products).map(one).collect()
}

impl Extent {
    /// What the processor of an object sees.
    pub(super) fn of(seen: Visible, id: Bits) -> Extent {
        let face = Candidate {
            depth: seen.front.zf,
            id,
            number: seen.number,
            normal: seen.normal,
        };
        let end = seen.front.zb;
        Extent { face, end }
    }

    /// An object that is loaded as it is seen from behind, its depths complemented: the back is in front. What reaches
    /// the far end has its cap there.
    fn reversed(&self) -> Extent {
        let Extent { face, end } = *self;
        let complement = |depth: Int| (!depth.bits()).int();
        let far = absent(face.depth.width());
        Extent {
            face: Candidate {
                depth: face.number.is(CAP).select(far, complement(face.depth)),
                ..face
            },
            end: complement(end),
        }
    }
}

/// What is seen of a product. Objects taken away come `ceil(log2 I)` clocks after the intersected ones.
///
/// A candidate survives if nothing that is taken away covers the line behind it; a back, if it lies within the
/// intersection. The nearest survivor is the front of the product: where the line before a front that is not the
/// intersection's is outside, it is inside some object taken away that ends there. At equal depth the earlier of the
/// inputs wins. An absent object has its front at the far end; taken away, both ends before the near end. With I
/// objects intersected and J taken away the latency is `ceil(log2 I) + 2 + ceil(log2(J + 1))`. Chaillou 1991,
/// III.1.1.4 and IV.3.5.
pub fn csg_product(at: &str, intersected: Vec<Extent>, subtracted: Vec<Extent>) -> Candidate {
    let common = "intersected object #";
    let taken_away = "object # taken away, ceil(log2 I) clocks after the intersected";
    let subtracted = ("subtracted", subtracted, taken_away);
    let inputs = (("intersected", intersected, common), subtracted);
    module("csg_product", at, inputs, |(intersected, subtracted)| {
        let common = intersection("intersection", intersected);
        let candidates = candidates(common, &subtracted);
        ("", tree(candidates, nearer_face, "face_register"), NEAREST)
    })
}

/// What all objects have in common. Latency `ceil(log2 I)`.
fn intersection(at: &str, objects: Vec<Extent>) -> Extent {
    module("csg_intersection", at, ("object", objects), |objects| {
        tree(objects, overlap, "overlap_register")
    })
}

/// Where an intersection less some objects can be seen first. Latency 2.
fn candidates(common: Extent, subtracted: &[Extent]) -> Vec<Candidate> {
    // The line behind a place is inside an object.
    let covers = |other: &Extent, place: Int| !place.less(other.end) & place.less(other.face.depth);
    let (front, back) = (common.face.depth, common.end);
    let far = absent(front.width());
    net! {
        let is_there = !back.less(front) & !front.equals(far);
        let is_sheet = front.equals(back);
        // What has no thickness is covered by an object that ends at it, too.
    }
    let is_left = |other: &Extent| {
        let ends = is_sheet & front.equals(other.face.depth) & !front.less(other.end);
        !(covers(other, front) | ends)
    };
    let tests = std::iter::once(is_there).chain(subtracted.iter().map(is_left));
    let mut candidates = vec![(all_hold("front", tests), common.face)];
    for (index, own) in subtracted.iter().enumerate() {
        let end = own.face.depth;
        // What has no thickness, or is absent, takes nothing away and has no back to show.
        let is_within = own.end.less(end) & front.less(end) & end.less(back);
        let others = [&subtracted[..index], &subtracted[index + 1..]].concat();
        let tests = others.iter().map(|other| !covers(other, end));
        let tests = std::iter::once(is_within).chain(tests);
        candidates.push((all_hold(&format!("back_{index}"), tests), own.face));
    }
    let candidates = candidates.into_iter();
    candidates
        .map(|(is_seen, face)| {
            let face = face.delayed(1);
            is_seen.select(face, nothing(&face)).registered()
        })
        .collect()
}

/// All tests hold; each has a register of its own, for the choice of a face has time left to join them. Latency 1.
fn all_hold(name: &str, tests: impl Iterator<Item = Bits>) -> Bits {
    let tests = numbered(&format!("{name}_test"), tests);
    let kept = tests.map(|(name, test)| test.delayed_as(&name, 1));
    kept.reduce(|all, test| all & test)
        .expect("one test at least")
}

/// Nothing is seen.
fn nothing(like: &Candidate) -> Candidate {
    Candidate {
        depth: absent(like.depth.width()),
        id: Bits::new(0, like.id.width()),
        number: Bits::new(0, like.number.width()),
        normal: like.normal.map(|part| Int::new(0, part.width())),
    }
}

/// What two convex objects have in common: the farther front, of two at one depth the first, and the nearer back.
/// Latency 1.
fn overlap(at: &str, a: Extent, b: Extent) -> Extent {
    module("overlap", at, (("a", a), ("b", b)), |(a, b)| {
        let common = Extent {
            face: a.face.depth.less(b.face.depth).select(b.face, a.face),
            end: b.end.less(a.end).select(b.end, a.end),
        };
        common.registered()
    })
}

/// The nearer of two faces, of two equally near the first. Latency 1.
fn nearer_face(at: &str, a: Candidate, b: Candidate) -> Candidate {
    module("nearer_face", at, (("a", a), ("b", b)), |(a, b)| {
        b.depth.less(a.depth).select(b, a).registered()
    })
}
