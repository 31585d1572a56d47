//! How far an edge is off the surface of a face.

use super::curve::Curve;
use super::surface::Surface;
use super::vector::distance;

/// Places at which a curve is compared with a surface.
const PLACES: usize = 64;

/// The greatest distance of places of the curve from the surface, scene units; 0 for a surface that is not known.
pub fn gap(curve: &Curve, surface: &Surface) -> f64 {
    curve
        .sampled(PLACES)
        .into_iter()
        .map(|p| match surface.nearest(p) {
            Some(q) => distance(p, q),
            // On the axis: as far as the surface is from it.
            None => match surface {
                Surface::Cylinder { radius, .. } | Surface::Sphere { radius, .. } => *radius,
                _ => 0.0,
            },
        })
        .fold(0.0, f64::max)
}
