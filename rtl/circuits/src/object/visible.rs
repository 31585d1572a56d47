//! What object processors answer.

use super::ends::absent;
use super::normal::Normal;
use super::normal_unit::{Face, NormalWords, normal_unit, scaled_root_width};
use super::words::Gradients;
use crate::raster::{Flags, Scan};
use imogene_hdl::{Bits, Bundle, Int, Ports, Value, bundle, bundles, module, net};

bundle! {
    /// An object on a line of sight.
    Seen(depth) {
        zf: Int(depth), "depth of the visible face; 2^(W-1) - 1 where the object is absent";
        zb: Int(depth), "depth of the back; that of the front where there is one face only";
        number: Bits(4), "visible face: 0 near root, 1 far root; of a solid also 2 + i plane i, 15 near end";
    }

    /// Where an object is at a pixel.
    Front(depth) {
        out_valid: Bits(1), "valid, with the results of its pixel";
        zf: Int(depth), "depth of the visible face; 2^(W-1) - 1 where the object is absent";
        zb: Int(depth), "depth of the back; that of the front where there is one face only";
    }
}

bundles! {
    /// A pixel of an object.
    Visible {
        /// Where it is.
        front: Front as "";
        number: Bits as "number", "visible face";
        normal: Normal as "", "visible face";
    }
}

impl Seen {
    /// Nothing is there.
    pub(super) fn absent(depth: u32) -> Seen {
        Seen::face(absent(depth), Bits::new(0, 4))
    }

    /// A face without anything behind it.
    pub(super) fn face(z: Int, number: Bits) -> Seen {
        let (zf, zb) = (z, z);
        Seen { zf, zb, number }
    }

    /// The answer of the clock that says whether it is one, without its face.
    pub(super) fn front(self, out_valid: Bits) -> Front {
        let Seen { zf, zb, .. } = self;
        Front { out_valid, zf, zb }
    }

    /// The answer of the clock that says whether it is one.
    pub(super) fn with(self, out_valid: Bits, normal: Normal) -> Visible {
        Visible {
            front: self.front(out_valid),
            number: self.number,
            normal,
        }
    }
}

/// An object processor as a module; `faces` says what numbers of faces it gives.
#[track_caller]
pub(super) fn object_processor<W: Ports>(
    (name, faces): (&str, &'static str),
    at: &str,
    inputs: (Scan, W),
    body: impl FnOnce(Scan, W::Bare) -> Visible,
) -> Visible {
    let (front, number, normal) = module(name, at, inputs, |(scan, words)| {
        let seen = body(scan, words);
        let number = ("number", seen.number, faces);
        (seen.front, number, ("", seen.normal, "visible face"))
    });
    Visible {
        front,
        number,
        normal,
    }
}

/// What is seen of a quadric with its normal, from the flags beside it and the root some clocks before; words of the
/// normal, places that the root is shifted for it, and the normals of the planes, `None` for a bare surface. Latency 4.
pub(super) fn visible(
    flags: Flags,
    seen: Seen,
    (root, before): (Bits, u32),
    (gradients, shift, planes): (Gradients, Bits, Option<Vec<Normal>>),
) -> Visible {
    let number = seen.number;
    let width = scaled_root_width(root.width(), gradients.factors.kx.width());
    net! { let shifted_root = root.right_by(shift); }
    let scaled_root = shifted_root.low(width);
    let scaled_root = scaled_root.delayed_as("scaled_root", before);
    let face = Face {
        number: planes.as_ref().map_or_else(|| number.low(1), |_| number),
        absent: seen.zf.equals(absent(seen.zf.width())),
        scaled_root,
    };
    let planes = planes.unwrap_or_default();
    let words = NormalWords { gradients, planes };
    let (out_valid, late) = (("out_valid", flags.valid), seen).delayed(4).bare();
    late.with(out_valid, normal_unit("normal", flags, face, words))
}
