//! PE2, the second-degree elementary processor: `a x^2 + b y^2 + c xy + d x + e y + f` by two additions per pixel
//! (source: 2.3.2, B.2.1).

use super::lattice::Lattice;
use crate::format::wrap;
use num_bigint::BigInt;
use serde::{Deserialize, Serialize};

/// Coefficients of a second-degree expression in pixel column x and line y.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Quadratic {
    /// Factor of x^2.
    pub a: i128,
    /// Factor of y^2.
    pub b: i128,
    /// Factor of x y.
    pub c: i128,
    /// Factor of x.
    pub d: i128,
    /// Factor of y.
    pub e: i128,
    /// Value at (0, 0).
    pub f: i128,
}

/// The words PE2 hardware is loaded with: differences formed beforehand, so that all its sums run in parallel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct PreconditionedWords {
    /// Second difference along a line, 2a.
    pub a2: i128,
    /// Second difference from line to line, 2b.
    pub b2: i128,
    /// Mixed difference c.
    pub c: i128,
    /// First line increment, e + b.
    pub i0: i128,
    /// First pixel increment, d + a.
    pub p0: i128,
    /// Value at (0, 0).
    pub f: i128,
}

impl PreconditionedWords {
    /// What becomes of each word, in their order on the load bus.
    pub(crate) fn map(self, mut of: impl FnMut(i128) -> i128) -> PreconditionedWords {
        PreconditionedWords {
            a2: of(self.a2),
            b2: of(self.b2),
            c: of(self.c),
            i0: of(self.i0),
            p0: of(self.p0),
            f: of(self.f),
        }
    }
}

impl Quadratic {
    /// A new expression `a x^2 + b y^2 + c x y + d x + e y + f`.
    pub const fn new([a, b, c, d, e, f]: [i128; 6]) -> Quadratic {
        Quadratic { a, b, c, d, e, f }
    }

    /// The exact value at a pixel: the reference PE2 is measured against.
    pub fn exact_at(&self, x: i64, y: i64) -> BigInt {
        (BigInt::from(self.a) * x + BigInt::from(self.c) * y + self.d) * x
            + (BigInt::from(self.b) * y + self.e) * y
            + self.f
    }

    /// The value at a pixel modulo 2^width: the closed form of what PE2 emits.
    pub fn wrapped_at(&self, x: i64, y: i64, width: u32) -> i128 {
        let (x, y) = (i128::from(x), i128::from(y));
        let along = self.a.wrapping_mul(x).wrapping_add(self.d);
        let along = along.wrapping_add(self.c.wrapping_mul(y)).wrapping_mul(x);
        let down = self.b.wrapping_mul(y).wrapping_add(self.e).wrapping_mul(y);
        wrap(along.wrapping_add(down).wrapping_add(self.f), width)
    }

    /// The same expression seen from a zone whose first pixel is (x0, y0) (source: 2.4.4, with the constant it drops).
    pub fn from_zone(&self, x0: i64, y0: i64) -> Quadratic {
        let (k, l) = (i128::from(x0), i128::from(y0));
        Quadratic {
            d: self.d + 2 * self.a * k + self.c * l,
            e: self.e + 2 * self.b * l + self.c * k,
            f: self.f + self.a * k * k + self.b * l * l + self.c * k * l + self.d * k + self.e * l,
            ..*self
        }
    }

    /// The expression at the pixels of a lattice alone (source: 2.4.4, with the term `e first` it drops).
    pub fn on(&self, pixels: &Lattice) -> Quadratic {
        let moved = self.from_zone(pixels.x0, pixels.y0);
        let (m, n) = (i128::from(pixels.dx), i128::from(pixels.dy));
        Quadratic::new([
            moved.a * m * m,
            moved.b * n * n,
            moved.c * m * n,
            moved.d * m,
            moved.e * n,
            moved.f,
        ])
    }

    /// The coefficients as registers of `width` bits hold them.
    pub fn wrapped(&self, width: u32) -> Quadratic {
        let Quadratic { a, b, c, d, e, f } = *self;
        Quadratic::new([a, b, c, d, e, f].map(|v| wrap(v, width)))
    }

    /// An expression with the same words; second differences are even, so halving them loses nothing.
    pub fn of_preconditioned(words: &PreconditionedWords) -> Quadratic {
        let (a, b) = (words.a2 >> 1, words.b2 >> 1);
        Quadratic::new([a, b, words.c, words.p0 - a, words.i0 - b, words.f])
    }

    /// The words the hardware is loaded with, as registers of `width` bits hold them.
    pub fn preconditioned(&self, width: u32) -> PreconditionedWords {
        let words = PreconditionedWords {
            a2: 2 * self.a,
            b2: 2 * self.b,
            c: self.c,
            i0: self.e + self.b,
            p0: self.d + self.a,
            f: self.f,
        };
        words.map(|word| wrap(word, width))
    }
}

/// The incremental processor, command by command as in the source's simulator; every register wraps at `width` bits.
#[derive(Clone, Debug)]
pub struct Pe2 {
    width: u32,
    a2: i128,
    b2: i128,
    c: i128,
    /// I: increment from line to line.
    line_increment: i128,
    /// Q: value at the line's first pixel.
    line: i128,
    /// P: the line's first pixel increment, before its first step.
    first_increment: i128,
    /// J: increment from pixel to pixel.
    increment: i128,
    /// V: value at the pixel.
    value: i128,
}

impl Pe2 {
    /// Command 0, object start: load the coefficients.
    pub fn object_start(coefficients: &Quadratic, width: u32) -> Pe2 {
        let q = coefficients;
        let first_increment = wrap(q.d - q.a, width);
        let value = wrap(q.f, width);
        Pe2 {
            width,
            a2: wrap(2 * q.a, width),
            b2: wrap(2 * q.b, width),
            c: wrap(q.c, width),
            line_increment: wrap(q.e - q.b, width),
            line: value,
            first_increment,
            increment: first_increment,
            value,
        }
    }

    /// Command 1, line step: go to the first pixel of the next line.
    pub fn line_step(&mut self) {
        self.line_increment = wrap(self.line_increment + self.b2, self.width);
        self.line = wrap(self.line + self.line_increment, self.width);
        self.first_increment = wrap(self.first_increment + self.c, self.width);
        self.increment = self.first_increment;
        self.value = self.line;
    }

    /// Command 2, pixel: emit the value first, then step to the next pixel.
    pub fn pixel(&mut self) -> i128 {
        let emitted = self.value;
        self.increment = wrap(self.increment + self.a2, self.width);
        self.value = wrap(self.value + self.increment, self.width);
        emitted
    }
}
