//! Choice of the faces of a quadric by contours on the screen.

use super::clamped::Clamped;
use super::ends::is_behind_near_end;
use super::{Interval, Roots, Seen, absent};
use imogene_contract::words::{FAR_ROOT, FIRST_PLANE, NEAR_ROOT};
use imogene_hdl::{Bits, Bundle, Ports, Value, bundle, module, net};

bundle! {
    /// Two parallel planes at a pixel, and what the contours say of them.
    Contours(depth) {
        surface: Bits(1), "the object is a bare surface";
        front_zp: Int(depth), "depth of the front plane";
        back_zp: Int(depth), "depth of the back plane";
        front_inside: Bits(1), "the front plane is inside the quadric";
        back_inside: Bits(1), "the back plane is inside the quadric";
        middle_kept: Bits(1), "the middle of the quadric is on the kept side of both planes";
    }
}

/// The visible face of a quadric between two parallel planes by the signs of contours, as the first generation chooses
/// it.
///
/// A plane inside a solid is the face on its side; inside a bare surface it has removed the face on its side. Latency
/// 3. Section 2.4.1, its algorithm corrected.
pub fn contour_choice(at: &str, roots: Roots, contours: Contours) -> Seen {
    module("contour_choice", at, (roots, contours), |(roots, own)| {
        let width = own.front_zp.width();
        let end = absent(width);
        let near = Clamped::of("near", roots.near_sum, NEAR_ROOT);
        let far = Clamped::of("far", roots.far_sum, FAR_ROOT);
        net! {
            // No plane passes through the quadric here and one of them has it on its removed side: nothing is left.
            let some_kept = own.front_inside | own.back_inside | own.middle_kept;
            let left = roots.is_inside & roots.in_box & some_kept;
            let front_cuts = own.front_inside & is_behind_near_end(own.front_zp);
            let back_cuts = own.back_inside & !own.back_zp.equals(end);
            let cut_zf = front_cuts.select(own.front_zp, near.depth).reg();
            let cut_zb = back_cuts.select(own.back_zp, far.depth).reg();
            let cut_face = front_cuts.select(Bits::new(FIRST_PLANE, 4), near.face).reg();
            // Only a plane beyond an end of the depth word can leave nothing where the solid is.
            let is_cut = (left & !(near.is_far | far.is_low)).reg();
            let is_present = is_cut & !cut_zb.less(cut_zf) & !cut_zf.equals(end);
            let near_left = (left & !own.front_inside & near.is_visible()).reg();
            let far_left = (left & !own.back_inside & far.is_visible()).reg();
            // A face that is left lies between the ends of the depth word.
            let near_depth = roots.near_sum.low(width).reg();
            let far_depth = roots.far_sum.low(width).reg();
            let is_solid = is_present.reg();
            let is_surface = own.surface.delay(2);
        }
        let solid = Seen {
            zf: cut_zf,
            zb: cut_zb,
            number: cut_face,
        };
        let surface = Interval::of_surface([near_left, far_left], [near_depth, far_depth]).seen();
        let solid = is_solid.select(("solid", solid).delayed(1).bare(), Seen::absent(width));
        is_surface
            .select(("surface", surface).delayed(1).bare(), solid)
            .registered()
    })
}
