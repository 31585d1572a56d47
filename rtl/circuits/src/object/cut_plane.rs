//! One cut of an interval by a plane.

use super::Interval;
use imogene_contract::words::{BACK_PLANE, FRONT_PLANE, PERPENDICULAR};
use imogene_hdl::{Bundle, Value, bundle, module, net};

bundle! {
    /// A plane at a pixel.
    Cut(depth) {
        kind: Bits(2),
            "kind: 0 none, 1 front (keeps z >= zp), 2 back (keeps z <= zp), 3 perpendicular (keeps zp >= 0)";
        surface: Bits(1), "the object is a bare surface (class patch), not a solid";
        number: Bits(4), "face number of the plane";
        zp: Int(depth), "clamped depth of the plane; of a perpendicular one its sign alone counts";
    }
}

/// What a plane leaves of an interval: a front plane moves its front back, a back plane its back forward, a plane
/// perpendicular to the screen removes all where it is negative. A bare surface has no inside: of its two points the
/// cut one goes.
///
/// Ties: a plane at the front leaves the front, one at the back leaves nothing of a front plane's side. Latency 2: the
/// comparisons, the choice. Section 2.4.2.
pub fn cut_plane(at: &str, cut: Cut, interval: Interval) -> Interval {
    module("cut_plane", at, (cut, interval), |(cut, own)| {
        net! {
            let before_front = cut.zp.less(own.zf).reg();
            let at_front = cut.zp.equals(own.zf).reg();
            let before_back = cut.zp.less(own.zb).reg();
            let at_back = cut.zp.equals(own.zb).reg();
        }
        let (cut, own) = (cut.delayed(1), own.delayed(1));
        let is = |kind: u64| cut.kind.is(kind);
        net! {
            let cuts_front = is(FRONT_PLANE) & !(before_front | at_front);
            let cuts_back = is(BACK_PLANE) & before_back;
            let leaves_nothing = cuts_front & !(before_back | at_back);
            let removed = (is(PERPENDICULAR) & cut.zp.is_negative()) | leaves_nothing | (cuts_back & before_front);
        }
        let front = Interval {
            zf: cut.surface.select(own.zb, cut.zp),
            nf: cut.surface.select(own.nb, cut.number),
            ..own
        };
        let back = Interval {
            zb: cut.surface.select(own.zf, cut.zp),
            nb: cut.surface.select(own.nf, cut.number),
            ..own
        };
        let left = cuts_front.select(front, cuts_back.select(back, own));
        let absent = Interval::absent(own.zf.width());
        let left = removed.select(absent, left).registered();
        ("cut", left, "after the cut")
    })
}
