//! How far a computed depth can be from the true one, and between which values the true one lies.
//!
//! Let q1 and q2 be the values of the two elementary processors with their guard bits, `|q1 - f1| <= e1` and `|q2 - f2|
//! <= e2` on the screen box by the rounding of the coefficients, and `f1' = floor(q1)`, `f2' = floor(q2)`, `r =
//! floor(sqrt(f2'))`. The error of a depth is a sum of four terms:
//!
//! ```text
//! (f1' -+ r) - (f1 -+ sqrt(f2)) = (q1 - f1)                   f1 coefficients   within e1
//!                               + (f1' - q1)                  truncation        in -(1 - 2^-g1) .. 0
//!                               -+ (sqrt(q2) - sqrt(f2))      f2 coefficients, through the root
//!                               -+ (r - sqrt(q2))             floor of the root in (-1, 0]
//! ```
//!
//! Dropping the guard bits of f2 costs nothing of its own: `floor(sqrt(floor(q))) = floor(sqrt(q))` for every real q
//! that is not negative, because a root is at least n if and only if its radicand is at least the integer n^2. Nor does
//! it matter that f1 drops its guard bits before r is added: r is an integer.
//!
//! A root network without its last d rows gives `r = 2^d floor(floor(sqrt(f2')) / 2^d)`, and the last term lies in
//! `(-2^d, 0]`. Of an approximate root it lies within [`RoundingBounds::root_error`] on both sides.
//!
//! [`DepthTerms`] bounds each term from f2' alone; [`face_bound`] is sharper than their sum, because r is known from
//! f2': `sqrt(f2)` lies between `sqrt(max(0, f2' - e2))` and `sqrt(f2' + (1 - 2^-g2) + e2)`, and the farther of these
//! from r counts.

use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR, FACE_NEAR_END, FACE_PLANE};
use imogene_prepare::{PreparedQuadric, RoundingBounds};
use serde::Serialize;

/// Relative allowance for the rounding of a square root and the additions around it in `f64`.
const FLOAT_MARGIN: f64 = 8.0 * f64::EPSILON;

/// Between which two values a true number lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// It is not below this.
    pub low: f64,
    /// Nor above this.
    pub high: f64,
}

impl Range {
    /// From one value to another.
    pub const fn new(low: f64, high: f64) -> Range {
        Range { low, high }
    }

    /// The values within `error` of a computed integer.
    pub fn around(value: i64, error: f64) -> Range {
        Range::new(value as f64 - error, value as f64 + error)
    }

    /// The values within `error` of a number of which up to `dropped` was dropped to give this integer.
    pub fn of_dropped(value: i64, error: f64, dropped: f64) -> Range {
        Range::new(value as f64 - error, value as f64 + dropped + error)
    }

    /// Certainly smaller.
    pub fn below(&self, other: &Range) -> bool {
        self.high < other.low
    }

    /// Certainly smaller or equal.
    pub fn not_above(&self, other: &Range) -> bool {
        self.high <= other.low
    }

    /// Whether the one is smaller than the other, where that is certain.
    pub fn is_before(&self, other: &Range) -> Option<bool> {
        certain(self.below(other), other.below(self))
    }

