//! Cylinder processor: body and front disc in one exact outline, a parabolic body.

use super::clamped::Clamped;
use super::{NORMAL, Normal, ScreenBox, Seen, Visible, Widths, absent, object_processor};
use crate::raster::{Linear, Quadratic, Scan, pe1, pe2};
use crate::rows::numbered;
use imogene_contract::words::{FIRST_PLANE, NEAR_ROOT};
use imogene_hdl::{Bits, Bundle, Int, Value, bundles, net};

bundles! {
    /// Words of a cylinder.
    Cylinder(widths: Widths) {
        /// Where it may be.
        screen_box: ScreenBox() as "";
        sides: [Linear(widths.plane); 4] as "side", "not negative inside side # of the rectangle between the discs";
        discs: [Quadratic(widths.quadratic); 2] as "disc", "not negative in disc # (0 front, 1 back)";
        body: Quadratic(widths.quadratic) as "body", "depth of the body in units of 2^-(W-2) depth words";
        nx: Quadratic(widths.quadratic) as "nx", "normal x of the body in units of 2^-(2W-16)";
        ny: Quadratic(widths.quadratic) as "ny", "normal y of the body in units of 2^-(2W-16)";
        nz: Quadratic(widths.quadratic) as "nz", "normal z of the body in units of 2^-(2W-16)";
        lid: Linear(widths.plane) as "lid", "depth of the front disc in units of 2^-10 depth words";
        lid_normal: Normal(widths.normal) as "lid", "front disc";
    }
}

/// Name of the module, and what numbers of faces it gives.
const KIND: (&str, &str) = ("cylinder_processor", "visible part: 0 body, 2 front disc");

/// For every pixel depth and normal of a cylinder whose body is approximated by a parabolic cylinder; outline and
/// disc are exact. Orthographic views only, neither end-on nor side-on.
///
/// The depth of the visible part is front and back. A part beyond the ends of the depth word is absent. Latency 3.
/// Chaillou 1991, IV.2.5.
pub fn cylinder_processor(at: &str, scan: Scan, words: Cylinder, depth: u32) -> Visible {
    object_processor(KIND, at, (scan, words), |Scan { flags, pixel }, words| {
        let sum = |value: Int| value.high(depth + 2);
        // Normals are a clock late, when the part is chosen: fewer loads on one register of flags.
        let late_flags = flags.delayed(1);
        let component = |at: &str, words: Quadratic| pe2(at, late_flags, words).high(NORMAL);
        let face = |number: u64| Bits::new(number, 4);
        let sides = numbered("sides", words.sides);
        let between = sides.map(|(at, side)| !pe1(&at, flags, side).is_negative());
        let discs = numbered("discs", words.discs);
        let in_discs = discs.map(|(at, disc)| !pe2(&at, flags, disc).is_negative());
        let in_discs: Vec<Bits> = in_discs.collect();
        net! {
            let in_box_late = words.screen_box.contains(pixel).reg();
            let in_rectangle = between.reduce(|all, one| all & one).expect("sides");
            let in_front = in_discs[0];
            let kept_there = in_box_late & (in_front | in_rectangle | in_discs[1]);
        }
        let body_normal = Normal::of([
            component("normal_x", words.nx),
            component("normal_y", words.ny),
            component("normal_z", words.nz),
        ]);
        let body_depth = sum(pe2("body_depth", flags, words.body));
        let lid_depth = sum(pe1("lid", flags, words.lid));
        // Both parts are asked before one is chosen, so that one bit alone selects in the last clock.
        let [lid_visible, body_visible] = [("lid_depth", lid_depth), ("body_depth", body_depth)]
            .map(|(name, depth)| Clamped::of(name, depth, NEAR_ROOT).is_visible());
        net! {
            let kept_depth = in_front.select(lid_depth, body_depth).reg();
            let kept_front = in_front.reg();
            let kept_face = kept_front.select(face(FIRST_PLANE), face(NEAR_ROOT));
            let is_present = (kept_there & in_front.select(lid_visible, body_visible)).reg();
        }
        let normal = kept_front.select(words.lid_normal, body_normal);
        let no_normal = Normal::of([Int::new(0, NORMAL); 3]);
        let nothing = (absent(depth), face(NEAR_ROOT), no_normal);
        let seen = is_present.select((kept_depth.low(depth), kept_face, normal), nothing);
        let (z, number, normal) = seen.registered();
        Seen::face(z, number).with(late_flags.valid.delayed_as("valid_late", 2), normal)
    })
}
