//! Depth of a cut plane: a PE1 of the plane width and a saturation to the depth word.
//!
//! In perspective every plane passes beyond the far end past its vanishing line, and on a 24-bit accumulator it would
//! wrap there and cut the wrong half (source: 9.3 of its restatement). The wide accumulator holds the true depth;
//! saturation keeps its order against every depth of the interval.

use crate::format::Format;

/// The plane's depth clamped to one below the near end .. far end; the sign is kept.
#[inline]
pub fn saturate(plane_depth: i64, format: &Format) -> i64 {
    plane_depth.clamp(format.plane_low(), format.z_max())
}
