//! Expressions of second degree on the screen, in floating point.

use imogene_golden::object::quadric::ScreenBox;
use std::ops::Range;

/// `c + d x + e y + a x^2 + b y^2 + m x y`, where it is not negative an ellipse.
#[derive(Clone, Copy, Debug)]
pub(super) struct Conic {
    pub c: f64,
    pub d: f64,
    pub e: f64,
    pub a: f64,
    pub b: f64,
    pub m: f64,
}

/// `a u^2 + d u + c`: a conic on one line.
pub(super) struct Line {
    a: f64,
    d: f64,
    c: f64,
}

impl Line {
    pub fn at(&self, u: f64) -> f64 {
        (self.a * u + self.d) * u + self.c
    }

    /// The columns of a box at which the value is not below `-spare`, and perhaps one more on each side.
    pub fn columns(&self, spare: f64, at: f64, window: &ScreenBox) -> Range<i64> {
        let (square, product) = (self.d * self.d, 4.0 * self.a * (self.c + spare));
        // A pair of roots that is barely complex counts as double.
        let radicand = square - product;
        if radicand < -1e-9 * (square + product.abs()) {
            return 0..0;
        }
        let reach = radicand.max(0.0).sqrt() / (2.0 * self.a).abs();
        let middle = at - self.d / (2.0 * self.a);
        // A thousandth of a pixel covers the rounding of a root.
        let first = (middle - reach - 1e-3).ceil().max(window.x0 as f64);
        let last = (middle + reach + 1e-3).floor().min(window.x1 as f64);
        first as i64..last as i64 + 1
    }
}

impl Conic {
    /// What it is on the line `y = v`.
    pub fn on_line(&self, v: f64) -> Line {
        Line {
            a: self.a,
            d: self.d + self.m * v,
            c: self.c + (self.e + self.b * v) * v,
        }
    }

    /// The greatest value anywhere.
    pub fn greatest(&self) -> f64 {
        let determinant = 4.0 * self.a * self.b - self.m * self.m;
        let (x, y) = (
            (self.m * self.e - 2.0 * self.b * self.d) / determinant,
            (self.m * self.d - 2.0 * self.a * self.e) / determinant,
        );
        (self.c + 0.5 * (self.d * x + self.e * y)) * (1.0 + 1e-9)
    }
}
