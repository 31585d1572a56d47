//! Arithmetic on ranges in `f64`, rounded outwards, and expressions with such coefficients.

use super::super::depth::Range;
use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Bits of the greatest coefficient that is converted as it is; products of three stay finite.
const MOST_BITS: u64 = 300;

impl Range {
    /// One value.
    pub const fn point(value: f64) -> Range {
        Range::new(value, value)
    }

    fn outward(low: f64, high: f64) -> Range {
        Range::new(low.next_down(), high.next_up())
    }

    /// The sign that all values have; `None` if zero may be among them.
    pub fn sign(&self) -> Option<i8> {
        if self.low > 0.0 {
            Some(1)
        } else {
            (self.high < 0.0).then_some(-1)
        }
    }

    /// Of the root of what is not negative in it.
    pub fn root(&self) -> Range {
        let [low, high] = [self.low, self.high].map(|v| v.max(0.0).sqrt());
        Range::new(low.next_down().max(0.0), high.next_up())
    }
}

impl Add for Range {
    type Output = Range;
    fn add(self, other: Range) -> Range {
        Range::outward(self.low + other.low, self.high + other.high)
    }
}

impl Neg for Range {
    type Output = Range;
    fn neg(self) -> Range {
        Range::new(-self.high, -self.low)
    }
}

impl Sub for Range {
    type Output = Range;
    fn sub(self, other: Range) -> Range {
        self + -other
    }
}

impl Mul for Range {
    type Output = Range;
    fn mul(self, other: Range) -> Range {
        let ends = [
            self.low * other.low,
            self.low * other.high,
            self.high * other.low,
            self.high * other.high,
        ];
        let low = ends.into_iter().fold(f64::INFINITY, f64::min);
        let high = ends.into_iter().fold(f64::NEG_INFINITY, f64::max);
        Range::outward(low, high)
    }
}

/// By a range without zero; else of any number.
impl Div for Range {
    type Output = Range;
    fn div(self, other: Range) -> Range {
        if other.sign().is_none() {
            return Range::new(f64::NEG_INFINITY, f64::INFINITY);
        }
        self * Range::outward(1.0 / other.high, 1.0 / other.low)
    }
}

/// `a x + b y + c`.
#[derive(Clone, Copy, Debug)]
pub struct Line([Range; 3]);

impl Line {
    /// Its values where the coordinates are in these ranges.
    pub fn at(&self, [x, y]: [Range; 2]) -> Range {
        let [a, b, c] = self.0;
        a * x + b * y + c
    }
}

/// `a x^2 + b y^2 + c x y + d x + e y + f`.
#[derive(Clone, Copy, Debug)]
pub struct Conic([Range; 6]);

impl Conic {
    /// Its values where the coordinates are in these ranges.
    pub fn at(&self, [x, y]: [Range; 2]) -> Range {
        let [a, b, c, d, e, f] = self.0;
        (a * x + c * y + d) * x + (b * y + e) * y + f
    }
}

/// Bits by which all coefficients of one equation are shortened, so that they fit.
pub fn excess<'a>(all: impl IntoIterator<Item = &'a BigInt>) -> u64 {
    let most = all.into_iter().map(BigInt::bits).max().unwrap_or(0);
    most.saturating_sub(MOST_BITS)
}

/// The expression with these coefficients over `2^excess`.
pub fn line(coefficients: &[BigInt; 3], excess: u64) -> Line {
    Line(coefficients.each_ref().map(|c| range(c, excess)))
}

/// The same of second degree.
pub fn conic(coefficients: &[BigInt; 6], excess: u64) -> Conic {
    Conic(coefficients.each_ref().map(|c| range(c, excess)))
}

/// An integer over `2^excess`.
pub fn range(value: &BigInt, excess: u64) -> Range {
    let short = value >> excess;
    let near = short.to_f64().expect("of a few hundred bits");
    if excess == 0 && value.abs().bits() <= 53 {
        return Range::point(near);
    }
    // Shifting drops less than one, the conversion less than a unit of the last place.
    Range::new(near.next_down(), (near.next_up() + 1.0).next_up())
}
