//! Sphere processor: an exact outline, and a paraboloid for the depth.

use super::clamped::Clamped;
use super::{Front, Normal, ScreenBox, Visible, Widths, absent, object_processor};
use crate::raster::{Flags, Linear, Pixel, Quadratic, pe1, pe2};
use imogene_contract::words::{CAP, FAR_ROOT, NEAR_ROOT, NORMAL, near_end};
use imogene_hdl::{Bits, Bundle, Int, Value, bundles, net};

bundles! {
    /// Words of a sphere.
    Sphere {
        /// Where it may be.
        screen_box: ScreenBox as "";
        outline: Quadratic as "outline", "not negative inside the outline";
        front: Quadratic as "front", "front depth in units of 2^-(W-2) depth words";
        depth_sum: Int as "depth_sum", "front depth plus back depth, the same at every pixel";
        nx: Linear as "nx", "normal x in units of 2^-8";
        ny: Linear as "ny", "normal y in units of 2^-8";
        nz: Quadratic as "nz", "normal z in units of 2^-(2W-16)";
    }
}

impl Sphere {
    /// Words from outside of the design.
    pub fn input(widths: Widths) -> Sphere {
        let quadratic = || Quadratic::input(widths.quadratic);
        Sphere {
            screen_box: ScreenBox::input(),
            outline: quadratic(),
            front: quadratic(),
            depth_sum: Int::input(widths.linear),
            nx: Linear::input(widths.gradient),
            ny: Linear::input(widths.gradient),
            nz: quadratic(),
        }
    }
}

/// Name of the module, and what numbers of faces it gives.
const KIND: (&str, &str) = ("sphere_processor", "visible face: 0 sphere, 15 near end");

/// For every pixel depth and normal of a sphere whose front is approximated by a paraboloid; its outline is exact.
/// Orthographic views only.
///
/// Front and back depth of a sphere have the same sum at every pixel, so one subtractor does what the source spends a
/// fourth second-degree processor on. A sphere that reaches nearer than the near end has a cap there. Latency 4.
/// Chaillou 1991, IV.2.4.
pub fn sphere_processor(at: &str, flags: Flags, pixel: Pixel, words: Sphere) -> Visible {
    let inputs = (flags, pixel, words);
    object_processor(KIND, at, inputs, |flags, pixel, words| {
        let sum = words.depth_sum.width();
        let depth = sum - 2;
        net! {
            let in_box_late = words.screen_box.contains(pixel).reg();
            let is_outside = pe2("outline", flags, words.outline).is_negative();
            let near_depth = pe2("front", flags, words.front).high(sum);
            let kept_near = near_depth.reg();
            let kept_far = (words.depth_sum - near_depth).reg();
            let kept_there = (in_box_late & !is_outside).reg();
        }
        let near = Clamped::of("near", kept_near, NEAR_ROOT, depth);
        let far = Clamped::of("far", kept_far, FAR_ROOT, depth);
        net! { let is_present = kept_there & !(near.is_far | far.is_low); }
        let nothing = (absent(depth), absent(depth), Bits::new(0, 4));
        let seen = is_present.select((near.depth, far.depth, near.face), nothing);
        let late_seen = seen.registered();
        let (zf, zb, number) = late_seen.registered();
        // The normal is used two clocks later than the depth.
        let late = flags.delayed(2);
        let component = |value: Int| value.high(NORMAL as u32);
        let normal = Normal {
            nx: component(pe1("normal_x", late, words.nx)),
            ny: component(pe1("normal_y", late, words.ny)),
            nz: component(pe2("normal_z", late, words.nz)),
        };
        let none = Normal::all(Int::new(0, NORMAL as u32));
        let to_viewer = Normal {
            nz: Int::new(near_end(NORMAL), NORMAL as u32),
            ..none
        };
        let of_face = late_seen.2.is(CAP).select(to_viewer, normal);
        Visible {
            front: Front {
                out_valid: flags.valid.delayed_as("valid_late", 4),
                zf,
                zb,
            },
            number,
            normal: is_present.reg().select(of_face, none).registered(),
        }
    })
}
