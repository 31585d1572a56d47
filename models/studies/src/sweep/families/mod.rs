//! The sweeps.

mod shapes;
mod views;

use super::family::Sweep;
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
