//! The sweeps, one file each.

mod cylinder_axis;
mod eye_distance;
mod side_offset;
mod sphere_radius;
mod steep_plane;
mod tangent_plane;
mod thin;
mod viewer_distance;
mod word_length;
mod world_offset;

use super::Sweep;

/// Every sweep, in the order of the documentation.
pub const ALL: &[Sweep] = &[
    cylinder_axis::SWEEP,
    eye_distance::SWEEP,
    steep_plane::SWEEP,
    sphere_radius::SWEEP,
    world_offset::SWEEP,
    side_offset::SWEEP,
    viewer_distance::SWEEP,
    tangent_plane::SWEEP,
    thin::SWEEP,
    word_length::SWEEP,
];
