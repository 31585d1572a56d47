//! Sweeps: families of scenes in which one number goes to its extreme, each step measured against the exact picture.
//!
//! A sweep is a list of scenes built in memory from exact decimals. Every step is prepared, or refused with the message
//! that a user would see; what is drawn by the golden model is compared at every pixel with the exact reference, and
//! the error stands beside the bound that was proven before a pixel was drawn. Three rules hold at every step, or the
//! sweep fails: no error exceeds its bound; every pixel that shows another face than the truth was announced as
//! undecided; and where the format gives out the scene is refused.

mod family;
pub mod grid;
pub mod measure;
mod naive;
mod plot;
mod record;
mod shapes;
pub mod truth;
mod views;

pub use family::Sweep;
pub use measure::{Bounds, Figures, Observed, Ratios};
pub use plot::plot;
pub use record::{Axis, GivesOut, Notice, Record, SweepResult, section};
use thiserror::Error;

/// Every sweep, in the order of the documentation.
pub const ALL: &[Sweep] = &[
    views::CYLINDER_AXIS,
    views::EYE_DISTANCE,
    shapes::STEEP_PLANE,
    shapes::SPHERE_RADIUS,
    views::WORLD_OFFSET,
    views::SIDE_OFFSET,
    views::VIEWER_DISTANCE,
    shapes::TANGENT_PLANE,
    shapes::THIN,
    shapes::WORD_LENGTH,
];

/// A name that is no sweep.
#[derive(Debug, Error, PartialEq, Eq)]
#[error("there is no sweep `{name}`; the sweeps are {names}", names = names().join(", "))]
pub struct UnknownSweep {
    /// As given.
    pub name: String,
}

/// Their names.
pub fn names() -> Vec<&'static str> {
    ALL.iter().map(|sweep| sweep.name).collect()
}

/// The sweep of a name.
pub fn find(name: &str) -> Result<&'static Sweep, UnknownSweep> {
    let found = ALL.iter().find(|sweep| sweep.name == name);
    found.ok_or_else(|| UnknownSweep { name: name.into() })
}
