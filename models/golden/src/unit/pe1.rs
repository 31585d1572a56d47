//! PE1, the first-degree elementary processor: `a x + b y + c` by one addition per pixel (source: 2.3.2, B.2.1).

use super::lattice::Lattice;
use crate::format::wrap;
use num_bigint::BigInt;
use serde::{Deserialize, Serialize};

/// Coefficients of a first-degree expression in pixel column x and line y.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Linear {
    /// Factor of x.
    pub a: i128,
    /// Factor of y.
    pub b: i128,
    /// Value at (0, 0).
    pub c: i128,
}

impl Linear {
    /// A new expression `a x + b y + c`.
    pub const fn new(a: i128, b: i128, c: i128) -> Linear {
        Linear { a, b, c }
    }

    /// The exact value at a pixel: the reference PE1 is measured against.
    pub fn exact_at(&self, x: i64, y: i64) -> BigInt {
        BigInt::from(self.a) * x + BigInt::from(self.b) * y + self.c
    }

    /// The value at a pixel modulo 2^width: the closed form of what PE1 emits.
    pub fn wrapped_at(&self, x: i64, y: i64, width: u32) -> i128 {
        let sum = self
            .a
            .wrapping_mul(i128::from(x))
            .wrapping_add(self.b.wrapping_mul(i128::from(y)))
            .wrapping_add(self.c);
        wrap(sum, width)
    }

    /// The same expression seen from a zone whose first pixel is (x0, y0).
    pub fn from_zone(&self, x0: i64, y0: i64) -> Linear {
        Linear {
            c: self.a * i128::from(x0) + self.b * i128::from(y0) + self.c,
            ..*self
        }
    }

    /// The expression at the pixels of a lattice alone.
    pub fn on(&self, pixels: &Lattice) -> Linear {
        let moved = self.from_zone(pixels.x0, pixels.y0);
        Linear {
            a: moved.a * i128::from(pixels.dx),
            b: moved.b * i128::from(pixels.dy),
            ..moved
        }
    }

    /// The coefficient words as a register of `width` bits holds them.
    pub fn wrapped(&self, width: u32) -> Linear {
        let [a, b, c] = [self.a, self.b, self.c].map(|v| wrap(v, width));
        Linear::new(a, b, c)
    }
}

/// The incremental processor, command by command as in the source's simulator; every register wraps at `width` bits.
#[derive(Clone, Debug)]
pub struct Pe1 {
    width: u32,
    per_pixel: i128,
    per_line: i128,
    line: i128,
    value: i128,
}

impl Pe1 {
    /// Command 0, object start: load the coefficients.
    pub fn object_start(coefficients: &Linear, width: u32) -> Pe1 {
        let word = coefficients.wrapped(width);
        Pe1 {
            width,
            per_pixel: word.a,
            per_line: word.b,
            line: word.c,
            value: word.c,
        }
    }

    /// Command 1, line step: go to the first pixel of the next line.
    pub fn line_step(&mut self) {
        self.line = wrap(self.line + self.per_line, self.width);
        self.value = self.line;
    }

    /// Command 2, pixel: emit the value first, then step to the next pixel.
    pub fn pixel(&mut self) -> i128 {
        let emitted = self.value;
        self.value = wrap(self.value + self.per_pixel, self.width);
        emitted
    }
}
