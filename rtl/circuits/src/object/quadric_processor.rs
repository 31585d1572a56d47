//! Quadric object processor, second generation.

use super::{
    Gradients, HalfSpace, Limits, Network, Plane, Roots, Visible, Words, object_processor,
    quadric_cut, roots, visible,
};
use crate::raster::{Flags, Scan};
use crate::tree::levels;
use imogene_hdl::{Bits, Bundle};

/// Name of the module, and what numbers of faces it gives.
const KIND: (&str, &str) = (
    "quadric_processor",
    "visible face: 0 near root, 1 far root, 2 + i plane i, 15 near end",
);

/// Levels of a tree over planes for which the roots wait: they come when one over four planes is done.
pub fn levels_beyond(planes: usize) -> u32 {
    levels(planes).saturating_sub(2)
}

/// For every pixel the visible front of one quadric object cut by planes: depth, face and normal.
///
/// A quadric PE, a tree over the planes beside it, what the planes leave, and its normal. Latency
/// `ceil(rows / rows_per_stage) + 11`, and one more for each doubling of more than four planes. The words stay
/// unchanged until that many clocks after the last flags of a zone. Section 2.4.2.
pub fn quadric_processor(at: &str, scan: Scan, words: Words, network: Network) -> Visible {
    object_processor(KIND, at, (scan, words), |scan, words| {
        let quadric = words.quadric;
        let f = (quadric.f1, quadric.f2);
        let (roots, root, early) = roots(scan, quadric.screen_box, f, network);
        let (found, normal) = ((roots, root), (quadric.gradients, quadric.shift));
        cut_by_planes(early, found, words.object_class, normal, words.planes)
    })
}

/// What planes leave of a quadric, from the flags of three clocks before its roots and what changes its normal, which
/// come together. Latency 9 from the roots, and [`levels_beyond`].
pub(super) fn cut_by_planes(
    flags: Flags,
    (roots, root): (Roots, Bits),
    object_class: Bits,
    (gradients, shift): (Gradients, Bits),
    planes: Vec<Plane>,
) -> Visible {
    let (levels, wait) = (levels(planes.len()), levels_beyond(planes.len()));
    let half_spaces: Vec<HalfSpace> = planes.iter().map(|plane| plane.half_space).collect();
    let normals = planes.iter().map(|plane| plane.normal).collect();
    let words = (gradients, shift, Some(normals));
    let start = flags.delayed(2 + wait - levels);
    let limits = Limits::of(start, &half_spaces, roots.depth());
    let seen = quadric_cut("cut", roots.delayed(wait), object_class, limits);
    visible(flags.delayed(8 + wait), seen, (root, 5 + wait), words)
}
