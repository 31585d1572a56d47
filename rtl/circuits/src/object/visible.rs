//! What object processors answer.

use super::{Face, Normal, NormalWords, absent, normal_unit};
use crate::raster::Flags;
use imogene_hdl::{Bits, Bundle, Value, bundle, bundles};

bundle! {
    /// An object on a line of sight.
    Seen(depth) {
        zf: Int(depth), "front depth, the far end where the object is absent";
        zb: Int(depth), "back depth";
        number: Bits(4), "face at the front";
    }

    /// The visible front of an object.
    Front(depth) {
        out_valid: Bits(1), "this clock carries a result";
        zf: Int(depth), "front depth, the far end where the object is absent";
        zb: Int(depth), "back depth";
        number: Bits(4), "face at the front";
    }
}

bundles! {
    /// A pixel of an object.
    Visible {
        front: Front as "", "depth and face";
        normal: Normal as "", "normal of the face";
    }
}

impl Seen {
    /// The answer of the clock that says whether it is one.
    pub(super) fn front(self, out_valid: Bits) -> Front {
        Front {
            out_valid,
            zf: self.zf,
            zb: self.zb,
            number: self.number,
        }
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
    Visible {
        front: seen.front(flags.valid).delayed(3),
        normal: normal_unit("normal", flags, face, words),
    }
}
