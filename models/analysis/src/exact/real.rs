//! Real numbers with one square root, compared exactly.

use super::ball::Ball;
use super::number::Number;
use super::surd::{Surd, order, sign_with_root};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};
use std::cmp::Ordering;

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
        SurdReal::new(p, 0, BigInt::zero(), d)
    }

    /// `(p + s sqrt(q)) / d`, any d but zero.
    pub fn new(p: BigInt, s: i32, q: BigInt, d: BigInt) -> SurdReal {
        debug_assert!(!q.is_negative() && !d.is_zero());
        let (p, s, d) = if d.is_negative() {
            (-p, -s, -d)
        } else {
            (p, s, d)
        };
        // Without a root its radicand is zero, which the comparisons rely on.
        let (s, q) = if s == 0 || q.is_zero() {
            (0, BigInt::zero())
        } else {
            (s, q)
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
    match (left, right) {
        (_, 0) => left,
        (Ordering::Equal, 1) | (Ordering::Greater, 1) => Ordering::Greater,
        (Ordering::Equal, _) | (Ordering::Less, -1) => Ordering::Less,
        // (a + s sqrt(b))^2 against c: a^2 + b - c + 2 s a sqrt(b).
        _ => {
            let rational = a * a + b - c;
            let product = BigInt::from(2 * s) * a;
            let square = &product * &product * b;
            let against = sign_with_root(&rational, order(&product) as i32, &square);
            match left {
                Ordering::Greater => against,
                _ => against.reverse(),
            }
        }
    }
}
