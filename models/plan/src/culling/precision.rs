//! The bits that an object needs where it is drawn: the narrowest words with which every pixel stays what it is
//! (source: Claux, 13.7).

use imogene_golden::format::Format;
use imogene_golden::object::quadric::QuadricWords;
use imogene_golden::object::range::Range;
use imogene_golden::unit::depth_interval::Class;
use serde::Serialize;

/// Bits of the words of one object; two's complement, guard bits not counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Bits {
    /// Of `f1 - r` and `f1 + r`, where f2 is not negative.
    pub sum: u32,
    /// Of f2, everywhere in the box: its sign is the silhouette.
    pub quadratic: u32,
    /// Of the root, unsigned: digits of the root network.
    pub root: u32,
    /// Of the widest plane before saturation, where the quadric is; 0 without planes.
    pub plane: u32,
}

impl Bits {
    /// What an object of the quadric or the patch processor needs on its screen box, from every pixel of it; nothing if
    /// the box is empty.
    pub fn of(words: &QuadricWords, format: &Format) -> Bits {
        let [mut sums, mut radicands, mut planes] = [Range::NONE; 3];
        let mut root = 0;
        for (x, y) in words.screen_box.each() {
            let depths = words.probe_at(x, y, format).depths;
            radicands = radicands.with(depths.f2.into());
            if depths.f2 >= 0 {
                root = depths.root.max(root);
                sums = sums.with(depths.near.into()).with(depths.far.into());
            }
            if depths.f2 >= 0 || words.class == Class::Front {
                for plane in &words.planes {
                    planes = planes.with(plane.depth.wrapped_at(x, y, format.plane));
                }
            }
        }
        let bits = |range: Range| {
            if range == Range::NONE {
                0
            } else {
                range.bits()
            }
        };
        Bits {
            sum: bits(sums),
            quadratic: bits(radicands),
            root: 64 - root.leading_zeros(),
            plane: bits(planes),
        }
    }

    /// The greater of each.
    pub fn or(self, other: Bits) -> Bits {
        Bits {
            sum: self.sum.max(other.sum),
            quadratic: self.quadratic.max(other.quadratic),
            root: self.root.max(other.root),
            plane: self.plane.max(other.plane),
        }
    }
}

/// Guard bits of f1 and f2 with which rounding the coefficients of an object `pixels` wide moves neither by more than
/// half a count: `log2 n + 1` and `2 log2 n + 1`.
pub const fn guard_bits(pixels: u64) -> [u32; 2] {
    let log = pixels.next_power_of_two().trailing_zeros();
    [log + 1, 2 * log + 1]
}
