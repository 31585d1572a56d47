//! A root within the depth word.

use super::end;
use super::ends::beyond;
use imogene_contract::words::{CAP, far_end, near_end};
use imogene_hdl::{Bits, Int, Value};

/// One root within the range of the depth: clamped to the near end, where its face is the cap, and to the far end.
pub(super) struct Clamped {
    /// It is before the near end.
    pub is_low: Bits,
    /// It is not before the far end.
    pub is_far: Bits,
    pub depth: Int,
    pub face: Bits,
}

impl Clamped {
    /// Of a depth sum, which has two bits more than a depth.
    pub fn of(name: &str, sum: Int, face: u64) -> Clamped {
        Clamped::with(name, Clamped::ends(name, sum), sum, face)
    }

    /// Whether a depth sum is before the near end, and whether it is not before the far end.
    pub fn ends(name: &str, sum: Int) -> [Bits; 2] {
        let [is_low, is_far] = beyond(name, sum, sum.width() - 2);
        [
            is_low.named(&format!("{name}_is_low")),
            is_far.named(&format!("{name}_is_far")),
        ]
    }

    /// Of a depth sum and what [`Clamped::ends`] says of it.
    pub fn with(name: &str, [is_low, is_far]: [Bits; 2], sum: Int, face: u64) -> Clamped {
        let width = sum.width() - 2;
        let own = |part: &str| format!("{name}_{part}");
        let [cap, face] = [CAP, face].map(|number| Bits::new(number, 4));
        let root = sum.low(width);
        let [low, far] = [near_end, far_end].map(|of| end(of, width));
        let depth = is_low.select(low, is_far.select(far, root));
        Clamped {
            is_low,
            is_far,
            depth: depth.named(&own("depth")),
            face: is_low.select(cap, face).named(&own("face")),
        }
    }

    /// 1 where it is between the ends.
    pub fn is_visible(&self) -> Bits {
        !(self.is_low | self.is_far)
    }
}
