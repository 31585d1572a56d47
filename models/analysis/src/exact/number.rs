//! What the exact reference computes with: the numbers `u + v sqrt(q)` of one q, exactly; quotients of such numbers,
//! compared exactly; and in ball arithmetic real numbers within a radius of a floating-point number, whose sign is
//! proven or left to exact arithmetic.

use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::cmp::Ordering;
use std::sync::Arc;

/// A number whose sign is known: always, as that of a [`Surd`], or unless it is too near to zero, as that
/// of a [`Ball`].
pub trait Number: Clone {
    /// What it is multiplied by.
    type Factor;

    /// A small whole number among those that this one can meet.
    fn whole(&self, value: i8) -> Self;
    /// A factor among those that this one can meet.
    fn of(&self, factor: &Self::Factor) -> Self;
    /// The product with a factor.
    fn times(&self, factor: &Self::Factor) -> Self;
    /// The sum.
    fn plus(&self, other: &Self) -> Self;
    /// The opposite.
    fn negated(&self) -> Self;
    /// The product.
    fn product(&self, other: &Self) -> Self;
    /// The sign, against zero, where it is known.
    fn known_sign(&self) -> Option<Ordering>;

    /// The difference.
    fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }
}

/// `u + v sqrt(q)` with whole u and v; only numbers of the same q meet.
#[derive(Clone, Debug)]
pub struct Surd {
    u: BigInt,
    v: BigInt,
    q: Arc<BigInt>,
}

impl Surd {
    /// The number of these parts; q is not negative.
    pub fn new(u: BigInt, v: BigInt, q: BigInt) -> Surd {
        Surd {
            u,
            v,
            q: Arc::new(q),
        }
    }

    fn with(&self, u: BigInt, v: BigInt) -> Surd {
        Surd {
            u,
            v,
            q: self.q.clone(),
        }
    }

    /// The sign, against zero.
    pub fn sign(&self) -> Ordering {
        debug_assert!(!self.q.is_negative());
        let square = &self.v * &self.v * &*self.q;
        sign_with_root(&self.u, order(&self.v) as i32, &square)
    }
}

impl Number for Surd {
    type Factor = BigInt;

    fn whole(&self, value: i8) -> Surd {
        self.with(value.into(), BigInt::ZERO)
    }

    fn of(&self, factor: &BigInt) -> Surd {
        self.with(factor.clone(), BigInt::ZERO)
    }

    fn times(&self, factor: &BigInt) -> Surd {
        self.with(&self.u * factor, &self.v * factor)
    }

    fn plus(&self, other: &Surd) -> Surd {
        self.with(&self.u + &other.u, &self.v + &other.v)
    }

    fn negated(&self) -> Surd {
        self.with(-&self.u, -&self.v)
    }

    fn product(&self, other: &Surd) -> Surd {
        let roots = match self.v.is_zero() || other.v.is_zero() {
            true => BigInt::ZERO,
            false => &self.v * &other.v * &*self.q,
        };
        let v = &self.u * &other.v + &self.v * &other.u;
        self.with(&self.u * &other.u + roots, v)
    }

    fn known_sign(&self) -> Option<Ordering> {
        Some(self.sign())
    }
}

/// The sign, against zero.
pub(super) fn order(value: &BigInt) -> Ordering {
    value.cmp(&BigInt::ZERO)
}

/// Sign of `a + s sqrt(b)`, b >= 0.
fn sign_with_root(a: &BigInt, s: i32, b: &BigInt) -> Ordering {
    let root = if b.is_zero() { 0 } else { s };
    sign_of_sum(order(a), root, || (a * a).cmp(b))
}

/// Sign of the sum of two numbers of these signs; of opposite ones the greater square wins.
fn sign_of_sum(one: Ordering, other: i32, squares: impl FnOnce() -> Ordering) -> Ordering {
    match (one, other.cmp(&0)) {
        (Ordering::Equal, other) => other,
        (Ordering::Greater, Ordering::Less) => squares(),
        (Ordering::Less, Ordering::Greater) => squares().reverse(),
        _ => one,
    }
}

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
    let ball = |number| Ball::scaled(number, exponent);
    numbers.each_ref().map(ball)
}

