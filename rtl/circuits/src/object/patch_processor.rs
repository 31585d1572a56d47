//! Patch object processor.

use super::{
    HalfSpace, Network, NormalWords, PlaneAt, Quadric, Visible, Widths, object_processor,
    patch_decider, plane_depth, roots, visible,
};
use crate::raster::{Flags, Pixel};
use imogene_hdl::{Bundle, Value, bundles};

bundles! {
    /// Words of a bare surface cut by planes.
    Patch {
        /// The surface itself.
        quadric: Quadric as "";
        planes: Vec<HalfSpace> as "plane", "plane #";
    }
}

impl Patch {
    /// Words from outside of the design, with so many planes.
    pub fn input(widths: Widths, planes: u32) -> Patch {
        Patch {
            quadric: Quadric::input(widths),
            planes: HalfSpace::inputs(widths, planes),
        }
    }
}

/// Name of the module, and what numbers of faces it gives.
const KIND: (&str, &str) = ("patch_processor", "visible face: 0 near root, 1 far root");

/// For every pixel the visible face of a bare quadric surface cut by planes: depth, face and normal, as the quadric
/// processor gives them for class patch.
///
/// The planes decide in parallel, so the latency does not depend on their number, and there is neither a second half of
/// the depth interval nor a merge nor a normal of a plane. Latency `ceil(rows / rows_per_stage) + 7`. The words stay
/// unchanged until that many clocks after the last flags of a zone. Sections 2.4.3 and 5.2.1.
pub fn patch_processor(
    at: &str,
    flags: Flags,
    pixel: Pixel,
    words: Patch,
    depth: u32,
    network: Network,
) -> Visible {
    let inputs = (flags, pixel, words);
    object_processor(KIND, at, inputs, |flags, pixel, words| {
        let quadric = words.quadric;
        let f = (quadric.f1, quadric.f2);
        let (roots, root, late) = roots(flags, pixel, quadric.screen_box, f, network);
        let plane = |(index, plane): (usize, &HalfSpace)| PlaneAt {
            kind: plane.kind,
            zp: plane_depth(&format!("planes_{index}"), late, plane.linear, depth),
        };
        let planes = words.planes.iter().enumerate().map(plane).collect();
        let seen = patch_decider("decider", roots, planes, depth);
        let root = (root.delayed_as("root_late", 2), quadric.shift);
        let normals = NormalWords {
            gradients: quadric.gradients,
            planes: vec![],
        };
        visible(late.delayed(4), seen, root, normals)
    })
}
