//! Whether the visible point lies in a volume.

use super::{HalfSpace, PlaneAt, ScreenBox, Widths, absent, half_space_test};
use crate::raster::{Flags, pe1};
use crate::rows::numbered;
use imogene_hdl::{Bits, Int, Value, bundle, bundles, net};

bundle! {
    /// The visible point of a pixel.
    VolumePoint(depth) {
        depth: Int(depth),
            "visible depth of the pixel, ceil(W / R) clocks after its flags where the volume has a quadric, with \
            them where not";
        margin: Bits(depth), "counts that a point has to lie behind the beginning of the volume, at most 2^(W-1) - 1";
    }

    /// What a volume says of a pixel.
    Answer() {
        out_valid: Bits(1), "valid, with the result of its pixel";
        is_inside: Bits(1), "the visible point lies in the volume; the background does not";
    }
}

bundles! {
    /// Where a volume may be, and what cuts it.
    Bounds(widths: Widths, planes: u32) {
        /// Where it may be.
        screen_box: ScreenBox() as "";
        planes: [HalfSpace(widths); planes] as "plane", "plane #";
    }
}

impl VolumePoint {
    /// Depth, and depth less margin, which has to lie behind the beginning of a volume: one clock late, the second a
    /// word of two bits more.
    pub(super) fn depths(self) -> [Int; 2] {
        let width = self.depth.width() + 2;
        let behind = self.depth.extend(width) - self.margin.extend(width).int();
        net! {
            let z = self.depth.reg();
            let entered = behind.reg();
        }
        [z, entered]
    }

    /// 1 where the point is no background and all planes keep it, three clocks after the point and the flags of its
    /// pixel, two after [`VolumePoint::depths`].
    pub(super) fn is_kept([z, entered]: [Int; 2], flags: Flags, planes: &[HalfSpace]) -> Bits {
        net! { let is_surface = (!z.equals(absent(z.width()))).delay(2); }
        let planes = numbered("planes", planes).map(|(at, plane)| PlaneAt {
            kind: plane.kind,
            zp: pe1(&at, flags, plane.linear),
        });
        numbered("tests", planes).fold(is_surface, |all, (at, plane)| {
            all & half_space_test(&at, plane, z, entered)
        })
    }
}
