//! Convex polyhedron processor.

use super::{
    Front, HalfSpace, Limits, Normal, Plane, ScreenBox, Widths, constant_normal, half_spaces,
};
use crate::raster::Scan;
use crate::tree::levels;
use imogene_hdl::{Bits, Bundle, Int, Value, bundles, module, ports};

bundles! {
    /// Words of a convex solid of planes, with their outward normals.
    Polyhedron(widths: Widths, planes: u32) {
        /// Where it may be.
        screen_box: ScreenBox() as "";
        planes: [Plane(widths); planes] as "plane", "plane #";
    }
}

bundles! {
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

/// For every pixel the front and back depth of a convex solid of planes, with faces and normals; the normal of an end
/// of the depth word is the direction to it.
///
/// A solid without thickness is there. Latency `ceil(log2 planes) + 6`. The words stay unchanged until that many clocks
/// after the last flags of a zone. Annex A.
pub fn polyhedron_processor(at: &str, scan: Scan, words: Polyhedron, depth: u32) -> BothFaces {
    let inputs = (scan, words);
    module("polyhedron_processor", at, inputs, |(scan, words)| {
        let planes: Vec<HalfSpace> = words.planes.iter().map(|plane| plane.half_space).collect();
        let limits = Limits::of(scan.flags, &planes, depth);
        let levels = levels(words.planes.len());
        let in_box = words.screen_box.contains(scan.pixel);
        let in_box = in_box.delayed_as("in_box_late", levels + 3);
        let kept = half_spaces("half_spaces", limits, in_box);
        let normals: Vec<Normal> = words.planes.iter().map(|plane| plane.normal).collect();
        let normal = |at: &str, number: Bits, sign: i64| {
            let width = normals[0].nz.width();
            let end_nz = Int::new(sign * ((1 << (width - 1)) - 1), width);
            plane_normal(at, number, end_nz, &normals)
        };
        let out_valid = scan.flags.valid.delayed_as("valid_late", levels + 6);
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
    })
}

/// The normal of a face that is a plane or an end of the depth word, else zero. Latency 1.
fn plane_normal(at: &str, number: Bits, end_nz: Int, planes: &[Normal]) -> Normal {
    let inputs = (ports!(number, end_nz), ("plane", planes.to_vec()));
    module("plane_normal", at, inputs, |((number, end_nz), planes)| {
        constant_normal(number, end_nz, &planes).registered()
    })
}
