//! A product of a solid: what convex objects have in common, without what others take away (source: Chaillou, III.1.1.4
//! and IV.3.5).
//!
//! The union of products is the nearest of them, which the decider finds.

use crate::unit::half_spaces::tree_levels;
use std::collections::BTreeSet;

/// A convex object on a line of sight, both ends included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Front depth; the far end of the format where the object is absent.
    pub zf: i64,
    /// Back depth.
    pub zb: i64,
}

/// What is seen of a product.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Front {
    /// Depth.
    pub depth: i64,
    /// The object whose face it is: the front of an intersected one, or the back of one taken away, which are counted
    /// on behind the intersected ones.
    pub object: usize,
}

/// Places on the line of sight: `2 z` is the point at depth z, `2 z + 1` all that lies between it and the next.
fn holds(extent: &Extent, place: i64, z_max: i64) -> bool {
    extent.zf < z_max && (2 * extent.zf..=2 * extent.zb).contains(&place)
}

/// The first point of a product of objects intersected, one at least, and objects taken away, or the first one with
/// points of it just behind. Of faces at the same depth the first.
pub fn front(intersected: &[Extent], subtracted: &[Extent], z_max: i64) -> Option<Front> {
    let contains = |place: i64| {
        let at = |extent: &Extent| holds(extent, place, z_max);
        intersected.iter().all(at) && !subtracted.iter().any(at)
    };
    // A front lies at a face.
    let fronts = intersected.iter().map(|extent| extent.zf);
    let backs = subtracted.iter().map(|extent| extent.zb);
    let faces: BTreeSet<i64> = fronts.chain(backs).filter(|&z| z < z_max).collect();
    let is_seen = |&z: &i64| contains(2 * z) || contains(2 * z + 1);
    let depth = faces.into_iter().find(is_seen)?;
    let front = intersected.iter().position(|extent| extent.zf == depth);
    let is_back = |extent: &Extent| extent.zb == depth && extent.zf < extent.zb;
    let back = || Some(intersected.len() + subtracted.iter().position(is_back)?);
    front.or_else(back).map(|object| Front { depth, object })
}

/// Clocks after the intersected objects at which those taken away are used: the tree of the intersection comes first.
pub const fn skew(intersected: usize) -> usize {
    tree_levels(intersected) as usize
}

/// Latency in clocks from the intersected objects: the intersection, two clocks for the candidates, the choice among
/// them.
pub const fn latency(intersected: usize, subtracted: usize) -> u32 {
    tree_levels(intersected) + 2 + tree_levels(1 + subtracted)
}
