//! The numbers `u + v sqrt(q)` of one q: sums, products and signs, exactly.

use num_bigint::BigInt;
use num_traits::{Signed, Zero};
use std::cmp::Ordering;
use std::sync::Arc;

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

    /// A whole number among those of another's q.
    pub fn whole(u: BigInt, like: &Surd) -> Surd {
        Surd {
            u,
            v: BigInt::zero(),
            q: like.q.clone(),
        }
    }

    fn of(&self, u: BigInt, v: BigInt) -> Surd {
        Surd {
            u,
            v,
            q: self.q.clone(),
        }
    }

    /// The sum.
    pub fn plus(&self, other: &Surd) -> Surd {
        self.of(&self.u + &other.u, &self.v + &other.v)
    }

    /// The difference.
    pub fn minus(&self, other: &Surd) -> Surd {
        self.of(&self.u - &other.u, &self.v - &other.v)
    }

    /// The opposite.
    pub fn negated(&self) -> Surd {
        self.of(-&self.u, -&self.v)
    }

    /// The product with a whole number.
    pub fn times(&self, factor: &BigInt) -> Surd {
        self.of(&self.u * factor, &self.v * factor)
    }

    /// The product.
    pub fn product(&self, other: &Surd) -> Surd {
        let roots = if self.v.is_zero() || other.v.is_zero() {
            BigInt::zero()
        } else {
            &self.v * &other.v * &*self.q
        };
        self.of(
            &self.u * &other.u + roots,
            &self.u * &other.v + &self.v * &other.u,
        )
    }

    /// The sign, against zero.
    pub fn sign(&self) -> Ordering {
        debug_assert!(!self.q.is_negative());
        let square = &self.v * &self.v * &*self.q;
        sign_with_root(&self.u, order(&self.v) as i32, &square)
    }
}

/// The sign, against zero.
pub(super) fn order(value: &BigInt) -> Ordering {
    value.cmp(&BigInt::ZERO)
}

/// Sign of `a + s sqrt(b)`, b >= 0.
pub(super) fn sign_with_root(a: &BigInt, s: i32, b: &BigInt) -> Ordering {
    let root = if b.is_zero() { 0 } else { s };
    let rational = order(a);
    match (rational, root) {
        (_, 0) => rational,
        (Ordering::Equal, 1) | (Ordering::Greater, 1) => Ordering::Greater,
        (Ordering::Equal, _) | (Ordering::Less, -1) => Ordering::Less,
        // Opposite signs: the greater square wins.
        (Ordering::Less, _) => b.cmp(&(a * a)),
        (Ordering::Greater, _) => (a * a).cmp(b),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn surd(u: i64, v: i64, q: i64) -> Surd {
        Surd::new(u.into(), v.into(), q.into())
    }

    #[test]
    fn exact_zeros_are_zero() {
        // 3 - sqrt(9), and (1 + sqrt(2)) (1 - sqrt(2)) + 1.
        assert_eq!(surd(3, -1, 9).sign(), Ordering::Equal);
        let product = surd(1, 1, 2).product(&surd(1, -1, 2));
        let sum = product.plus(&Surd::whole(1.into(), &product));
        assert_eq!(sum.sign(), Ordering::Equal);
    }

    proptest! {
        #[test]
        fn signs_agree_with_floats_when_they_can_tell(a in [-30i64..30, -30..30], b in [-30i64..30, -30..30], q in 0i64..50) {
            let float = |[u, v]: [i64; 2]| u as f64 + v as f64 * (q as f64).sqrt();
            let (x, y) = (surd(a[0], a[1], q), surd(b[0], b[1], q));
            let (fx, fy) = (float(a), float(b));
            for (exact, real) in [
                (x.plus(&y), fx + fy),
                (x.minus(&y), fx - fy),
                (x.product(&y), fx * fy),
                (x.negated().times(&BigInt::from(7)), -7.0 * fx),
            ] {
                if real.abs() > 1e-9 {
                    prop_assert_eq!(exact.sign(), real.total_cmp(&0.0));
                }
            }
        }
    }
}
