//! Cylinder processor: body and front disc in one exact outline, a parabolic body.

use super::clamped::Clamped;
use super::{Front, Normal, ScreenBox, Visible, Widths, absent, object_processor};
use crate::raster::{Flags, Linear, Pixel, Quadratic, pe1, pe2};
use imogene_contract::words::{FIRST_PLANE, NEAR_ROOT, NORMAL};
use imogene_hdl::{Bits, Bundle, Int, Value, bundles, net};

bundles! {
    /// Words of a cylinder.
    Cylinder {
        /// Where it may be.
        screen_box: ScreenBox as "";
        sides: Vec<Linear> as "side", "not negative inside side # of the rectangle between the discs";
        discs: Vec<Quadratic> as "disc", "not negative in disc # (0 front, 1 back)";
        body: Quadratic as "body", "depth of the body in units of 2^-(W-2) depth words";
        nx: Quadratic as "nx", "normal x of the body in units of 2^-(2W-16)";
        ny: Quadratic as "ny", "normal y of the body in units of 2^-(2W-16)";
        nz: Quadratic as "nz", "normal z of the body in units of 2^-(2W-16)";
        lid: Linear as "lid", "depth of the front disc in units of 2^-10 depth words";
        lid_normal: Normal as "lid", "front disc";
    }
}

impl Cylinder {
    /// Words from outside of the design.
    pub fn input(widths: Widths) -> Cylinder {
        let linear = || Linear::input(widths.plane);
        let quadratic = || Quadratic::input(widths.quadratic);
        Cylinder {
            screen_box: ScreenBox::input(),
            sides: (0..4).map(|_| linear()).collect(),
            discs: (0..2).map(|_| quadratic()).collect(),
            body: quadratic(),
            nx: quadratic(),
            ny: quadratic(),
            nz: quadratic(),
            lid: linear(),
            lid_normal: Normal::input(widths.normal),
        }
    }
}

/// Name of the module, and what numbers of faces it gives.
const KIND: (&str, &str) = ("cylinder_processor", "visible part: 0 body, 2 front disc");

/// For every pixel depth and normal of a cylinder whose body is approximated by a parabolic cylinder; outline and
/// disc are exact. Orthographic views only, neither end-on nor side-on.
///
/// The depth of the visible part is front and back. A part beyond the ends of the depth word is absent. Latency 3.
/// Chaillou 1991, IV.2.5.
pub fn cylinder_processor(
    at: &str,
    flags: Flags,
    pixel: Pixel,
    words: Cylinder,
    depth: u32,
) -> Visible {
    let inputs = (flags, pixel, words);
    object_processor(KIND, at, inputs, |flags, pixel, words| {
        let sum = |value: Int| value.high(depth + 2);
        let component = |at: &str, words: Quadratic| pe2(at, flags, words).high(NORMAL as u32);
        let face = |number: u64| Bits::new(number, 4);
        let sides = words.sides.iter().enumerate();
        let sides = sides.map(|(index, side)| pe1(&format!("sides_{index}"), flags, *side));
        let discs = words.discs.iter().enumerate();
        let discs = discs.map(|(index, disc)| pe2(&format!("discs_{index}"), flags, *disc));
        let between = sides.map(|side| !side.is_negative());
        let in_discs: Vec<Bits> = discs.map(|disc| !disc.is_negative()).collect();
        net! {
            let in_box_late = words.screen_box.contains(pixel).reg();
            let in_rectangle = between.reduce(|all, one| all & one).expect("sides");
            let in_front = in_discs[0];
            let kept_there = (in_box_late & (in_front | in_rectangle | in_discs[1])).reg();
        }
        let body_normal = Normal {
            nx: component("normal_x", words.nx),
            ny: component("normal_y", words.ny),
            nz: component("normal_z", words.nz),
        };
        let body = (
            sum(pe2("body_depth", flags, words.body)),
            face(NEAR_ROOT),
            body_normal,
        );
        let lid = (
            sum(pe1("lid", flags, words.lid)),
            face(FIRST_PLANE),
            words.lid_normal,
        );
        let (z, part, normal) = in_front.select(lid, body).registered();
        net! { let is_present = kept_there & Clamped::of("depth", z, NEAR_ROOT, depth).is_visible(); }
        let no_normal = Normal::all(Int::new(0, NORMAL as u32));
        let nothing = (absent(depth), face(NEAR_ROOT), no_normal);
        let seen = is_present.select((z.low(depth), part, normal), nothing);
        let (z, number, normal) = seen.registered();
        let front = Front {
            out_valid: flags.valid.delayed_as("valid_late", 3),
            zf: z,
            zb: z,
        };
        Visible {
            front,
            number,
            normal,
        }
    })
}