    /// Whether the number is not negative, where that is certain.
    pub fn not_negative(&self) -> Option<bool> {
        certain(self.low >= 0.0, self.high < 0.0)
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

/// What is known of a statement that is certainly true, certainly false, or neither.
pub(super) fn certain(is: bool, is_not: bool) -> Option<bool> {
    (is || is_not).then_some(is)
}

pub(super) fn both(one: Option<bool>, other: Option<bool>) -> Option<bool> {
    let known = [one, other];
    certain(known == [Some(true); 2], known.contains(&Some(false)))
}

/// Where `sqrt(f2)` lies if the computed value is `f2`; a negative true f2 counts as zero.
pub(super) fn root_range(f2: i64, bounds: &RoundingBounds) -> Range {
    let low = (f2 as f64 - bounds.f2).max(0.0).sqrt();
    let high = (f2 as f64 + bounds.dropped_f2 + bounds.f2).max(0.0).sqrt();
    Range::new(low * (1.0 - FLOAT_MARGIN), high * (1.0 + FLOAT_MARGIN))
}

/// Greatest distance of the integer root of a computed `f2` from the true root, in depth words.
pub fn root_error(f2: i64, bounds: &RoundingBounds) -> f64 {
    let root = bounds.root_of(f2) as f64;
    let range = root_range(f2, bounds);
    (range.high - root).max(root - range.low)
}

/// The ranges of the two roots `f1 -+ sqrt(f2)`; the computed roots lie in them too.
pub(super) fn face_ranges(f1: i64, f2: i64, bounds: &RoundingBounds) -> (Range, Range) {
    let (root, computed) = (root_range(f2, bounds), bounds.root_of(f2) as f64);
    let (low, high) = (root.low.min(computed), root.high.max(computed));
    let f1 = Range::of_dropped(f1, bounds.f1, bounds.dropped_f1);
    let near = Range::new(f1.low - high, f1.high - low);
    (near, Range::new(f1.low + low, f1.high + high))
}

/// Greatest magnitude of each term of a depth error, in depth words, at a pixel with a given f2.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct DepthTerms {
    /// Rounding of the coefficients of f1.
    pub linear: f64,
    /// Guard bits of f1 that are dropped.
    pub truncation: f64,
    /// Rounding of the coefficients of f2, through the root.
    pub quadratic: f64,
    /// Floor of the root, or what an approximate root is off: at most this, and less unless it is zero.
    pub root_floor: f64,
}

impl DepthTerms {
    /// The sum of the terms.
    pub fn sum(&self) -> f64 {
        self.linear + self.truncation + self.quadratic + self.root_floor
    }
}

/// Bounds of the terms where the f2 processor hands on `f2`, not negative.
///
/// With q between f2 and `f2 + (1 - 2^-g2)`: below the root `sqrt(q) - sqrt(q - e2)` falls with q, and is `sqrt(q)`
/// where q < e2; above it `sqrt(q + e2) - sqrt(q)` falls with q.
pub fn depth_terms(bounds: &RoundingBounds, f2: i64) -> DepthTerms {
    let (low, high) = (f2 as f64, f2 as f64 + bounds.dropped_f2);
    let error = bounds.f2;
    let below = if low >= error {
        difference_of_roots(low, error)
    } else {
        high.min(error).sqrt()
    };
    let above = difference_of_roots(low + error, error);
    DepthTerms {
        linear: bounds.f1,
        truncation: bounds.dropped_f1,
        quadratic: below.max(above) * (1.0 + FLOAT_MARGIN),
        root_floor: bounds.root_error(high.sqrt()),
    }
}

/// `sqrt(high) - sqrt(high - step)` without cancellation.
fn difference_of_roots(high: f64, step: f64) -> f64 {
    if step == 0.0 {
        return 0.0;
    }
    // The difference under the second root is taken a little too small, which makes the quotient a little too great.
    let low = (high - step - high * FLOAT_MARGIN).max(0.0);
    step / (high.sqrt() + low.sqrt())
}

/// Greatest distance, in depth words, of the golden depth of face `number` from the true depth of that face, at a pixel
/// of the object's screen box where the f2 processor hands on `f2` (of no meaning for a plane or the near end).
pub fn depth_bound(object: &PreparedQuadric, number: u8, f2: i64) -> f64 {
    face_bound(&object.bounds, number, f2)
}

/// The same of the rounding bounds alone.
pub fn face_bound(bounds: &RoundingBounds, number: u8, f2: i64) -> f64 {
    let root = bounds.root_of(f2) as f64;
    let range = root_range(f2, bounds);
    let (above, below) = (range.high - root, root - range.low);
    let dropped = bounds.dropped_f1;
    // Truncation and floor of the root have opposite signs on the near face and the same on the far one.
    let rooted = match number {
        FACE_NEAR => above.max(below + dropped),
        FACE_FAR => below.max(above + dropped),
        FACE_NEAR_END => return 0.0,
        _ => return bounds.planes[usize::from(number - FACE_PLANE)],
    };
    (bounds.f1 + rooted) * (1.0 + FLOAT_MARGIN)
}

/// The terms at any pixel of the screen box, in closed form: `sqrt(q2 + e2) - sqrt(q2)` is greatest at q2 = 0, and
/// `sqrt(q2) - sqrt(q2 - e2)` at q2 = e2; both are then sqrt(e2).
pub(super) fn worst_terms(bounds: &RoundingBounds) -> DepthTerms {
    DepthTerms {
        linear: bounds.f1,
        truncation: bounds.dropped_f1,
        quadratic: bounds.f2.sqrt() * (1.0 + FLOAT_MARGIN),
        root_floor: bounds.root_error(bounds.greatest_root),
    }
}

/// The worst depth bound at any pixel, in closed form: the sum of the terms, or the bound of a plane.
pub fn worst_case(bounds: &RoundingBounds) -> f64 {
    let root = worst_terms(bounds).sum() * (1.0 + FLOAT_MARGIN);
    bounds.planes.iter().copied().fold(root, f64::max)
}
