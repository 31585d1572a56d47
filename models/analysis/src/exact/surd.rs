//! The numbers `u + v sqrt(q)` of one q: sums, products and signs, exactly.

use super::number::Number;
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
        let roots = if self.v.is_zero() || other.v.is_zero() {
            BigInt::ZERO
        } else {
            &self.v * &other.v * &*self.q
        };
        self.with(
            &self.u * &other.u + roots,
            &self.u * &other.v + &self.v * &other.u,
        )
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
