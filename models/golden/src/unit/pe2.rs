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
        let (x, y) = (x as i128, y as i128);
        let along = self.a.wrapping_mul(x).wrapping_add(self.d);
        let along = along.wrapping_add(self.c.wrapping_mul(y)).wrapping_mul(x);
        let down = self.b.wrapping_mul(y).wrapping_add(self.e).wrapping_mul(y);
        wrap(along.wrapping_add(down).wrapping_add(self.f), width)
    }

    /// The same expression seen from a zone whose first pixel is (x0, y0) (source: 2.4.4, with the constant it drops).
    pub fn from_zone(&self, x0: i64, y0: i64) -> Quadratic {
        let (k, l) = (x0 as i128, y0 as i128);
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
        let (m, n) = (pixels.dx as i128, pixels.dy as i128);
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
        PreconditionedWords {
            a2: wrap(2 * self.a, width),
            b2: wrap(2 * self.b, width),
            c: wrap(self.c, width),
            i0: wrap(self.e + self.b, width),
            p0: wrap(self.d + self.a, width),
            f: wrap(self.f, width),
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn raster(coefficients: [i128; 6], width: u32, columns: usize, lines: usize) -> Vec<Vec<i128>> {
        let mut pe = Pe2::object_start(&Quadratic::new(coefficients), width);
        (0..lines)
            .map(|line| {
                if line > 0 {
                    pe.line_step();
                }
                (0..columns).map(|_| pe.pixel()).collect()
            })
            .collect()
    }

    #[test]
    fn vectors_of_the_specification() {
        assert_eq!(
            raster([2, 3, 1, -4, 5, 6], 48, 5, 3),
            [
                [6, 4, 6, 12, 22],
                [14, 13, 16, 23, 34],
                [28, 28, 32, 40, 52]
            ]
        );
        let circle = raster([-1, -1, 0, 8, 8, -16], 48, 9, 5);
        assert_eq!(circle[0], [-16, -9, -4, -1, 0, -1, -4, -9, -16]);
        assert_eq!(circle[1], [-9, -2, 3, 6, 7, 6, 3, -2, -9]);
        assert_eq!(circle[4], [0, 7, 12, 15, 16, 15, 12, 7, 0]);
        let p = |n: u32| 1i128 << n;
        assert_eq!(
            raster([p(47) - 1, -p(47), p(40), -p(46), p(46), -1], 48, 4, 3),
            [
                [-1, 70368744177662, 140737488355323, -70368744177674],
                [
                    -70368744177665,
                    1099511627774,
                    72567767433211,
                    -137438953472010
                ],
                [
                    140737488355327,
                    -68169720922114,
                    4398046511099,
                    76965813944310
                ]
            ]
        );
    }

    /// The IMOGENE datapath adds before it outputs and starts at (1, 1): the same polynomial one pixel later.
    #[test]
    fn imogene_origin_is_one_pixel_later() {
        let q = Quadratic::new([2, 3, 1, -4, 5, 6]);
        let shifted = q.from_zone(1, 1);
        let values: Vec<i128> = (0..5).map(|x| shifted.wrapped_at(x, 0, 48)).collect();
        assert_eq!(values, [13, 16, 23, 34, 49]);
    }

    proptest! {
        #[test]
        fn equals_the_exact_polynomial_modulo_its_width(
            v in proptest::array::uniform6(any::<i64>()), width in 2u32..=64
        ) {
            let coefficients = v.map(i128::from);
            let q = Quadratic::new(coefficients);
            let modulus = BigInt::from(1) << width;
            for (y, line) in raster(coefficients, width, 7, 7).iter().enumerate() {
                for (x, &value) in line.iter().enumerate() {
                    let difference = q.exact_at(x as i64, y as i64) - value;
                    prop_assert_eq!(difference % &modulus, BigInt::ZERO);
                    prop_assert!(value == wrap(value, width));
                    prop_assert_eq!(value, q.wrapped_at(x as i64, y as i64, width));
                }
            }
        }

        #[test]
        fn zones_and_interleaved_lines_are_coefficient_changes(
            v in proptest::array::uniform6(-1_000_000i64..1_000_000), k in -500i64..500, l in -500i64..500, x in 0i64..64, y in 0i64..64
        ) {
            let q = Quadratic::new(v.map(i128::from));
            prop_assert_eq!(q.from_zone(k, l).exact_at(x, y), q.exact_at(x + k, y + l));
        }
    }
}
