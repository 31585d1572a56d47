//! What the exact reference asks of a number.

use std::cmp::Ordering;

/// A number whose sign is known: always, as that of a [`super::surd::Surd`], or unless it is too near to zero, as that
/// of a [`super::ball::Ball`].
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
