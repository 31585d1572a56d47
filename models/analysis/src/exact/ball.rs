//! Ball arithmetic: real numbers within a radius of a floating-point number. A sign is proven, or left to exact
//! arithmetic.

use super::number::Number;
use num_bigint::BigInt;
use num_traits::ToPrimitive;
use std::cmp::Ordering;

/// A number no further than `radius` from `middle`; not finite where nothing is known of it.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    middle: f64,
    radius: f64,
}

/// Twice what rounding to the nearest changes at the most, over the result.
const ROUNDING: f64 = f64::EPSILON;
/// Covers the roundings of a radius, of which there are fewer than eight.
const UP: f64 = 1.0 + 8.0 * f64::EPSILON;
/// Bits of a middle.
const BITS: i64 = 53;
/// Powers of two beyond which products could leave the range of exponents.
const RANGE: i64 = 250;

impl Ball {
    /// A number `radius` about `middle`.
    pub fn new(middle: f64, radius: f64) -> Ball {
        Ball { middle, radius }
    }

    /// `number / 2^exponent`.
    pub fn scaled(number: &BigInt, exponent: i64) -> Ball {
        let dropped = (number.bits() as i64 - BITS).max(0);
        // Rounded down, which is less than one off.
        let whole = (number >> dropped).to_i64().expect("53 bits") as f64;
        let power = dropped - exponent;
        if power < -RANGE {
            return Ball::new(0.0, 2f64.powi((BITS - RANGE) as i32));
        }
        if power > RANGE {
            return Ball::new(0.0, f64::INFINITY);
        }
        let unit = 2f64.powi(power as i32);
        let radius = if dropped > 0 { unit } else { 0.0 };
        Ball::new(whole * unit, radius)
    }

    fn is_zero(self) -> bool {
        self.middle == 0.0 && self.radius == 0.0
    }
}

impl Number for Ball {
    type Factor = Ball;

    fn whole(&self, value: i8) -> Ball {
        Ball::new(value.into(), 0.0)
    }

    fn of(&self, factor: &Ball) -> Ball {
        *factor
    }

    fn times(&self, factor: &Ball) -> Ball {
        self.product(factor)
    }

    fn plus(&self, other: &Ball) -> Ball {
        let middle = self.middle + other.middle;
        let radius = self.radius + other.radius + middle.abs() * ROUNDING;
        Ball::new(middle, radius * UP)
    }

    fn negated(&self) -> Ball {
        Ball::new(-self.middle, self.radius)
    }

    fn product(&self, other: &Ball) -> Ball {
        if self.is_zero() || other.is_zero() {
            return Ball::new(0.0, 0.0);
        }
        let middle = self.middle * other.middle;
        let radius = self.middle.abs() * other.radius
            + self.radius * (other.middle.abs() + other.radius)
            + middle.abs() * ROUNDING;
        // What is too small for a floating-point number is less than the smallest normal one.
        Ball::new(middle, (radius + f64::MIN_POSITIVE) * UP)
    }

    fn known_sign(&self) -> Option<Ordering> {
        let is_known = self.is_zero() || self.middle.abs() > self.radius;
        self.middle.partial_cmp(&0.0).filter(|_| is_known)
    }
}

/// The exponent that makes the greatest of some numbers about 1.
pub(super) fn exponent<'a>(numbers: impl IntoIterator<Item = &'a BigInt>) -> i64 {
    let bits = numbers.into_iter().map(|number| number.bits() as i64);
    bits.max().unwrap_or(0)
}

/// Numbers divided by one power of two, so that the greatest is about 1.
pub(super) fn balls<const N: usize>(numbers: &[BigInt; N]) -> [Ball; N] {
    let exponent = exponent(numbers);
    numbers
        .each_ref()
        .map(|number| Ball::scaled(number, exponent))
}
