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
    /// Multiplications.
    pub multiplications: u64,
    /// Divisions.
    pub divisions: u64,
    /// Square roots.
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

thread_local! {
    static DONE: Cell<Tally> = Cell::default();
}

/// What a piece of work costs.
pub fn cost(work: impl FnOnce()) -> Tally {
    let before = DONE.take();
    work();
    DONE.replace(before)
}

/// A number whose operations are counted.
#[derive(Clone, Copy, Debug)]
pub struct Counted {
    /// The number itself.
    pub value: f64,
}

/// A number that is given: making it costs nothing.
pub const fn number(value: f64) -> Counted {
    Counted { value }
}

/// Several of them.
pub fn numbers<const N: usize>(values: [f64; N]) -> [Counted; N] {
    values.map(number)
}

fn note(kind: fn(&mut Tally) -> &mut u64) {
    let mut tally = DONE.get();
    *kind(&mut tally) += 1;
    DONE.set(tally);
}

fn counted(kind: fn(&mut Tally) -> &mut u64, value: f64) -> Counted {
    note(kind);
    number(value)
}

impl Counted {
    /// Twice the number, by an addition.
    pub fn doubled(self) -> Counted {
        self + self
    }

    /// Its square root.
    pub fn root(self) -> Counted {
        counted(|tally| &mut tally.roots, self.value.sqrt())
    }

    /// One over it.
    pub fn reciprocal(self) -> Counted {
        number(1.0) / self
    }

    /// Is it less than another?
    pub fn is_below(self, other: Counted) -> bool {
        note(|tally| &mut tally.tests);
        self.value < other.value
    }

    /// Is it less than zero?
    pub fn is_negative(self) -> bool {
        self.is_below(number(0.0))
    }

    /// Is it zero?
    pub fn is_zero(self) -> bool {
        note(|tally| &mut tally.tests);
        self.value == 0.0
    }

    /// Its size: a test of its sign.
    pub fn size(self) -> Counted {
        if self.is_negative() { -self } else { self }
    }

    /// The greater of two.
    pub fn or_greater(self, other: Counted) -> Counted {
        if self.is_below(other) { other } else { self }
    }

    /// The smaller of two.
    pub fn or_smaller(self, other: Counted) -> Counted {
        if self.is_below(other) { self } else { other }
    }

    /// The nearest whole number.
    pub fn rounded(self) -> Counted {
        counted(|tally| &mut tally.roundings, self.value.round())
    }

    /// The whole number at or below it.
    pub fn floor(self) -> Counted {
        counted(|tally| &mut tally.roundings, self.value.floor())
    }

    /// Times a scale, rounded.
    pub fn scaled(self, scale: Counted) -> Counted {
        (self * scale).rounded()
    }
}

macro_rules! operation {
    ($operator:ident, $name:ident, $kind:ident) => {
        impl $operator for Counted {
            type Output = Counted;
            fn $name(self, other: Counted) -> Counted {
                counted(|tally| &mut tally.$kind, self.value.$name(other.value))
            }
        }

        // By reference, as the algebra of this project multiplies and subtracts.
        impl $operator for &Counted {
            type Output = Counted;
            fn $name(self, other: Self) -> Counted {
                (*self).$name(*other)
            }
        }
    };
}

operation!(Add, add, additions);
operation!(Sub, sub, additions);
operation!(Mul, mul, multiplications);
operation!(Div, div, divisions);

impl Neg for Counted {
    type Output = Counted;
    fn neg(self) -> Counted {
        number(-self.value)
    }
}
