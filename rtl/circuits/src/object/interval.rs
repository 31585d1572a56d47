//! Where an object is on a line of sight.

use super::absent;
use imogene_hdl::{Bits, bundle};

bundle! {
    /// A front and a back, each with the number of its face; absent where the front is at the far end.
    Interval(depth) {
        zf: Int(depth), "front depth";
        nf: Bits(4), "front face";
        zb: Int(depth), "back depth";
        nb: Bits(4), "back face";
    }
}

impl Interval {
    /// Nothing is there.
    pub fn absent(depth: u32) -> Interval {
        let no_face = Bits::new(0, 4);
        Interval {
            zf: absent(depth),
            nf: no_face,
            zb: absent(depth),
            nb: no_face,
        }
    }
}
