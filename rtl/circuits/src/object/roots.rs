//! The roots of a quadric in its screen box.

use super::{Network, ScreenBox, quadric_pe};
use crate::raster::{Flags, Linear, Quadratic, Scan};
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

impl Roots {
    /// Bits of a depth word.
    pub(super) fn depth(&self) -> u32 {
        self.near_sum.width() - 2
    }
}

/// Both depths of a quadric beside the test of its screen box; with them the root, and the flags three clocks before.
///
/// Latency `ceil(rows / rows_per_stage) + 2`.
pub(super) fn roots(
    scan: Scan,
    screen_box: ScreenBox,
    words: (Linear, Quadratic),
    network: Network,
) -> (Roots, Bits, Flags) {
    let (depths, early) = quadric_pe("quadric", scan.flags, words, network);
    let in_box = screen_box.contains(scan.pixel);
    let roots = Roots {
        near_sum: depths.near_sum,
        far_sum: depths.far_sum,
        is_inside: depths.is_inside,
        in_box: in_box.delayed_as("in_box_late", network.latency() + 2),
    };
    (roots, depths.root, early)
}
