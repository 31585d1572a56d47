//! What object processors answer.

use super::{Face, Normal, NormalWords, absent, normal_unit};
use crate::raster::{Flags, Pixel};
use imogene_hdl::{Bits, Bundle, Value, bundle, bundles, module};

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

/// Group of the place of a pixel.
pub(super) const IN_ZONE: &str = "pixel of the zone, counted from 0";

impl Seen {
    /// The answer of the clock that says whether it is one, without its face.
    pub(super) fn front(self, out_valid: Bits) -> Front {
        Front {
            out_valid,
            zf: self.zf,
            zb: self.zb,
        }
    }
}

/// An object processor as a module; `faces` says what numbers of faces it gives.
#[track_caller]
pub(super) fn object_processor<W: Bundle>(
    (name, faces): (&str, &'static str),
    at: &str,
    (flags, pixel, words): (Flags, Pixel, W),
    body: impl FnOnce(Flags, Pixel, W) -> Visible,
) -> Visible {
    let inputs = (flags, ("", pixel, IN_ZONE), words);
    let (front, (_, number, _), normal) = module(name, at, inputs, |(flags, pixel, words)| {
        let seen = body(flags, pixel.1, words);
        let number = ("number", seen.number, faces);
        (seen.front, number, ("", seen.normal, "visible face"))
    });
    Visible {
        front,
        number,
        normal: normal.1,
    }
}

/// What is seen of a quadric with its normal, from the flags, the root and its shift beside it. Latency 3.
pub(super) fn visible(
    flags: Flags,
    seen: Seen,
    (root, shift): (Bits, Bits),
    words: NormalWords,
) -> Visible {
    let face = Face {
        number: seen.number,
        absent: seen.zf.equals(absent(seen.zf.width())),
        root,
        shift,
    };
    let ((_, out_valid), late) = (("out_valid", flags.valid), seen).delayed(3);
    Visible {
        front: late.front(out_valid),
        number: late.number,
        normal: normal_unit("normal", flags, face, words),
    }
}
