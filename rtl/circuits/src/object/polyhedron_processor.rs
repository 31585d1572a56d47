//! Convex polyhedron processor.

use super::{
    Front, IN_ZONE, Normal, Plane, PlaneAt, ScreenBox, Widths, constant_normal, half_spaces,
    plane_depth,
};
use crate::raster::{Flags, Pixel};
use imogene_hdl::{Bits, Bundle, Int, Value, bundles, module};

bundles! {
    /// Words of a convex solid of planes, with their outward normals.
    Polyhedron {
        /// Where it may be.
        screen_box: ScreenBox as "";
        planes: Vec<Plane> as "plane", "plane #";
    }

    /// A back face.
    BackFace {
        number: Bits as "number", "face at zb: 2 + i plane i, 15 far end";
        normal: Normal as "", "face at zb";
    }

    /// Both faces of a solid at a pixel.
    BothFaces {
        /// Both depths.
        front: Front as "";
        number: Bits as "number", "visible face: 2 + i plane i, 15 near end";
        normal: Normal as "", "visible face";
        /// The back face.
        back: BackFace as "back";
    }
}

impl Polyhedron {
    /// Words from outside of the design, with so many planes.
    pub fn input(widths: Widths, planes: u32) -> Polyhedron {
        Polyhedron {
            screen_box: ScreenBox::input(),
            planes: (0..planes).map(|_| Plane::input(widths)).collect(),
        }
    }
}

/// For every pixel the front and back depth of a convex solid of planes, with faces and normals; the normal of an end
/// of the depth word is the direction to it.
///
/// A solid without thickness is there. Latency `ceil(log2 planes) + 4`. The words stay unchanged until that many clocks
/// after the last flags of a zone. Annex A.
pub fn polyhedron_processor(
    at: &str,
    flags: Flags,
    pixel: Pixel,
    words: Polyhedron,
    depth: u32,
) -> BothFaces {
    let inputs = (flags, ("", pixel, IN_ZONE), words);
    module(
        "polyhedron_processor",
        at,
        inputs,
        |(flags, (_, pixel, _), words)| {
            let plane = |(index, plane): (usize, &Plane)| PlaneAt {
                kind: plane.kind,
                zp: plane_depth(&format!("planes_{index}"), flags, plane.linear, depth),
            };
            let planes = words.planes.iter().enumerate().map(plane).collect();
            let levels = words.planes.len().next_power_of_two().ilog2();
            let in_box = words.screen_box.contains(pixel);
            let in_box = in_box.delayed_as("in_box_late", levels + 2);
            let kept = half_spaces("half_spaces", planes, in_box);
            let normals: Vec<Normal> = words.planes.iter().map(|plane| plane.normal).collect();
            let normal = |at: &str, number: Bits, sign: i64| {
                let width = normals[0].nz.width();
                let end_nz = Int::new(sign * ((1 << (width - 1)) - 1), width);
                plane_normal(at, number, end_nz, &normals)
            };
            let out_valid = flags.valid.delayed_as("valid_late", levels + 4);
            let seen = kept.seen().delayed(1);
            BothFaces {
                front: seen.front(out_valid),
                number: seen.number,
                normal: normal("front_normal", kept.nf, -1),
                back: BackFace {
                    number: kept.nb.delayed_as("back_number_late", 1),
                    normal: normal("back_normal", kept.nb, 1),
                },
            }
        },
    )
}

/// The normal of a face that is a plane or an end of the depth word, else zero. Latency 1.
fn plane_normal(at: &str, number: Bits, end_nz: Int, planes: &[Normal]) -> Normal {
    let inputs = (
        ("number", number),
        ("end_nz", end_nz),
        ("plane", planes.to_vec()),
    );
    module(
        "plane_normal",
        at,
        inputs,
        |((_, number), (_, end_nz), (_, planes))| {
            constant_normal(number, end_nz, &planes).registered()
        },
    )
}
