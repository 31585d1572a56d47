//! Formats that no machine has.

use imogene_contract::words::{LEAST_DEPTH, MOST_DEPTH, MOST_GUARD};
use thiserror::Error;

/// Widths that no machine can have.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum FittedError {
    /// One of them is out of its range.
    #[error("{word} of {value} bits: accepted are {least} to {most}")]
    Range {
        /// Which word.
        word: &'static str,
        /// Bits asked for.
        value: u32,
        /// Fewest.
        least: u32,
        /// Most.
        most: u32,
    },
    /// The guard bits.
    #[error(transparent)]
    Guards(#[from] GuardError),
}

/// A depth word that no machine has.
#[derive(Debug, Error, PartialEq, Eq)]
#[error("depth word of {0} bits: accepted are {LEAST_DEPTH} to {MOST_DEPTH}")]
pub struct FormatError(pub u32);

/// Guard bits that a format cannot have.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum GuardError {
    /// More than 16.
    #[error("guard bits {linear}:{quadratic}: at most {MOST_GUARD} each are accepted")]
    TooMany {
        /// Of f1.
        linear: u32,
        /// Of f2.
        quadratic: u32,
    },
    /// The second-degree processor would be wider than 64 bits.
    #[error(
        "{quadratic} guard bits of f2 make its processor {width} bits wide, more than 64; \
         a depth word of {depth} bits accepts at most {most}"
    )]
    TooWide {
        /// Depth word of the format.
        depth: u32,
        /// Of f2.
        quadratic: u32,
        /// Width that the processor would have.
        width: u32,
        /// The most that is accepted.
        most: u32,
    },
}
