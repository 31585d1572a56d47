//! Quadric object processor, first generation.

use super::{
    Contours, Network, Normal, Quadric, Visible, Widths, contour_choice, object_processor,
    plane_depth, roots, visible,
};
use crate::raster::{Linear, Quadratic, Scan, pe1, pe2};
use imogene_hdl::{Bits, Bundle, Int, bundles, net};

bundles! {
    /// Words of a quadric between a front plane (0) and a back plane (1).
    FirstGeneration(widths: Widths) {
        /// The quadric itself.
        quadric: Quadric(widths) as "";
        surface: Bits(1) as "surface", "the object is a bare surface, not a solid";
        depths: [Linear(widths.plane); 2] as "depth", "depth of plane # (0 front, 1 back)";
        conics: [Quadratic(widths.quadratic); 2] as "conic",
            "not negative where plane # (0 front, 1 back) is inside the quadric";
        polars: [Linear(widths.plane); 2] as "polar",
            "negative where plane # (0 front, 1 back) has the middle of the quadric on its removed side";
        /// The back plane is never seen.
        normals: [Normal(widths.normal); 1] as "plane", "plane # (0 front)";
    }
}

/// Name of the module, and what numbers of faces it gives.
const KIND: (&str, &str) = (
    "first_generation_processor",
    "visible face: 0 near root, 1 far root, 2 front plane, 15 near end",
);

/// For every pixel the visible face of a quadric seen from outside between two parallel planes, found by contours on
/// the screen.
///
/// Kept as the reference for the second generation: no depth is compared with another; the signs of two conics and two
/// lines decide. Latency `ceil(rows / rows_per_stage) + 9`. The words stay unchanged until that many clocks after the
/// last flags of a zone. Section 2.4.1, its algorithm corrected.
pub fn first_generation_processor(
    at: &str,
    scan: Scan,
    words: FirstGeneration,
    network: Network,
) -> Visible {
    object_processor(KIND, at, (scan, words), |scan, words| {
        let quadric = words.quadric;
        let f = (quadric.f1, quadric.f2);
        let (roots, root, early) = roots(scan, quadric.screen_box, f, network);
        let late = early.delayed(1);
        let holds = |value: Int| !value.is_negative();
        // A clock behind the planes, whose depths are clamped: no flag begins all polynomials at once.
        let later = late.delayed(1);
        net! {
            let front_inside = holds(pe2("conics_0", later, words.conics[0]));
            let back_inside = holds(pe2("conics_1", later, words.conics[1]));
            let front_middle = holds(pe1("polars_0", later, words.polars[0]));
            let back_middle = holds(pe1("polars_1", later, words.polars[1]));
        }
        let zp = |at: &str, plane: Linear| plane_depth(at, late, plane, network.depth);
        let contours = Contours {
            surface: words.surface,
            front_zp: zp("depths_0", words.depths[0]),
            back_zp: zp("depths_1", words.depths[1]),
            front_inside,
            back_inside,
            middle_kept: front_middle & back_middle,
        };
        let seen = contour_choice("choice", roots, contours);
        let normal = (quadric.gradients, quadric.shift, Some(words.normals));
        visible(late.delayed(5), seen, (root, 3), normal)
    })
}
