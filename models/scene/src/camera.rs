//! The window of a camera, given as on a photographic camera: focal length or field of view.

use super::file::Camera;
use super::group::Node;
use imogene_algebra::rational::{from_decimal, integer, to_f64};

/// Height in millimetres of the film that focal lengths are for: 24 x 36.
pub const FILM_HEIGHT: i64 = 24;
/// Shortest focal length in millimetres; its vertical field of view is 170.5 degrees.
pub const SHORTEST_FOCAL: f64 = 1.0;
/// Longest focal length in millimetres; its vertical field of view is 0.14 degrees.
pub const LONGEST_FOCAL: f64 = 10_000.0;
/// Narrowest vertical field of view in degrees.
pub const NARROWEST_FIELD: f64 = 0.1;
/// Widest vertical field of view in degrees; at 180 the window has no end.
pub const WIDEST_FIELD: f64 = 170.0;

/// Height of the window at a distance through a lens: `24 mm : focal = height : distance`, rounded once to `f64`.
///
/// This is `d = r / tan(phi / 2)` with the half height of the film, 12 mm, as r and the focal length as d (course
/// section 3.3, equation 1.7).
pub(super) fn height_of_focal(distance: f64, focal: f64) -> f64 {
    if !distance.is_finite() || focal == 0.0 {
        // Refused with its own message when the scene is checked.
        return distance;
    }
    to_f64(&(from_decimal(distance) * integer(FILM_HEIGHT) / from_decimal(focal)))
}

/// Height of the window at a distance that is seen under a vertical angle in degrees: `2 d tan(phi / 2)` in `f64`.
pub(super) fn height_of_field(distance: f64, degrees: f64) -> f64 {
    2.0 * distance * (0.5 * degrees).to_radians().tan()
}

impl Camera {
    /// Its name, group and place.
    pub fn node(&self) -> &Node {
        match self {
            Self::Perspective { node, .. } | Self::Orthographic { node, .. } => node,
        }
    }

    /// The same, to change.
    pub fn node_mut(&mut self) -> &mut Node {
        match self {
            Self::Perspective { node, .. } | Self::Orthographic { node, .. } => node,
        }
    }

    /// Where pixels are sampled: columns to the right and lines down from whole coordinates.
    pub fn sample_at(&self) -> [f64; 2] {
        match self {
            Self::Perspective { sample_at, .. } | Self::Orthographic { sample_at, .. } => {
                *sample_at
            }
        }
    }

    /// The focal length in millimetres that shows the same window on a film 24 mm high; none for a parallel view.
    pub fn focal(&self) -> Option<f64> {
        match self {
            Self::Perspective {
                viewer_distance,
                view_height,
                ..
            } => Some(to_f64(
                &(from_decimal(*viewer_distance) * integer(FILM_HEIGHT)
                    / from_decimal(*view_height)),
            )),
            Self::Orthographic { .. } => None,
        }
    }

    /// Takes another lens: the window changes its height, the eye and the screen plane stay. A parallel view has no
    /// lens and stays as it is.
    pub fn set_focal(&mut self, focal: f64) {
        if let Self::Perspective {
            viewer_distance,
            view_height,
            ..
        } = self
        {
            *view_height = height_of_focal(*viewer_distance, focal);
        }
    }
}
