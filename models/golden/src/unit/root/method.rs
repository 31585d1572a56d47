//! The family by its members.

use super::exact::{Root, leading_root, non_restoring_root, restoring_root, rows_root};
use super::iterative::iterative_root;
use super::polynomial::{corrected, linear_estimate, quadratic_estimate};
use imogene_contract::RootForm;
use serde::Serialize;
use std::fmt;

/// A member of the family.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case", tag = "name")]
pub enum Method {
    /// Digit recurrence that keeps the old remainder where a trial is negative.
    Restoring,
    /// Digit recurrence that adds back in the next row.
    NonRestoring,
    /// One row, used once for each digit.
    Iterative,
    /// Two straight lines per pair of octaves, joined.
    Linear {
        /// Correction steps behind the estimate.
        corrections: u32,
    },
    /// One parabola per pair of octaves, joined.
    Quadratic {
        /// Correction steps behind the estimate.
        corrections: u32,
    },
    /// The first rows of the fixed network; the lower digits are zero.
    Rows {
        /// Rows built.
        kept: u32,
    },
    /// The leading significant digits of the exact root; the lower ones are zero.
    Leading {
        /// Digits kept.
        kept: u32,
    },
}

impl Method {
    /// The member that a form of an object processor is.
    pub const fn of(form: RootForm) -> Method {
        match form {
            RootForm::Restoring => Method::Restoring,
            RootForm::NonRestoring => Method::NonRestoring,
            RootForm::Iterative => Method::Iterative,
            RootForm::Linear(corrections) => Method::Linear { corrections },
            RootForm::Quadratic(corrections) => Method::Quadratic { corrections },
            RootForm::Leading(kept) => Method::Leading { kept },
        }
    }

    /// The unit's name, as in the catalogue of the hardware.
    pub const fn name(self) -> &'static str {
        match self {
            Method::Restoring => "square_root",
            Method::NonRestoring => "square_root_non_restoring",
            Method::Iterative => "square_root_iterative",
            Method::Linear { .. } => "square_root_linear",
            Method::Quadratic { .. } => "square_root_quadratic",
            Method::Rows { .. } => "square_root_rows",
            Method::Leading { .. } => "square_root_leading",
        }
    }

    /// True where root and remainder are those of the definition.
    pub const fn is_exact(self) -> bool {
        matches!(
            self,
            Method::Restoring | Method::NonRestoring | Method::Iterative
        )
    }

    /// Clocks from the radicand to the root (`docs/root-network.md`), at `rows_per_stage` rows between registers.
    pub const fn latency(self, root_bits: u32, rows_per_stage: u32) -> u32 {
        match self {
            Method::Restoring | Method::NonRestoring => root_bits.div_ceil(rows_per_stage),
            Method::Iterative => root_bits,
            Method::Rows { kept } => kept.div_ceil(rows_per_stage),
            Method::Leading { kept } => (kept - 1).div_ceil(rows_per_stage) + 2,
            Method::Linear { corrections } => 1 + 2 * corrections,
            Method::Quadratic { corrections } => 3 + 2 * corrections,
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Method::Restoring => f.write_str("restoring"),
            Method::NonRestoring => f.write_str("non-restoring"),
            Method::Iterative => f.write_str("iterative"),
            Method::Linear { corrections } => write!(f, "linear + {corrections}"),
            Method::Quadratic { corrections } => write!(f, "quadratic + {corrections}"),
            Method::Rows { kept } => write!(f, "first {kept} rows"),
            Method::Leading { kept } => write!(f, "{kept} leading digits"),
        }
    }
}

/// What a member answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RootResult {
    /// The root, or its approximation; `2^K` at most, which only a corrected approximation reaches.
    pub root: u64,
    /// radicand - root^2, from the exact members.
    pub remainder: Option<u64>,
}

/// The golden answer of a member to a radicand of `2 root_bits` bits; `root_bits` is 1 to 32.
pub fn root(method: Method, radicand: u128, root_bits: u32) -> RootResult {
    let exact = |Root { root, remainder }| (root, Some(remainder));
    let near = |estimate, corrections| (corrected(radicand, estimate, corrections), None);
    let (root, remainder) = match method {
        Method::Restoring => exact(restoring_root(radicand, root_bits)),
        Method::NonRestoring => exact(non_restoring_root(radicand, root_bits)),
        Method::Iterative => exact(iterative_root(radicand, root_bits)),
        Method::Rows { kept } => (rows_root(radicand, root_bits, kept), None),
        Method::Leading { kept } => (leading_root(radicand, root_bits, kept), None),
        Method::Linear { corrections } => near(linear_estimate(radicand), corrections),
        Method::Quadratic { corrections } => near(quadratic_estimate(radicand), corrections),
    };
    RootResult { root, remainder }
}
