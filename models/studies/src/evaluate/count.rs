//! A number that counts what is done with it, so that the cost of an algorithm is found by running it.
//!
//! The weights are the source's (Nyiri, 5.1.2): an addition, subtraction, multiplication or test is 1, a division or
//! root 8. The source does not say what a conversion to a whole number weighs; here it is 1. A change of sign is free:
//! it goes into the addition or subtraction that follows. Assignments are free.

use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Weight of a division or a root (Nyiri, 5.1.2).
pub const LONG: u64 = 8;

/// Operations that were done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Additions and subtractions.
    pub additions: u64,
    pub multiplications: u64,
    pub divisions: u64,
    pub roots: u64,
    /// Comparisons.
    pub tests: u64,
    /// Conversions to whole numbers.
    pub roundings: u64,
}

impl Tally {
    /// The sum with the source's weights.
    pub fn weighted(&self) -> u64 {
        let short = self.additions + self.multiplications + self.tests + self.roundings;
        short + LONG * (self.divisions + self.roots)
    }
}

/// Keeps the tally of the numbers made by it.
#[derive(Debug, Default)]
pub struct Counter(Cell<Tally>);

impl Counter {
    /// A number that is given: making it costs nothing.
    pub fn number(&self, value: f64) -> Counted<'_> {
        Counted {
            value,
            counter: self,
        }
    }

    /// Several of them.
    pub fn numbers<const N: usize>(&self, values: [f64; N]) -> [Counted<'_>; N] {
        values.map(|value| self.number(value))
    }

    /// What was done so far.
    pub fn tally(&self) -> Tally {
        self.0.get()
    }

    fn note(&self, kind: fn(&mut Tally) -> &mut u64) {
        let mut tally = self.0.get();
        *kind(&mut tally) += 1;
        self.0.set(tally);
    }
}

/// What a piece of work costs.
pub fn cost(work: impl FnOnce(&Counter)) -> Tally {
    let counter = Counter::default();
    work(&counter);
    counter.tally()
}

/// A number whose operations are counted.
#[derive(Clone, Copy, Debug)]
pub struct Counted<'c> {
    pub value: f64,
    counter: &'c Counter,
}

impl<'c> Counted<'c> {
    /// A constant beside this number: free.
    pub fn constant(self, value: f64) -> Counted<'c> {
        self.counter.number(value)
    }

    /// Twice the number, by an addition.
    pub fn doubled(self) -> Counted<'c> {
        self + self
    }

    /// A number that is the result of an operation.
    fn counted(self, kind: fn(&mut Tally) -> &mut u64, value: f64) -> Counted<'c> {
        self.counter.note(kind);
        self.constant(value)
    }

    /// Its square root.
    pub fn root(self) -> Counted<'c> {
        self.counted(|tally| &mut tally.roots, self.value.sqrt())
    }

    /// One over it.
    pub fn reciprocal(self) -> Counted<'c> {
        self.constant(1.0) / self
    }

    /// Is it less than another?
    pub fn is_below(self, other: Counted<'c>) -> bool {
        self.counter.note(|tally| &mut tally.tests);
        self.value < other.value
    }

    /// Is it less than zero?
    pub fn is_negative(self) -> bool {
        self.is_below(self.constant(0.0))
    }
    pub fn is_zero(self) -> bool {
        self.counter.note(|tally| &mut tally.tests);
        self.value == 0.0
    }

    /// Its size: a test of its sign.
    pub fn size(self) -> Counted<'c> {
        if self.is_negative() { -self } else { self }
    }

    /// The greater of two.
    pub fn or_greater(self, other: Counted<'c>) -> Counted<'c> {
        if self.is_below(other) { other } else { self }
    }

    /// The smaller of two.
    pub fn or_smaller(self, other: Counted<'c>) -> Counted<'c> {
        if self.is_below(other) { self } else { other }
    }

    /// The nearest whole number.
    pub fn rounded(self) -> Counted<'c> {
        self.counted(|tally| &mut tally.roundings, self.value.round())
    }

    /// The whole number at or below it.
    pub fn floor(self) -> Counted<'c> {
        self.counted(|tally| &mut tally.roundings, self.value.floor())
    }

    /// Times a scale, rounded.
    pub fn scaled(self, scale: Counted<'c>) -> Counted<'c> {
        (self * scale).rounded()
    }
}

/// An operation between two numbers, counted among those of a kind.
macro_rules! operation {
    ($operator:ident, $name:ident, $kind:ident) => {
        impl $operator for Counted<'_> {
            type Output = Self;
            fn $name(self, other: Self) -> Self {
                self.counted(|tally| &mut tally.$kind, self.value.$name(other.value))
            }
        }

        // By reference, as the algebra of this project multiplies and subtracts.
        impl<'c> $operator for &Counted<'c> {
            type Output = Counted<'c>;
            fn $name(self, other: Self) -> Counted<'c> {
                (*self).$name(*other)
            }
        }
    };
}

operation!(Add, add, additions);
operation!(Sub, sub, additions);
operation!(Mul, mul, multiplications);
operation!(Div, div, divisions);

impl Neg for Counted<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        self.constant(-self.value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use imogene_algebra::vector::dot;

    #[test]
    fn every_operation_is_counted_once() {
        let tally = cost(|counter| {
            let [a, b] = counter.numbers([3.0, 4.0]);
            let c = (a * a + b * b).root();
            assert_eq!(c.value, 5.0);
            assert_eq!((-(a - b) / c).value, 0.2);
            assert!(a.is_below(b) && !b.is_negative() && !a.is_zero());
            assert_eq!(a.or_greater(b).value, 4.0);
            assert_eq!(a.constant(2.5).scaled(b).value, 10.0);
            assert_eq!(a.constant(-2.5).floor().value, -3.0);
            assert_eq!(a.doubled().value, 6.0);
            assert_eq!(b.reciprocal().value, 0.25);
        });
        let expected = Tally {
            additions: 3,
            multiplications: 3,
            divisions: 2,
            roots: 1,
            tests: 4,
            roundings: 2,
        };
        assert_eq!(tally, expected);
        assert_eq!(tally.weighted(), 12 + 24);
    }

    #[test]
    fn a_product_of_lists_has_one_addition_less() {
        let tally = cost(|counter| {
            let list = counter.numbers([1.0, 2.0, 3.0, 4.0]);
            assert_eq!(dot(list, list).value, 30.0);
        });
        assert_eq!((tally.multiplications, tally.additions), (4, 3));
    }
}
