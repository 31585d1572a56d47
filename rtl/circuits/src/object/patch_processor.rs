//! Patch object processor.

use super::{
    HalfSpace, Network, Quadric, Visible, Widths, object_processor, patch_decider, roots, visible,
};
use crate::raster::Scan;
use crate::rows::numbered;
use imogene_hdl::{Bundle, bundles};

bundles! {
    /// Words of a bare surface cut by planes.
    Patch(widths: Widths, planes: u32) {
        /// The surface itself.
        quadric: Quadric(widths) as "";
        planes: [HalfSpace(widths); planes] as "plane", "plane #";
    }
}

/// Name of the module, and what numbers of faces it gives.
const KIND: (&str, &str) = ("patch_processor", "visible face: 0 near root, 1 far root");

/// For every pixel the visible face of a bare quadric surface cut by planes: depth, face and normal, as the quadric
/// processor gives them for class patch.
///
/// The planes decide in parallel, so the latency does not depend on their number, and there is neither a second half of
/// the depth interval nor a merge nor a normal of a plane. Latency `ceil(rows / rows_per_stage) + 9`. The words stay
/// unchanged until that many clocks after the last flags of a zone. Sections 2.4.3 and 5.2.1.
pub fn patch_processor(at: &str, scan: Scan, words: Patch, network: Network) -> Visible {
    object_processor(KIND, at, (scan, words), |scan, words| {
        let quadric = words.quadric;
        let f = (quadric.f1, quadric.f2);
        let (roots, root, early) = roots(scan, quadric.screen_box, f, network);
        let late = early.delayed(1);
        let planes = numbered("planes", words.planes);
        let planes = planes.map(|(at, plane)| plane.at(&at, late, network.depth));
        let seen = patch_decider("decider", roots, planes.collect());
        let normal = (quadric.gradients, quadric.shift, None);
        visible(late.delayed(5), seen, (root, 3), normal)
    })
}
