//! What the trial counts: every comparison of an error with its bound, decided exactly.

use serde::Serialize;

/// An error below this part of its bound is within it whatever the rounding of the few operations in `f64` that
/// computed both (each of them relative to the term it makes); above it the comparison is made in exact integers.
const CLEARLY_WITHIN: f64 = 1.0 - 1e-9;
const KEPT: usize = 8;

/// The terms whose bounds are tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Term {
    /// Coefficient rounding of f1, in depth words.
    Linear,
    /// Coefficient rounding of f2, in its last bit.
    QuadraticValue,
    /// Coefficient rounding of f2 through the root, in depth words.
    QuadraticRoot,
    /// Floor of the root, in depth words.
    RootFloor,
    /// Dropped guard bits of f1, in depth words.
    Truncation,
    /// The whole depth error of a near or far face, in depth words.
    Depth,
    /// The same against the bound without a pixel's f2.
    DepthClosedForm,
    /// Displacement of the silhouette, in pixels.
    Silhouette,
    /// Sine of the angle of a normal.
    Normal,
    /// Residual bound of f1 against the bound before the coefficients are known.
    LinearBeforehand,
    /// Residual bound of f2 against the bound before the coefficients are known.
    QuadraticBeforehand,
}

impl Term {
    /// Every term in the order of reports, and what is bounded, for a person.
    pub const ALL: [(Term, &str); 11] = [
        (Term::Linear, "f1 coefficients"),
        (Term::QuadraticValue, "f2 coefficients"),
        (Term::QuadraticRoot, "f2 through the root"),
        (Term::RootFloor, "floor of the root"),
        (Term::Truncation, "dropped guards"),
        (Term::Depth, "depth"),
        (Term::DepthClosedForm, "depth, closed form"),
        (Term::Silhouette, "silhouette"),
        (Term::Normal, "normal"),
        (Term::LinearBeforehand, "f1, beforehand"),
        (Term::QuadraticBeforehand, "f2, beforehand"),
    ];

    /// What is bounded, for a person.
    pub const fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

/// An error beyond its bound.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Violation {
    /// Which bound.
    pub term: Term,
    /// Number of the case, which with the seed makes it again.
    pub case: u64,
    /// Pixel.
    pub pixel: (i64, i64),
    /// What was observed.
    pub observed: f64,
    /// What was stated.
    pub bound: f64,
}

/// How a bound fared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Fared {
    /// Comparisons made.
    pub comparisons: u64,
    /// Greatest ratio of an error to its bound.
    pub tightness: f64,
    /// Mean ratio of an error to its bound, where the bound is not zero; while it is counted, their sum.
    pub mean: f64,
    /// The error where that was.
    pub observed: f64,
    /// The bound where that was.
    pub bound: f64,
    #[serde(skip)]
    bounded: u64,
}

impl Fared {
    fn add(&mut self, observed: f64, bound: f64) {
        self.comparisons += 1;
        if bound == 0.0 {
            return;
        }
        let ratio = observed / bound;
        self.bounded += 1;
        self.mean += ratio;
        if ratio > self.tightness {
            (self.tightness, self.observed, self.bound) = (ratio, observed, bound);
        }
    }

    fn merged(self, other: Fared) -> Fared {
        let is_tighter = other.tightness > self.tightness;
        Fared {
            comparisons: self.comparisons + other.comparisons,
            bounded: self.bounded + other.bounded,
            mean: self.mean + other.mean,
            ..if is_tighter { other } else { self }
        }
    }
}

/// The count of one run, or part of one.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Tally {
    /// Compare everything in exact integers.
    #[serde(skip)]
    pub always_exactly: bool,
    /// The case at hand.
    #[serde(skip)]
    pub case: u64,
    /// Pixels tried.
    pub pixels: u64,
    /// Comparisons of an error with its bound.
    pub comparisons: u64,
    /// Those that were too close for `f64` and made in exact integers.
    pub decided_exactly: u64,
    /// Pixels at which the computed sign of f2 is not the true one, which the displacement of the silhouette allows.
    pub sign_differences: u64,
    /// Normals whose direction the words do not determine, which have no bound.
    pub normals_undetermined: u64,
    /// Errors beyond their bounds.
    pub violations: u64,
    /// The first of them.
    pub first_violations: Vec<Violation>,
    /// How each bound fares.
    #[serde(skip)]
    pub counts: [Fared; Term::ALL.len()],
}

impl Tally {
    /// Compares an error with its bound; `exactly` does so in integers, asked whenever `f64` cannot tell.
    pub fn compare(
        &mut self,
        term: Term,
        pixel: (i64, i64),
        (observed, bound): (f64, f64),
        exactly: impl FnOnce() -> bool,
    ) {
        self.comparisons += 1;
        self.counts[term as usize].add(observed, bound);
        if observed < bound * CLEARLY_WITHIN && !self.always_exactly {
            return;
        }
        self.decided_exactly += 1;
        if exactly() {
            return;
        }
        self.violations += 1;
        if self.first_violations.len() < KEPT {
            self.first_violations.push(Violation {
                term,
                case: self.case,
                pixel,
                observed,
                bound,
            });
        }
    }

    /// How a term's bound fared.
    pub fn fared(&self, term: Term) -> Fared {
        let count = self.counts[term as usize];
        Fared {
            mean: count.mean / count.bounded.max(1) as f64,
            ..count
        }
    }

    /// The count of both.
    pub fn merged(mut self, other: Tally) -> Tally {
        self.pixels += other.pixels;
        self.comparisons += other.comparisons;
        self.decided_exactly += other.decided_exactly;
        self.violations += other.violations;
        self.first_violations.extend(other.first_violations);
        self.first_violations.sort_by_key(|v| v.case);
        self.first_violations.truncate(KEPT);
        self.sign_differences += other.sign_differences;
        self.normals_undetermined += other.normals_undetermined;
        for (mine, others) in self.counts.iter_mut().zip(other.counts) {
            *mine = mine.merged(others);
        }
        self
    }
}
