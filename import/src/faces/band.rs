//! Bands: parts of a surface between two parallels.

use super::surface::{Implicit, Surface};

/// Share of its height by which a band goes on under or over the next, so that the rounding of both leaves no pixel to
/// neither. Out there a chord is a twelfth of the deviation off.
pub const OVERLAP: f64 = 0.02;

/// A part of the surface between two parallels, drawn as one quadric.
#[derive(Clone, Debug)]
pub struct Band {
    /// Its quadric; nothing on a plane.
    pub quadric: Option<Implicit>,
    /// Least and greatest v.
    pub ends: [f64; 2],
    /// Share of its height by which it goes on beyond the border of its face, within the deviation.
    pub beyond: f64,
}

impl Band {
    pub fn whole(surface: &Surface) -> Vec<Band> {
        vec![Band {
            quadric: surface.implicit(),
            ends: [f64::NEG_INFINITY, f64::INFINITY],
            beyond: 0.0,
        }]
    }
}
