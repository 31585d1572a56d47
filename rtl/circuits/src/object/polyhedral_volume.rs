//! Shadow or light volume of planes.

use super::{Answer, Bounds, IN_ZONE, VolumePoint};
use crate::raster::{Flags, Pixel};
use imogene_hdl::{Value, module};

/// For every pixel whether the visible point lies in a shadow or light volume: an intersection of half-spaces. The
/// point comes with the flags.
///
/// A point is in an intersection exactly if it is in every part, so every part is asked by itself: no chain of cuts, no
/// second half. Latency 3. The words stay unchanged until that many clocks after the last flags of a zone. Sections
/// 3.2.1 and 4.1.3.
pub fn polyhedral_volume(
    at: &str,
    flags: Flags,
    pixel: Pixel,
    point: VolumePoint,
    bounds: Bounds,
) -> Answer {
    let inputs = (flags, ("", pixel, IN_ZONE), point, bounds);
    module(
        "polyhedral_volume",
        at,
        inputs,
        |(flags, (_, pixel, _), point, bounds)| {
            let in_box = bounds
                .screen_box
                .contains(pixel)
                .delayed_as("in_box_late", 2);
            let is_kept = point.is_kept(flags, &bounds.planes);
            Answer {
                out_valid: flags.valid.delayed_as("valid_late", 3),
                is_inside: (in_box & is_kept).reg(),
            }
        },
    )
}
