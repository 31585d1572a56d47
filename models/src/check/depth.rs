//! How far a computed depth can be from the true one, and between which values the true one lies.
//!
//! The computed words satisfy `|f1' - f1| <= e1`, `|f2' - f2| <= e2`, `|zp' - zp| <= ep` on the screen box, by the rounding of the coefficients.
//! Hence at a pixel where both f2 and f2' are not negative, `sqrt(f2)` lies between `sqrt(max(0, f2' - e2))` and
//! `sqrt(f2' + e2)`, and the depth `f1 -+ sqrt(f2)` differs from `f1' -+ floor(sqrt(f2'))` by at most e1 plus the distance of
//! `floor(sqrt(f2'))` from the farther of these two: the floor of the root is included.

use crate::prepare::{PreparedObject, RoundingBounds};
use crate::unit::interval::{FACE_FAR, FACE_NEAR, FACE_NEAR_END, FACE_PLANE};
use crate::unit::root::fast_root;

/// Relative allowance for the rounding of a square root and the additions around it in `f64`.
const FLOAT_MARGIN: f64 = 8.0 * f64::EPSILON;

/// Between which two values a true number lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Range {
    pub low: f64,
    pub high: f64,
}

impl Range {
    pub const fn new(low: f64, high: f64) -> Range {
        Range { low, high }
    }

    /// The values within `error` of a computed integer.
    pub fn around(value: i64, error: f64) -> Range {
        Range::new(value as f64 - error, value as f64 + error)
    }

    /// Certainly smaller.
    pub fn below(&self, other: &Range) -> bool {
        self.high < other.low
    }

    /// Certainly smaller or equal.
    pub fn not_above(&self, other: &Range) -> bool {
        self.high <= other.low
    }

    /// The range of the greater of two numbers.
    pub fn max(&self, other: &Range) -> Range {
        Range::new(self.low.max(other.low), self.high.max(other.high))
    }

    /// The range of the smaller of two numbers.
    pub fn min(&self, other: &Range) -> Range {
        Range::new(self.low.min(other.low), self.high.min(other.high))
    }
}

/// Where `sqrt(f2)` lies if the computed value is `f2` with the rounding bound `e2`; a negative f2 counts as zero.
pub(super) fn root_range(f2: i64, e2: f64) -> Range {
    let low = (f2 as f64 - e2).max(0.0).sqrt();
    let high = (f2 as f64 + e2).max(0.0).sqrt();
    Range::new(low * (1.0 - FLOAT_MARGIN), high * (1.0 + FLOAT_MARGIN))
}

/// Greatest distance of the integer root of a computed `f2` from the true root.
pub(super) fn root_error(f2: i64, e2: f64) -> f64 {
    let root = fast_root(f2.max(0)) as f64;
    let range = root_range(f2, e2);
    (range.high - root).max(root - range.low)
}

/// The ranges of the two roots `f1 -+ sqrt(f2)`; the computed roots, with their floor, lie in them too.
pub(super) fn face_ranges(f1: i64, f2: i64, bounds: &RoundingBounds) -> (Range, Range) {
    let root = root_range(f2, bounds.f2);
    let lowest = root.low.min(fast_root(f2.max(0)) as f64);
    let f1 = Range::around(f1, bounds.f1);
    (
        Range::new(f1.low - root.high, f1.high - lowest),
        Range::new(f1.low + lowest, f1.high + root.high),
    )
}

/// Greatest distance, in depth words, of the golden depth of face `number` from the true depth of that face, at a pixel of the object's
/// screen box where the f2 accumulator holds `f2` (of no meaning for a plane or the near end).
pub fn depth_bound(object: &PreparedObject, number: u8, f2: i64) -> f64 {
    face_bound(&object.bounds, number, f2)
}

pub(super) fn face_bound(bounds: &RoundingBounds, number: u8, f2: i64) -> f64 {
    match number {
        FACE_NEAR | FACE_FAR => bounds.f1 + root_error(f2, bounds.f2),
        FACE_NEAR_END => 0.0,
        _ => bounds.planes[usize::from(number - FACE_PLANE)],
    }
}

/// The worst depth bound at any pixel, in closed form: `sqrt(f2' + e2) - sqrt(f2')` is greatest at f2' = 0, and
/// `sqrt(f2') - sqrt(f2' - e2)` at f2' = e2; both are then sqrt(e2). The floor of the root adds one.
pub(super) fn worst_case(bounds: &RoundingBounds) -> f64 {
    let root = bounds.f1 + bounds.f2.sqrt() + 1.0;
    bounds.planes.iter().copied().fold(root, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// The claim of the module: for a true f2 anywhere within the bound, the integer root is within `root_error`.
        #[test]
        fn root_error_covers_every_true_radicand(f2 in 0i64..1 << 47, e2 in 0.0f64..1e6, part in -1.0f64..=1.0) {
            let truth = f2 as f64 + part * e2;
            prop_assume!(truth >= 0.0);
            let off = (fast_root(f2) as f64 - truth.sqrt()).abs();
            prop_assert!(off <= root_error(f2, e2) + 1e-6);
        }
    }

    #[test]
    fn an_exact_radicand_leaves_only_the_floor() {
        assert!(root_error(16, 0.0) < 1e-9);
        assert!(root_error(24, 0.0) < 0.9);
        assert!(root_error(0, 100.0) >= 10.0);
    }
}
