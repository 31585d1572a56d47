//! Shadow or light volume of a quadric and planes.

use super::{Answer, Bounds, Network, Roots, VolumePoint, Widths, roots};
use crate::raster::{Linear, Quadratic, Scan};
use imogene_contract::words::{FRONT, PRISM, SIDE};
use imogene_hdl::{Bits, Bundle, Int, Value, bundles, module, net};

bundles! {
    /// Words of a volume of a quadric and planes.
    VolumeWords(widths: Widths, planes: u32) {
        f1: Linear(widths.linear) as "f1", "linear part of the depth";
        f2: Quadratic(widths.quadratic) as "f2", "quadratic under the root";
        /// Screen box and planes.
        bounds: Bounds(widths, planes) as "";
        object_class: Bits(2) as "object_class",
            "class of the quadric: 0 side, 1 front, 2 patch, 3 prism; a patch has no inside";
        depth_shift: Bits(4) as "depth_shift", "the quadric's depths are in units of 2^depth_shift depth words";
    }
}

/// For every pixel whether the visible point lies in a shadow or light volume: a quadric cut by planes. The point comes
/// `ceil(rows / rows_per_stage)` clocks after its flags.
///
/// A point is in an intersection exactly if it is in every part, so every part is asked by itself: no chain of cuts, no
/// second half. Latency `ceil(rows / rows_per_stage) + 5`. The words stay unchanged until that many clocks after the
/// last flags of a zone. Sections 3.2.1 and 4.1.3.
pub fn quadric_volume(
    at: &str,
    scan: Scan,
    point: VolumePoint,
    words: VolumeWords,
    network: Network,
) -> Answer {
    let inputs = (scan, point, words);
    module("quadric_volume", at, inputs, |(scan, point, words)| {
        let f = (words.f1, words.f2);
        let (roots, _, early) = roots(scan, words.bounds.screen_box, f, network);
        let late = early.delayed(1);
        // A depth of the quadric is at or before another one exactly if it is at or before that one rounded down to
        // its unit.
        let depths = point.depths();
        let width = roots.near_sum.width();
        let [z, entered] = depths.map(|depth| depth.extend(width).right_by(words.depth_shift));
        net! {
            let coarse_z = z.reg();
            let coarse_entered = entered.reg();
            let in_quadric = is_inside(words.object_class, roots, coarse_z, coarse_entered).reg();
            let in_box = roots.in_box.delay(2);
            let is_kept = VolumePoint::is_kept(depths, late, &words.bounds.planes).reg();
        }
        Answer {
            out_valid: late.valid.delayed_as("valid_late", 5),
            is_inside: (in_box & in_quadric & is_kept).reg(),
        }
    })
}

/// 1 where a point lies inside an unbounded quadric. Where the quadric begins, `entered` is asked; where it ends, `z`.
/// Latency 1.
fn is_inside(object_class: Bits, roots: Roots, z: Int, entered: Int) -> Bits {
    let is = |class: u64| object_class.is(class);
    net! {
        let between = (!entered.less(roots.near_sum) & !roots.far_sum.less(z)).reg();
        let outside = (!roots.near_sum.less(z) | !entered.less(roots.far_sum)).reg();
        let meets = roots.is_inside.reg();
        let in_side = is(SIDE) & meets & between;
        let in_front = is(FRONT) & (!meets | outside);
        let in_prism = is(PRISM) & meets;
    }
    in_side | in_front | in_prism
}
