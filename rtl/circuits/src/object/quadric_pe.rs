//! The two depths of a quadric.

use crate::arith::Network;
use crate::raster::{Flags, Linear, Quadratic, pe1, pe2};
use imogene_contract::words::depth_sum;
use imogene_hdl::{Bundle, Value, bundle, module, net};

bundle! {
    /// Both depths, as far as f2 is not negative.
    Depths(sum, root) {
        near_sum: Int(sum), "f1 - r, modulo its width";
        far_sum: Int(sum), "f1 + r, modulo its width";
        root: Bits(root), "r = floor(sqrt(f2)), with the sums";
        is_inside: Bits(1), "f2 >= 0; where it is low the sums and the root mean nothing";
    }
}

/// `f1 - r` and `f1 + r` with `r = floor(sqrt(f2))`, or an approximation: a PE2, the root network behind it, and a PE1
/// started late enough to meet the root. With it the flags a clock before the PE1 has them. What f1 has beyond the bits
/// of a depth and f2 beyond two for each row are guard bits below the last one: they are dropped, rounding down.
///
/// Latency that of the network and 2. With an iterative root flags with a pixel are as many clocks apart as it has
/// digits, or more. Section 2.4.2.
pub fn quadric_pe(
    at: &str,
    flags: Flags,
    (f1, f2): (Linear, Quadratic),
    network: Network,
) -> (Depths, Flags) {
    let f1 = ("f1", f1, "linear part of the depth");
    let f2 = ("f2", f2, "quadratic under the root");
    let inputs = (flags, f1, f2);
    module("quadric_pe", at, inputs, |(flags, f1, f2)| {
        let (stages, sum) = (network.latency(), depth_sum(network.depth));
        let f2 = pe2("f2", flags, f2);
        let early = flags.delayed(stages - 1);
        let f1 = pe1("f1", early.delayed(1), f1).high(sum);
        // Without its sign, which says that the root means nothing: the first row has one place less to look at.
        let radicand = f2.high(2 * network.rows).low(2 * network.rows - 1).bits();
        let radicand = radicand.extend(2 * network.rows);
        let found = network.root("square_root", flags.delayed(1).valid, radicand);
        let root = found.extend(network.digits);
        let root = root.left(network.digits - network.rows);
        net! {
            let step = root.extend(sum).int();
            let kept_near_sum = (f1 - step).reg();
            let kept_far_sum = (f1 + step).reg();
            let kept_root = root.reg();
            let is_outside = f2.is_negative().delay(stages + 1);
        }
        let depths = Depths {
            near_sum: kept_near_sum,
            far_sum: kept_far_sum,
            root: kept_root,
            is_inside: !is_outside,
        };
        let meaning = "flags 3 clocks before the sums, for planes that are to meet them";
        (depths, ("early", early, meaning))
    })
}
