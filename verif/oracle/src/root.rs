//! Parameters of hits, exactly: fractions, and roots of whole quadratic polynomials.
//!
//! A root is its polynomial and its side of the vertex. It is compared with a fraction by the polynomial's sign there;
//! two roots are first tested for being the same number, which polynomials that are not proportional allow at one
//! fraction only, and then told apart by narrowing both.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use std::cmp::Ordering;

/// `a t^2 + 2 b t + c`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quadratic {
    /// Factor of t^2.
    pub a: BigInt,
    /// Half the factor of t.
    pub b: BigInt,
    /// Constant.
    pub c: BigInt,
}

impl Quadratic {
    /// `b^2 - a c`, a quarter of what is usually called so.
    pub fn discriminant(&self) -> BigInt {
        &self.b * &self.b - &self.a * &self.c
    }

    /// Sign at a fraction.
    pub fn sign_at(&self, t: &BigRational) -> Ordering {
        let (n, d) = (t.numer(), t.denom());
        let two_b = &self.b * 2;
        let value: BigInt = &self.a * n * n + two_b * n * d + &self.c * d * d;
        value.cmp(&BigInt::zero())
    }

    /// Sign of half the derivative, `a t + b`, at a fraction.
    pub fn slope_at(&self, t: &BigRational) -> Ordering {
        (&self.a * t.numer() + &self.b * t.denom()).cmp(&BigInt::zero())
    }
}

/// A real number.
#[derive(Clone, Debug)]
pub enum Real {
    /// A fraction.
    Fraction(BigRational),
    /// A root of a polynomial with a > 0 and a discriminant that is not negative.
    Root {
        /// The polynomial.
        of: Quadratic,
        /// The greater of its roots.
        greater: bool,
    },
}

impl Real {
    /// A root of a polynomial of second degree that has roots; the polynomial may open downwards.
    pub fn root(of: &Quadratic, greater: bool) -> Real {
        debug_assert!(!of.a.is_zero() && !of.discriminant().is_negative());
        let mut of = of.clone();
        if of.a.is_negative() {
            (of.a, of.b, of.c) = (-of.a, -of.b, -of.c);
        }
        Real::Root { of, greater }
    }

    /// Order against a fraction.
    pub fn cmp_fraction(&self, t: &BigRational) -> Ordering {
        match self {
            Real::Fraction(own) => own.cmp(t),
            Real::Root { of, greater } => match of.sign_at(t) {
                // Between the roots.
                Ordering::Less if *greater => Ordering::Greater,
                Ordering::Less => Ordering::Less,
                Ordering::Greater => of.slope_at(t).reverse(),
                Ordering::Equal => match (of.slope_at(t), greater) {
                    (Ordering::Less, true) => Ordering::Greater,
                    (Ordering::Greater, false) => Ordering::Less,
                    _ => Ordering::Equal,
                },
            },
        }
    }

    /// Order against another.
    pub fn compare(&self, other: &Real) -> Ordering {
        match (self, other) {
            (_, Real::Fraction(t)) => self.cmp_fraction(t),
            (Real::Fraction(t), _) => other.cmp_fraction(t).reverse(),
            (Real::Root { of: p, greater: g }, Real::Root { of: q, greater: h }) => {
                // q.a p - p.a q = 2 first t + last, which is zero at a root of both.
                let first = &q.a * &p.b - &p.a * &q.b;
                let last = &q.a * &p.c - &p.a * &q.c;
                if first.is_zero() && last.is_zero() {
                    return match p.discriminant().is_zero() {
                        true => Ordering::Equal,
                        false => g.cmp(h),
                    };
                }
                if !first.is_zero() {
                    let t = BigRational::new(-last, first * 2);
                    let is_there = |own: &Real| own.cmp_fraction(&t) == Ordering::Equal;
                    if is_there(self) && is_there(other) {
                        return Ordering::Equal;
                    }
                }
                let mut bits = 64;
                loop {
                    let (one, two) = (self.between(bits), other.between(bits));
                    if one.1 < two.0 {
                        return Ordering::Less;
                    }
                    if two.1 < one.0 {
                        return Ordering::Greater;
                    }
                    bits *= 2;
                }
            }
        }
    }

    /// Two fractions about it, closer together the more `bits` of the root are taken.
    pub fn between(&self, bits: u32) -> (BigRational, BigRational) {
        match self {
            Real::Fraction(t) => (t.clone(), t.clone()),
            Real::Root { of, greater } => {
                // (-b -+ sqrt(d)) / a, the root between two whole numbers of units of 2^-bits.
                let root: BigInt = (of.discriminant() << (2 * bits)).sqrt();
                let next: BigInt = &root + 1;
                let (low, high) = match greater {
                    true => (root, next),
                    false => (-next, -root),
                };
                let fraction = |root| BigRational::new(root - (&of.b << bits), &of.a << bits);
                (fraction(low), fraction(high))
            }
        }
    }
}
