//! The two depths of a quadric.

use crate::arith::square_root;
use crate::raster::{Flags, Linear, Quadratic, pe1, pe2};
use imogene_hdl::{Bundle, Value, bundle, module, net};

bundle! {
    /// Both depths, as far as f2 is not negative.
    Depths(width) {
        near_sum: Int(width + 2), "f1 - r, wrapped";
        far_sum: Int(width + 2), "f1 + r, wrapped";
        root: Bits(width), "r";
        is_inside: Bits(1), "f2 is not negative; the others mean nothing where it is";
    }
}

/// `f1 - r` and `f1 + r` with `r = floor(sqrt(f2))`: a PE2, the root network behind it, and a PE1 started late enough to meet the
/// root. With it the flags as the PE1 has them.
///
/// Latency `ceil(digits / rows_per_stage) + 2`. Section 2.4.2.
pub fn quadric_pe(
    at: &str,
    flags: Flags,
    (f1, f2): (Linear, Quadratic),
    rows_per_stage: u32,
) -> (Depths, Flags) {
    let inputs = (flags, ("f1", f1), ("f2", f2));
    let (depths, (_, late)) = module("quadric_pe", at, inputs, |(flags, (_, f1), (_, f2))| {
        let digits = f2.f.width() / 2;
        let stages = digits.div_ceil(rows_per_stage);
        let f2 = pe2("f2", flags, f2);
        let late = flags.delayed(stages);
        let f1 = pe1("f1", late, f1);
        let found = square_root("square_root", f2.bits(), rows_per_stage);
        net! {
            let step = found.root.extend(f1.width()).int();
            let kept_near_sum = (f1 - step).reg();
            let kept_far_sum = (f1 + step).reg();
            let kept_root = found.root.reg();
            let is_outside = f2.is_negative().delay(stages + 1);
        }
        let depths = Depths {
            near_sum: kept_near_sum,
            far_sum: kept_far_sum,
            root: kept_root,
            is_inside: !is_outside,
        };
        (depths, ("late", late))
    });
    (depths, late)
}
