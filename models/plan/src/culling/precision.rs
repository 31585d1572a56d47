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
        let mut found = Found::default();
        for (x, y) in words.screen_box.each() {
            found.visit(words, format, x, y);
        }
        found.bits()
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

/// Values at the pixels visited so far.
#[derive(Default)]
struct Found {
    sums: Option<Range>,
    radicands: Option<Range>,
    root: i64,
    planes: Option<Range>,
}

fn join(range: &mut Option<Range>, value: i128) {
    *range = Some(range.unwrap_or(Range::NONE).with(value));
}

impl Found {
    fn visit(&mut self, words: &QuadricWords, format: &Format, x: i64, y: i64) {
        let depths = words.probe_at(x, y, format).depths;
        join(&mut self.radicands, depths.f2.into());
        if depths.f2 >= 0 {
            self.root = self.root.max(depths.root);
            join(&mut self.sums, depths.near.into());
            join(&mut self.sums, depths.far.into());
        }
        if depths.f2 >= 0 || words.class == Class::Front {
            for plane in &words.planes {
                join(&mut self.planes, plane.depth.wrapped_at(x, y, format.plane));
            }
        }
    }

    fn bits(&self) -> Bits {
        let bits = |range: &Option<Range>| range.map_or(0, |range| range.bits());
        Bits {
            sum: bits(&self.sums),
            quadratic: bits(&self.radicands),
            root: 64 - self.root.leading_zeros(),
            plane: bits(&self.planes),
        }
    }
}

/// Guard bits of f1 and f2 with which rounding the coefficients of an object `pixels` wide moves neither by more than
/// half a count: `log2 n + 1` and `2 log2 n + 1`.
pub const fn guard_bits(pixels: u64) -> [u32; 2] {
    let log = pixels.next_power_of_two().trailing_zeros();
    [log + 1, 2 * log + 1]
}