/// `(p + s sqrt(q)) / d` with integers p, q >= 0, d > 0 and s = -1, 0 or 1.
#[derive(Clone, Debug)]
pub struct SurdReal {
    p: BigInt,
    s: i32,
    q: BigInt,
    d: BigInt,
}

impl SurdReal {
    /// The rational `p / d`, any d but zero.
    pub fn ratio(p: BigInt, d: BigInt) -> SurdReal {
        SurdReal::new(p, 0, BigInt::ZERO, d)
    }

    /// `(p + s sqrt(q)) / d`, any d but zero.
    pub fn new(p: BigInt, s: i32, q: BigInt, d: BigInt) -> SurdReal {
        debug_assert!(!q.is_negative() && !d.is_zero());
        let (p, s, d) = match d.is_negative() {
            true => (-p, -s, -d),
            false => (p, s, d),
        };
        // Without a root its radicand is zero, which the comparisons rely on.
        let (s, q) = match s == 0 || q.is_zero() {
            true => (0, BigInt::ZERO),
            false => (s, q),
        };
        SurdReal { p, s, q, d }
    }

    /// Numerator and positive denominator.
    pub fn as_surd(&self) -> (Surd, BigInt) {
        let numerator = Surd::new(self.p.clone(), BigInt::from(self.s), self.q.clone());
        (numerator, self.d.clone())
    }

    /// Sign of the number.
    pub fn signum(&self) -> Ordering {
        sign_with_root(&self.p, self.s, &self.q)
    }

    /// Compares with the rational `n / d`, d > 0.
    pub fn cmp_ratio(&self, n: &BigInt, d: &BigInt) -> Ordering {
        sign_with_root(&(&self.p * d - n * &self.d), self.s, &(&self.q * d * d))
    }

    /// The number, near enough to tell most of its signs.
    pub fn ball(&self) -> Ball {
        let bits = 60;
        let unit = 2f64.powi(-(bits as i32));
        let fixed = self.fixed(&BigInt::one(), &BigInt::ZERO, bits);
        // Off by a unit for the floor, one for the root.
        Ball::scaled(&fixed, bits.into()).plus(&Ball::new(0.0, 2.0 * unit))
    }

    /// floor((a * self + b) * 2^bits) up to one unit, for a > 0.
    pub fn fixed(&self, a: &BigInt, b: &BigInt, bits: u32) -> BigInt {
        let rational = (a * &self.p + b * &self.d) << bits;
        let root = ((a * a * &self.q) << (2 * bits)).sqrt() * self.s;
        num_integer::Integer::div_floor(&(rational + root), &self.d)
    }
}

impl PartialEq for SurdReal {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for SurdReal {}

impl PartialOrd for SurdReal {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for SurdReal {
    fn cmp(&self, other: &Self) -> Ordering {
        let a = &self.p * &other.d - &other.p * &self.d;
        if other.s == 0 {
            return sign_with_root(&a, self.s, &(&self.q * &other.d * &other.d));
        }
        let b = &self.q * &other.d * &other.d;
        let c = &other.q * &self.d * &self.d;
        sign_with_two_roots(&a, self.s, &b, -other.s, &c)
    }
}

/// Sign of `a + s sqrt(b) + t sqrt(c)`.
fn sign_with_two_roots(a: &BigInt, s: i32, b: &BigInt, t: i32, c: &BigInt) -> Ordering {
    let left = sign_with_root(a, s, b);
    let right = if c.is_zero() { 0 } else { t };
    // (a + s sqrt(b))^2 against c: a^2 + b - c + 2 s a sqrt(b).
    sign_of_sum(left, right, || {
        let product = BigInt::from(2 * s) * a;
        let square = &product * &product * b;
        sign_with_root(&(a * a + b - c), order(&product) as i32, &square)
    })
}
