//! The roots of a quadric in its screen box.

use super::{Network, ScreenBox, quadric_pe};
use crate::raster::{Flags, Linear, Pixel, Quadratic};
use imogene_hdl::{Bits, Value, bundle};

bundle! {
    /// What the roots of a quadric say of a pixel.
    Roots(sum) {
        near_sum: Int(sum), "f1 - r, modulo its width";
        far_sum: Int(sum), "f1 + r, modulo its width";
        is_inside: Bits(1), "f2 >= 0; where it is low the sums mean nothing";
        in_box: Bits(1), "the pixel lies in the screen box of the object";
    }
}

/// Both depths of a quadric beside the test of its screen box; with them the root, and the flags two clocks before.
///
/// Latency `ceil(rows / rows_per_stage) + 2`.
pub(super) fn roots(
    flags: Flags,
    pixel: Pixel,
    screen_box: ScreenBox,
    words: (Linear, Quadratic),
    network: Network,
) -> (Roots, Bits, Flags) {
    let (depths, late) = quadric_pe("quadric", flags, words, network);
    let roots = Roots {
        near_sum: depths.near_sum,
        far_sum: depths.far_sum,
        is_inside: depths.is_inside,
        in_box: screen_box
            .contains(pixel)
            .delayed_as("in_box_late", network.latency() + 2),
    };
    (roots, depths.root, late)
}
