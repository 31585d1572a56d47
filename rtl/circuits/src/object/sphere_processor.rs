//! Sphere processor: an exact outline, and a paraboloid for the depth.

use super::clamped::Clamped;
use super::{NORMAL, Normal, ScreenBox, Seen, Visible, Widths, end, object_processor};
use crate::raster::{Linear, Quadratic, Scan, pe1, pe2};
use imogene_contract::words::{CAP, FAR_ROOT, NEAR_ROOT, near_end};
use imogene_hdl::{Bundle, Int, Value, bundles, net};

bundles! {
    /// Words of a sphere.
    Sphere(widths: Widths) {
        /// Where it may be.
        screen_box: ScreenBox() as "";
        outline: Quadratic(widths.quadratic) as "outline", "not negative inside the outline";
        front: Quadratic(widths.quadratic) as "front", "front depth in units of 2^-(W-2) depth words";
        depth_sum: Int(widths.linear) as "depth_sum", "front depth plus back depth, the same at every pixel";
        nx: Linear(widths.gradient) as "nx", "normal x in units of 2^-8";
        ny: Linear(widths.gradient) as "ny", "normal y in units of 2^-8";
        nz: Quadratic(widths.quadratic) as "nz", "normal z in units of 2^-(2W-16)";
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
pub fn sphere_processor(at: &str, scan: Scan, words: Sphere) -> Visible {
    object_processor(KIND, at, (scan, words), |Scan { flags, pixel }, words| {
        let sum = words.depth_sum.width();
        net! {
            let in_box_late = words.screen_box.contains(pixel).reg();
            let is_outside = pe2("outline", flags, words.outline).is_negative();
            let near_depth = pe2("front", flags, words.front).high(sum);
            let kept_near = near_depth.reg();
            let kept_far = (words.depth_sum - near_depth).reg();
            let kept_there = (in_box_late & !is_outside).reg();
        }
        let near = Clamped::of("near", kept_near, NEAR_ROOT);
        let far = Clamped::of("far", kept_far, FAR_ROOT);
        net! { let is_present = kept_there & !(near.is_far | far.is_low); }
        let sphere = Seen {
            zf: near.depth,
            zb: far.depth,
            number: near.face,
        };
        let nothing = Seen::absent(sum - 2);
        let late_seen = is_present.select(sphere, nothing).registered();
        let seen = late_seen.registered();
        // The normal is used two clocks later than the depth.
        let late = flags.delayed(2);
        let component = |value: Int| value.high(NORMAL);
        let normal = Normal::of([
            component(pe1("normal_x", late, words.nx)),
            component(pe1("normal_y", late, words.ny)),
            component(pe2("normal_z", late, words.nz)),
        ]);
        let none = Int::new(0, NORMAL);
        let to_viewer = Normal::of([none, none, end(near_end, NORMAL)]);
        let of_face = late_seen.number.is(CAP).select(to_viewer, normal);
        let out_valid = flags.valid.delayed_as("valid_late", 4);
        let normal = is_present
            .delayed_as("present_late", 1)
            .select(of_face, Normal::of([none; 3]));
        seen.with(out_valid, normal.registered())
    })
}
