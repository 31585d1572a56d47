//! What is reported of an object.

use super::object::QuadricReport;
use super::parts::PartsReport;
use super::pixels::{Shows, Undecided};
use serde::Serialize;

/// One object of a checked scene.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum ObjectReport {
    /// Of the quadric or the patch processor, with bounds.
    Quadric(Box<QuadricReport>),
    /// Of any other processor.
    Parts(PartsReport),
}

impl ObjectReport {
    /// The report with bounds, if the object has one.
    pub fn quadric(&self) -> Option<&QuadricReport> {
        match self {
            Self::Quadric(report) => Some(report),
            Self::Parts(_) => None,
        }
    }

    /// Name in the scene.
    pub fn name(&self) -> &str {
        match self {
            Self::Quadric(report) => &report.name,
            Self::Parts(report) => &report.name,
        }
    }

    /// Whether any pixel of the golden picture shows it.
    pub fn shows(&self) -> Shows {
        match self {
            Self::Quadric(report) => report.shows,
            Self::Parts(report) => report.shows,
        }
    }

    /// Greatest depth error, in depth words.
    pub fn depth_lsb(&self) -> f64 {
        match self {
            Self::Quadric(report) => report.bounds.depth_lsb,
            Self::Parts(report) => report.bounds.depth_lsb,
        }
    }

    /// Pixels that rounding could change.
    pub fn undecided(&self) -> Undecided {
        match self {
            Self::Quadric(report) => report.undecided,
            Self::Parts(report) => report.undecided,
        }
    }

    /// What a person should know.
    pub fn problems(&self) -> &[String] {
        match self {
            Self::Quadric(report) => &report.problems,
            Self::Parts(report) => &report.problems,
        }
    }

    /// Whether its material mirrors light.
    pub fn highlights(&self) -> bool {
        match self {
            Self::Quadric(report) => report.highlights,
            Self::Parts(report) => report.highlights,
        }
    }
}
