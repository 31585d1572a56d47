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
        let of = if of.a.is_negative() {
            Quadratic {
                a: -&of.a,
                b: -&of.b,
                c: -&of.c,
            }
        } else {
            of.clone()
        };
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
            (
                Real::Root { of: p, greater },
                Real::Root {
                    of: q,
                    greater: other_greater,
                },
            ) => {
                let is = |own: &Real, t| own.cmp_fraction(t) == Ordering::Equal;
                match common_root(p, q) {
                    Common::Both if p.discriminant().is_zero() => Ordering::Equal,
                    Common::Both => greater.cmp(other_greater),
                    Common::One(t) if is(self, &t) && is(other, &t) => Ordering::Equal,
                    _ => self.narrowed_until_apart(other),
                }
            }
        }
    }

    /// Only of different numbers.
    fn narrowed_until_apart(&self, other: &Real) -> Ordering {
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

    /// Two fractions about it, closer together the more `bits` of the root are taken.
    pub fn between(&self, bits: u32) -> (BigRational, BigRational) {
        match self {
            Real::Fraction(t) => (t.clone(), t.clone()),
            Real::Root { of, greater } => {
                // (-b -+ sqrt(d)) / a, the root between two whole numbers of units of 2^-bits.
                let root: BigInt = (of.discriminant() << (2 * bits)).sqrt();
                let next: BigInt = &root + 1;
                let (low, high) = if *greater {
                    (root, next)
                } else {
                    (-next, -root)
                };
                let fraction =
                    |root: BigInt| BigRational::new(root - (&of.b << bits), &of.a << bits);
                (fraction(low), fraction(high))
            }
        }
    }
}

enum Common {
    None,
    One(BigRational),
    Both,
}

/// What two polynomials of second degree have in common.
fn common_root(p: &Quadratic, q: &Quadratic) -> Common {
    let first = &q.a * &p.b - &p.a * &q.b;
    let last = &q.a * &p.c - &p.a * &q.c;
    match (first.is_zero(), last.is_zero()) {
        (true, true) => return Common::Both,
        (true, false) => return Common::None,
        _ => {}
    }
    // q.a p - p.a q = 2 first t + last.
    let t = BigRational::new(-last, first * 2);
    let is_root = |of: &Quadratic| of.sign_at(&t) == Ordering::Equal;
    match is_root(p) && is_root(q) {
        true => Common::One(t),
        false => Common::None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn polynomial(a: i64, b: i64, c: i64) -> Quadratic {
        Quadratic {
            a: a.into(),
            b: b.into(),
            c: c.into(),
        }
    }

    fn root(a: i64, b: i64, c: i64, greater: bool) -> Real {
        Real::root(&polynomial(a, b, c), greater)
    }

    fn fraction(n: i64, d: i64) -> BigRational {
        BigRational::new(n.into(), d.into())
    }

    #[test]
    fn equal_numbers_of_different_polynomials_are_equal() {
        // (t - 2)(t - 5), (t - 2)(t + 3), and both times minus three.
        let (one, two) = (polynomial(2, -7, 20), polynomial(2, 1, -12));
        let mut minus = two.clone();
        (minus.a, minus.b, minus.c) = (-&two.a * 3, -&two.b * 3, -&two.c * 3);
        let equal = Real::root(&one, false);
        assert_eq!(equal.compare(&Real::root(&two, true)), Ordering::Equal);
        assert_eq!(equal.compare(&Real::root(&minus, true)), Ordering::Equal);
        assert_eq!(
            Real::root(&one, true).compare(&Real::root(&two, true)),
            Ordering::Greater
        );
        assert_eq!(equal.cmp_fraction(&fraction(2, 1)), Ordering::Equal);
        // sqrt(2) twice, and beside it.
        let irrational = root(1, 0, -2, true);
        assert_eq!(irrational.compare(&root(-3, 0, 6, true)), Ordering::Equal);
        assert_eq!(
            irrational.compare(&root(1, 0, -2, false)),
            Ordering::Greater
        );
        let beside = polynomial(1, 0, -2);
        let beside = Quadratic {
            a: beside.a << 300,
            b: BigInt::zero(),
            c: (beside.c << 300) - 1,
        };
        assert_eq!(
            irrational.compare(&Real::root(&beside, true)),
            Ordering::Less
        );
        // Double roots have no greater one.
        assert_eq!(
            root(1, -3, 9, true).compare(&root(1, -3, 9, false)),
            Ordering::Equal
        );
    }

    proptest! {
        #[test]
        fn order_agrees_with_floats_that_can_tell(p in [-9i64..9, -30..30, -60..60], q in [-9i64..9, -30..30, -60..60], n in -50i64..50, d in 1i64..9, sides: [bool; 2]) {
            // Of the second degree, and with the other sign of c if it has no root.
            let of = |[a, b, c]: [i64; 3]| {
                let a = if a == 0 { 9 } else { a };
                let one = polynomial(a, b, c);
                if one.discriminant().is_negative() { polynomial(a, b, -c) } else { one }
            };
            let (p, q) = (of(p), of(q));
            let float = |r: &Real| {
                let (low, high) = r.between(200);
                assert!(low <= high && r.cmp_fraction(&low) != Ordering::Less && r.cmp_fraction(&high) != Ordering::Greater);
                num_traits::ToPrimitive::to_f64(&low).unwrap()
            };
            let (x, y) = (Real::root(&p, sides[0]), Real::root(&q, sides[1]));
            let (fx, fy, ft) = (float(&x), float(&y), n as f64 / d as f64);
            if (fx - fy).abs() > 1e-9 {
                prop_assert_eq!(x.compare(&y), fx.total_cmp(&fy));
            }
            prop_assert_eq!(x.compare(&y), y.compare(&x).reverse());
            if (fx - ft).abs() > 1e-9 {
                prop_assert_eq!(x.cmp_fraction(&fraction(n, d)), fx.total_cmp(&ft));
            }
        }
    }
}
