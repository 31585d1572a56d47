//! The intersection of half-spaces along a line of sight: the nearest and the farthest point that all planes keep
//! (source: annex A).
//!
//! The source cuts the full depth interval in a chain. Cutting a full interval only looks for the greatest depth of the
//! front planes and the least of the back planes, so two trees of comparators of the same size find it in `ceil(log2
//! N)` clocks.

use super::cut_plane::PlaneKind;
use super::depth_interval::{FACE_NEAR_END, FACE_PLANE, Interval};
use crate::format::Format;

/// One branch of the tree: what its planes leave.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Branch {
    /// Greatest depth of a front plane and its face number.
    pub front: (i64, u8),
    /// Least depth of a back plane and its face number.
    pub back: (i64, u8),
    /// A perpendicular plane removes the pixel.
    pub removed: bool,
}

/// What plane `index` of saturated depth (or value) `zp` says by itself; where it says nothing, a depth that loses to
/// every plane.
#[inline]
pub const fn leaf(kind: PlaneKind, zp: i64, index: usize, format: &Format) -> Branch {
    let number = FACE_PLANE + index as u8;
    let mut branch = Branch {
        front: (format.plane_low(), number),
        back: (format.z_max(), number),
        removed: false,
    };
    match kind {
        PlaneKind::None => {}
        PlaneKind::Front => branch.front.0 = zp,
        PlaneKind::Back => branch.back.0 = zp,
        PlaneKind::Perpendicular => branch.removed = zp < 0,
    }
    branch
}

/// A node of the tree; at equal depths the first branch wins, which holds the smaller indices.
#[inline]
pub const fn node(a: Branch, b: Branch) -> Branch {
    let is_front_of_a = a.front.0 >= b.front.0;
    Branch {
        front: if is_front_of_a { a.front } else { b.front },
        back: if a.back.0 <= b.back.0 { a.back } else { b.back },
        removed: a.removed || b.removed,
    }
}

/// The tree over all leaves, level by level; an odd one out passes a register. None without a leaf.
pub fn tree(mut level: Vec<Branch>) -> Option<Branch> {
    while level.len() > 1 {
        level = level
            .chunks(2)
            .map(|pair| match *pair {
                [a, b] => node(a, b),
                _ => pair[0],
            })
            .collect();
    }
    level.first().copied()
}

/// Levels of the tree over `planes` leaves.
pub const fn tree_levels(planes: usize) -> u32 {
    planes.next_power_of_two().trailing_zeros()
}

/// The interval that is left: the planes against each other and against both ends of the depth word, whose face is the
/// near end's cap.
#[inline]
pub const fn close(branch: Branch, there: bool, format: &Format) -> Interval {
    let low = (format.z_low(), FACE_NEAR_END);
    let end = (format.z_max(), FACE_NEAR_END);
    let is_later = branch.front.0 > low.0;
    let front = if is_later { branch.front } else { low };
    let is_earlier = branch.back.0 < end.0;
    let back = if is_earlier { branch.back } else { end };
    if there && !branch.removed && front.0 <= back.0 && front.0 < end.0 {
        Interval::new(front, back)
    } else {
        Interval::absent(format)
    }
}
