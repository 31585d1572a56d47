//! Shadow or light volume of planes.

use super::{Answer, Bounds, VolumePoint};
use crate::raster::Scan;
use imogene_hdl::{Value, module};

/// For every pixel whether the visible point lies in a shadow or light volume: an intersection of half-spaces. The
/// point comes with the flags.
///
/// A point is in an intersection exactly if it is in every part, so every part is asked by itself: no chain of cuts, no
/// second half. Latency 4. The words stay unchanged until that many clocks after the last flags of a zone. Sections
/// 3.2.1 and 4.1.3.
pub fn polyhedral_volume(at: &str, scan: Scan, point: VolumePoint, bounds: Bounds) -> Answer {
    let inputs = (scan, point, bounds);
    module("polyhedral_volume", at, inputs, |(scan, point, bounds)| {
        let in_box = bounds.screen_box.contains(scan.pixel);
        let in_box = in_box.delayed_as("in_box_late", 3);
        let is_kept = VolumePoint::is_kept(point.depths(), scan.flags, &bounds.planes);
        Answer {
            out_valid: scan.flags.valid.delayed_as("valid_late", 4),
            is_inside: (in_box & is_kept).reg(),
        }
    })
}
