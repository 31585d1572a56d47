//! Quadric object processor, first generation.

use super::{
    Contours, Network, Normal, NormalWords, Quadric, Visible, Widths, contour_choice,
    object_processor, plane_depth, roots, visible,
};
use crate::raster::{Linear, Quadratic, Scan, pe1, pe2};
use imogene_hdl::{Bits, Bundle, Value, bundles, net};

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
        normals: [Normal(widths.normal); 2] as "plane", "plane # (0 front, 1 back)";
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
/// lines decide. Latency `ceil(rows / rows_per_stage) + 6`. The words stay unchanged until that many clocks after the
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
        let (roots, root, late) = roots(scan, quadric.screen_box, f, network);
        let zp = |index: usize| {
            let at = format!("depths_{index}");
            plane_depth(&at, late, words.depths[index], network.depth)
        };
        let is_inside = |index: usize| {
            let conic = pe2(&format!("conics_{index}"), late, words.conics[index]);
            (!conic.is_negative()).reg()
        };
        let is_kept = |index: usize| {
            let polar = pe1(&format!("polars_{index}"), late, words.polars[index]);
            (!polar.is_negative()).reg()
        };
        net! {
            let front_inside = is_inside(0);
            let back_inside = is_inside(1);
            let front_middle = is_kept(0);
            let back_middle = is_kept(1);
        }
        let contours = Contours {
            surface: words.surface,
            front_zp: zp(0),
            back_zp: zp(1),
            front_inside,
            back_inside,
            middle_kept: front_middle & back_middle,
        };
        let seen = contour_choice("choice", roots, contours);
        let root = (root.delayed_as("root_late", 1), quadric.shift);
        let normals = NormalWords {
            gradients: quadric.gradients,
            planes: words.normals,
        };
        visible(late.delayed(3), seen, root, normals)
    })
}
