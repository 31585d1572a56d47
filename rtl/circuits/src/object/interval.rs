//! Where an object is on a line of sight.

use super::ends::absent;
use super::visible::Seen;
use imogene_contract::words::{FAR_ROOT, NEAR_ROOT};
use imogene_hdl::{Bits, Int, Value, bundle};

bundle! {
    /// A front and a back, each with the number of its face; absent where the front is at the far end.
    Interval(depth) {
        zf: Int(depth), "front depth";
        nf: Bits(4), "face number at the front";
        zb: Int(depth), "back depth";
        nb: Bits(4), "face number at the back";
    }
}

impl Interval {
    /// Nothing is there.
    pub fn absent(depth: u32) -> Interval {
        let (z, no_face) = (absent(depth), Bits::new(0, 4));
        Interval {
            zf: z,
            nf: no_face,
            zb: z,
            nb: no_face,
        }
    }

    /// From the first to the second point of a bare surface; from the only one to itself; absent where none is there.
    pub(super) fn of_surface(
        [near_is_there, far_is_there]: [Bits; 2],
        [near, far]: [Int; 2],
    ) -> Interval {
        let [near_face, far_face] = [NEAR_ROOT, FAR_ROOT].map(|number| Bits::new(number, 4));
        let nothing = absent(near.width());
        Interval {
            zf: near_is_there.select(near, far_is_there.select(far, nothing)),
            nf: (far_is_there & !near_is_there).select(far_face, near_face),
            zb: far_is_there.select(far, near_is_there.select(near, nothing)),
            nb: far_is_there.select(far_face, near_face),
        }
    }

    /// What is seen of it.
    pub(super) fn seen(self) -> Seen {
        let Interval { zf, zb, nf, .. } = self;
        Seen { zf, zb, number: nf }
    }
}
