//! Where an object can be on the screen.

use crate::unit::lattice::Lattice;
use serde::{Deserialize, Serialize};

/// The screen box of an object in pixels of the zone, inclusive; empty if `x0 > x1` or `y0 > y1`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct ScreenBox {
    /// First column.
    pub x0: i64,
    /// Last column.
    pub x1: i64,
    /// First line.
    pub y0: i64,
    /// Last line.
    pub y1: i64,
}

impl ScreenBox {
    /// The box of these first and last columns and lines.
    pub const fn of([x0, x1]: [i64; 2], [y0, y1]: [i64; 2]) -> ScreenBox {
        ScreenBox { x0, x1, y0, y1 }
    }

    /// A whole screen.
    pub fn of_screen(width: u32, height: u32) -> ScreenBox {
        ScreenBox::of([0, i64::from(width) - 1], [0, i64::from(height) - 1])
    }

    /// A box that contains no pixel.
    pub const EMPTY: ScreenBox = ScreenBox::of([1, 0], [1, 0]);

    /// True if no pixel is inside.
    pub fn is_empty(&self) -> bool {
        self.x0 > self.x1 || self.y0 > self.y1
    }

    /// The least box around two, of which any may be empty.
    pub fn around(&self, other: &ScreenBox) -> ScreenBox {
        match (self.is_empty(), other.is_empty()) {
            (true, _) => *other,
            (_, true) => *self,
            _ => ScreenBox::of(
                [self.x0.min(other.x0), self.x1.max(other.x1)],
                [self.y0.min(other.y0), self.y1.max(other.y1)],
            ),
        }
    }

    /// The pixels of both.
    pub fn shared(&self, other: &ScreenBox) -> ScreenBox {
        ScreenBox::of(
            [self.x0.max(other.x0), self.x1.min(other.x1)],
            [self.y0.max(other.y0), self.y1.min(other.y1)],
        )
    }

    /// True if the boxes have a pixel in common, or pixels side by side.
    pub fn touches(&self, other: &ScreenBox) -> bool {
        let along = |a0: i64, a1: i64, b0: i64, b1: i64| a0 <= b1 + 1 && b0 <= a1 + 1;
        along(self.x0, self.x1, other.x0, other.x1) && along(self.y0, self.y1, other.y0, other.y1)
    }

    /// True if the pixel is inside.
    #[inline]
    pub fn contains(&self, x: i64, y: i64) -> bool {
        (self.x0..=self.x1).contains(&x) && (self.y0..=self.y1).contains(&y)
    }

    /// The pixels inside, line by line.
    pub fn each(&self) -> impl Iterator<Item = (i64, i64)> + use<> {
        let columns = self.x0..=self.x1;
        (self.y0..=self.y1).flat_map(move |y| columns.clone().map(move |x| (x, y)))
    }

    /// Columns and lines, 0 of a box without pixels.
    pub fn size(&self) -> [i64; 2] {
        match self.is_empty() {
            true => [0; 2],
            false => [self.x1 - self.x0 + 1, self.y1 - self.y0 + 1],
        }
    }

    /// Number of pixels inside.
    pub fn pixels(&self) -> u64 {
        let [columns, lines] = self.size();
        (columns * lines) as u64
    }

    /// The part of the box in a zone of `width` x `height` pixels whose first pixel is (x0, y0), in that zone's pixels.
    pub fn in_zone(&self, x0: i64, y0: i64, width: i64, height: i64) -> ScreenBox {
        let zone = ScreenBox::of([0, width - 1], [0, height - 1]);
        self.on(&Lattice::zone(x0, y0)).shared(&zone).or_empty()
    }

    /// The part of the box at the pixels of a lattice.
    pub fn on(&self, pixels: &Lattice) -> ScreenBox {
        let Lattice { x0, y0, dx, dy } = *pixels;
        let first = |from: i64, step: i64| (from + step - 1).div_euclid(step);
        let columns = [first(self.x0 - x0, dx), (self.x1 - x0).div_euclid(dx)];
        let lines = [first(self.y0 - y0, dy), (self.y1 - y0).div_euclid(dy)];
        ScreenBox::of(columns, lines).or_empty()
    }

    /// The same, or the usual empty one.
    pub fn or_empty(self) -> ScreenBox {
        let is_empty = self.is_empty();
        if is_empty { ScreenBox::EMPTY } else { self }
    }
}
