//! A half-space: what lies on the kept side of a plane.

use super::ends::{absent, end, fits};
use super::plane_depth::plane_depth;
use super::widths::Widths;
use crate::raster::{Flags, Linear, pe1};
use imogene_contract::words::{BACK_PLANE, FRONT_PLANE, PERPENDICULAR, saturated_near};
use imogene_hdl::{Bits, Int, Value, bundle, bundles, module, net};

bundle! {
    /// A plane at a pixel.
    PlaneAt(depth) {
        kind: Bits(2), "kind: 0 none, 1 front (keeps z >= zp), 2 back (keeps z <= zp), 3 perpendicular (keeps zp >= 0)";
        zp: Int(depth), "depth zp, clamped to the ends of its word";
    }
}

bundle! {
    /// What some half-spaces leave of the line of sight.
    Limits(depth) {
        front: Int(depth), "greatest depth of a front plane; one below the near end where there is none";
        front_number: Bits(4), "its face";
        back: Int(depth), "least depth of a back plane; the far end where there is none";
        back_number: Bits(4), "its face";
        removed: Bits(1), "a perpendicular plane removes the pixel";
    }
}

bundles! {
    /// Words of a plane without a normal.
    #[derive(Copy)]
    HalfSpace(widths: Widths) {
        kind: Bits(2) as "kind",
            "kind: 0 none, 1 front (keeps z >= zp), 2 back (keeps z <= zp), 3 perpendicular (keeps zp >= 0)";
        linear: Linear(widths.plane) as "", "depth zp";
    }
}

impl HalfSpace {
    /// The plane at a pixel, 2 clocks after its flags.
    pub(super) fn at(self, at: &str, flags: Flags, depth: u32) -> PlaneAt {
        PlaneAt {
            kind: self.kind,
            zp: plane_depth(at, flags, self.linear, depth),
        }
    }

    /// What it leaves with a number of its face, 3 clocks after its flags.
    pub(super) fn limits(self, at: &str, flags: Flags, depth: u32, number: u64) -> Limits {
        let (front, back, removed) = plane_limits(at, flags, self, depth);
        let number = Bits::new(number, 4);
        Limits {
            front,
            front_number: number,
            back,
            back_number: number,
            removed,
        }
    }
}

/// A plane by a PE1, clamped to a depth word as that of [`plane_depth`], as a front limit, a back one, or 1 where it
/// removes the pixel. Where it is no such plane, a depth that loses to every other.
///
/// Latency 3. Section 2.4.2.
fn plane_limits(at: &str, flags: Flags, words: HalfSpace, depth: u32) -> (Int, Int, Bits) {
    let inputs = (flags, ("", words));
    module("plane_limits", at, inputs, |(flags, words)| {
        let plane = pe1("plane", flags, words.linear);
        let [lowest, last] = [end(saturated_near, depth), absent(depth)];
        net! {
            let is_in_word = fits(plane, depth).reg();
            let is_before = plane.is_negative().reg();
            let near_word = plane.low(depth).reg();
            let clamped = is_in_word.select(near_word, is_before.select(lowest, last));
        }
        let is = |kind: u64| words.kind.is(kind);
        (
            ("front", is(FRONT_PLANE).select(clamped, lowest).reg()),
            ("back", is(BACK_PLANE).select(clamped, last).reg()),
            ("removed", (is(PERPENDICULAR) & is_before).reg()),
        )
    })
}

impl PlaneAt {
    /// 1 where it is perpendicular to the screen and removes the whole line of sight.
    pub(super) fn removes_all(self) -> Bits {
        self.kind.is(PERPENDICULAR) & self.zp.is_negative()
    }
}

/// 1 where a plane keeps a point of the line of sight, also one in the plane. Where a half-space begins, `entered` is
/// asked; where it ends, `z`.
///
/// Latency 2. Sections 2.4.3 (signals E_F and E_B of a patch), 3.2.1 and 4.1.3 (volumes).
pub fn half_space_test(at: &str, plane: PlaneAt, z: Int, entered: Int) -> Bits {
    let inputs = (plane, ("z", z), ("entered", entered));
    module("half_space_test", at, inputs, |(plane, z, entered)| {
        let width = plane.zp.width().max(z.width()).max(entered.width());
        net! {
            let plane_depth = plane.zp.extend(width);
            let is_before = entered.extend(width).less(plane_depth);
            let is_behind = plane_depth.less(z.extend(width));
            let front_removes = (plane.kind.is(FRONT_PLANE) & is_before).reg();
            let back_removes = (plane.kind.is(BACK_PLANE) & is_behind).reg();
            let all_removed = plane.removes_all().reg();
            let is_removed = front_removes | back_removes | all_removed;
        }
        ("holds", (!is_removed).reg())
    })
}
