//! Numbers known to lie between two `f64`, rounded outwards.
//!
//! An operation of `f64` is off by at most half a unit of the last place, so one step down and one step up enclose the
//! true result. Where that is meaningless, at infinities and in a division by an interval that holds zero, the result
//! is the whole line.

use num_rational::BigRational;
use num_traits::{FromPrimitive, ToPrimitive};
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// All numbers from `lo` to `hi`, ends included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The least of them.
    pub lo: f64,
    /// The greatest of them.
    pub hi: f64,
}

impl Interval {
    /// Zero alone.
    pub const ZERO: Interval = Interval::point(0.0);
    /// Any number.
    pub const WHOLE: Interval = Interval::new(f64::NEG_INFINITY, f64::INFINITY);

    /// From the least number to the greatest.
    pub const fn new(lo: f64, hi: f64) -> Interval {
        Interval { lo, hi }
    }

    /// One number.
    pub const fn point(value: f64) -> Interval {
        Interval::new(value, value)
    }

    /// The numbers of magnitude up to `reach`.
    pub const fn within(reach: f64) -> Interval {
        Interval::new(-reach, reach)
    }

    /// The narrowest interval about an exact value, at most two steps wide.
    pub fn about(value: &BigRational) -> Interval {
        let nearest = value.to_f64().unwrap_or(f64::NAN);
        let Some(back) = BigRational::from_f64(nearest) else {
            return Interval::WHOLE;
        };
        match back.cmp(value) {
            Ordering::Equal => Interval::point(nearest),
            Ordering::Less => Interval::new(nearest, nearest.next_up()),
            Ordering::Greater => Interval::new(nearest.next_down(), nearest),
        }
    }

    /// One step out at each end; the whole line if the ends are no numbers.
    fn outwards(lo: f64, hi: f64) -> Interval {
        if lo.is_nan() || hi.is_nan() {
            return Interval::WHOLE;
        }
        Interval::new(lo.next_down(), hi.next_up())
    }

    /// Out over the results for both ends of two intervals.
    fn over_corners(self, other: Interval, of: fn(f64, f64) -> f64) -> Interval {
        let of_both = |own: f64| [of(own, other.lo), of(own, other.hi)];
        let ([a, b], [c, d]) = (of_both(self.lo), of_both(self.hi));
        let all = [a, b, c, d];
        // `min` and `max` would skip a number that is none.
        if all.iter().any(|v| v.is_nan()) {
            return Interval::WHOLE;
        }
        let least = all.into_iter().fold(f64::INFINITY, f64::min);
        let greatest = all.into_iter().fold(f64::NEG_INFINITY, f64::max);
        Interval::outwards(least, greatest)
    }

    /// True if it is the number zero.
    pub fn is_zero(self) -> bool {
        self.lo == 0.0 && self.hi == 0.0
    }

    /// True if zero is one of its numbers.
    pub fn holds_zero(self) -> bool {
        self.lo <= 0.0 && self.hi >= 0.0
    }

    /// Width.
    pub fn width(self) -> f64 {
        self.hi - self.lo
    }

    /// Middle.
    pub fn middle(self) -> f64 {
        self.lo + 0.5 * (self.hi - self.lo)
    }

    /// Certainly smaller than any number of the other.
    pub fn below(self, other: Interval) -> bool {
        self.hi < other.lo
    }

    /// Certainly smaller than, or equal to, any number of the other.
    pub fn not_above(self, other: Interval) -> bool {
        self.hi <= other.lo
    }

    /// The greater of a number of each.
    pub fn max(self, other: Interval) -> Interval {
        Interval::new(self.lo.max(other.lo), self.hi.max(other.hi))
    }

    /// The smaller of a number of each.
    pub fn min(self, other: Interval) -> Interval {
        Interval::new(self.lo.min(other.lo), self.hi.min(other.hi))
    }

    /// Square roots; numbers below zero are left out.
    pub fn sqrt(self) -> Interval {
        let [lo, hi] = [self.lo, self.hi].map(|end| end.max(0.0).sqrt());
        let lo = if lo > 0.0 { lo.next_down() } else { 0.0 };
        Interval::new(lo, hi.next_up())
    }

    /// Powers of numbers that are not negative.
    pub fn power(self, exponent: u32) -> Interval {
        match exponent {
            0 => Interval::point(1.0),
            1 => self,
            n if n % 2 == 0 => self.square().power(n / 2),
            n => self * self.square().power(n / 2),
        }
    }

    /// Widened by as much at both ends.
    pub fn widened(self, reach: f64) -> Interval {
        self + Interval::within(reach)
    }

    /// Numbers below an interval's least are its least, those above its greatest its greatest.
    pub fn clamped(self, lo: f64, hi: f64) -> Interval {
        Interval::new(self.lo.clamp(lo, hi), self.hi.clamp(lo, hi))
    }

    /// Squares.
    pub fn square(self) -> Interval {
        let (a, b) = (self.lo * self.lo, self.hi * self.hi);
        let Interval { lo, hi } = Interval::outwards(a.min(b), a.max(b));
        let lo = if self.holds_zero() { 0.0 } else { lo.max(0.0) };
        Interval { lo, hi }
    }
}

impl Add for Interval {
    type Output = Interval;
    fn add(self, other: Interval) -> Interval {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        Interval::outwards(self.lo + other.lo, self.hi + other.hi)
    }
}

impl Sub for Interval {
    type Output = Interval;
    fn sub(self, other: Interval) -> Interval {
        self + -other
    }
}

impl Neg for Interval {
    type Output = Interval;
    fn neg(self) -> Interval {
        Interval::new(-self.hi, -self.lo)
    }
}

impl Mul for Interval {
    type Output = Interval;
    fn mul(self, other: Interval) -> Interval {
        if self.is_zero() || other.is_zero() {
            return Interval::ZERO;
        }
        self.over_corners(other, f64::mul)
    }
}

impl Div for Interval {
    type Output = Interval;
    fn div(self, other: Interval) -> Interval {
        if other.holds_zero() {
            return Interval::WHOLE;
        }
        if self.is_zero() {
            return Interval::ZERO;
        }
        self.over_corners(other, f64::div)
    }
}

/// The narrowest intervals about exact values; exact zeros stay so.
pub fn about_all<const N: usize>(values: &[BigRational; N]) -> [Interval; N] {
    values.each_ref().map(Interval::about)
}

/// The sum of the products of numbers of each.
pub(crate) fn dot<const N: usize>(u: &[Interval; N], v: &[Interval; N]) -> Interval {
    let products = u.iter().zip(v).map(|(u, v)| *u * *v);
    products.fold(Interval::ZERO, Interval::add)
}
