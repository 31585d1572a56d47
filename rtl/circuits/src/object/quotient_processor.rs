//! Processor of quadrics whose depth is a quotient.

use super::quadric_processor::{cut_by_planes, levels_beyond};
use super::{Gradients, Network, Plane, Roots, ScreenBox, Visible, Widths, object_processor};
use crate::arith::{quotient, quotient_clocks};
use crate::raster::{Linear, Quadratic, Scan, pe1, pe2};
use imogene_contract::words::{PATCH, SIDE};
use imogene_hdl::{Bits, Bundle, Int, Value, bundles, join, net};

bundles! {
    /// Words of a quadric that the eye lies on, or that is seen along an asymptotic direction.
    Quotient(widths: Widths, planes: u32) {
        numerator: Quadratic(widths.numerator()) as "numerator", "depth times denominator";
        denominator: Linear(widths.denominator()) as "denominator", "denominator of the depth";
        /// Words of its normal; their factors are those of the depth.
        gradients: Gradients(widths) as "";
        /// Where it may be.
        screen_box: ScreenBox() as "";
        shift: Bits(5) as "shift", "places the depth behind normal_from is shifted right for the normal";
        is_solid: Bits(1) as "is_solid", "the object is what has denominator z <= numerator, not a bare surface";
        normal_from: Int(widths.depth) as "normal_from", "no point of the object that is seen is nearer";
        planes: [Plane(widths); planes] as "plane", "plane #";
    }
}

/// Name of the module, and what numbers of faces it gives.
const KIND: (&str, &str) = (
    "quotient_processor",
    "visible face: 0 quadric, 2 + i plane i, 15 near end",
);

/// Clocks of the processor.
pub fn quotient_processor_clocks(depth: u32, rows_per_stage: u32, planes: usize) -> u32 {
    quotient_clocks(depth, rows_per_stage) + 11 + levels_beyond(planes)
}

/// For every pixel the visible front of a quadric whose equation along the line of sight is of first degree, cut by
/// planes: depth, face and normal.
///
/// One depth is a quotient; the other is beyond an end of the depth word. From there on the object is a quadric of two
/// depths. Latency `ceil(W / rows_per_stage) + 13`, and one more for each doubling of more than four planes.
/// Section 2.1.1 (c' = 0).
pub fn quotient_processor(at: &str, scan: Scan, words: Quotient, network: Network) -> Visible {
    object_processor(KIND, at, (scan, words), |scan, words| {
        let (depth, rows) = (network.depth, network.rows_per_stage);
        let numerator = pe2("numerator", scan.flags, words.numerator);
        let denominator = pe1("denominator", scan.flags, words.denominator);
        let found = quotient("quotient", (numerator, denominator), rows);
        let clocks = quotient_clocks(depth, rows);
        net! {
            let ends_there = words.is_solid & !found.is_down;
            let near_is_before = ends_there | found.is_below;
            let far_is_behind = !ends_there | (found.is_above & !found.is_below);
            let near_is_behind = found.is_above & !near_is_before;
            let far_is_before = found.is_below & !far_is_behind;
            let kept_near_sum = sum(found.word, near_is_before, near_is_behind).reg();
            let kept_far_sum = sum(found.word, far_is_before, far_is_behind).reg();
            let behind = found.word.extend(depth + 1) - words.normal_from.extend(depth + 1);
            let kept_behind = behind.is_negative().select(Int::new(0, depth), behind.low(depth)).bits().reg();
            let object_class = words.is_solid.select(Bits::new(SIDE, 2), Bits::new(PATCH, 2));
        }
        let in_box = words.screen_box.contains(scan.pixel);
        let roots = Roots {
            near_sum: kept_near_sum,
            far_sum: kept_far_sum,
            is_inside: Bits::new(1, 1),
            in_box: in_box.delayed_as("in_box_late", clocks + 2),
        };
        let normal = (words.gradients, words.shift);
        let early = scan.flags.delayed(clocks - 1);
        let found = (roots, kept_behind);
        cut_by_planes(early, found, object_class, normal, words.planes)
    })
}

/// A depth sum: the word, or one before the near end, or one behind the far end.
fn sum(word: Int, is_before: Bits, is_behind: Bits) -> Int {
    let sign = word.is_negative();
    let own = |is_one: Bits, is_zero: Bits| is_one | (sign & !is_zero);
    let signs = [own(is_before, is_behind), own(is_behind, is_before)];
    join([signs[0], signs[1], word.bits()]).int()
}
