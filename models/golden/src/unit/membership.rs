//! Is a point of the line of sight inside a volume: the test of shadow and light volumes (source: 3.2.1, 4.1.3).
//!
//! The source cuts the volume's depth interval and compares the point with what is left. A point is in an intersection
//! exactly if it is in every part, so each part is asked by itself: one comparison of each plane, and neither a chain
//! nor a second half.

use super::cut_plane::PlaneKind;
use super::depth_interval::Class;
use crate::format::Format;

/// The depth in question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Point {
    /// Visible depth.
    pub z: i64,
    /// The depth less the margin, `S` bits: what has to lie at or behind a face where the volume begins.
    pub entered: i64,
}

impl Point {
    /// The point at the visible depth `z`. With margin 0 the test is closed; a margin m >= 1 asks for m counts behind
    /// the beginning, so that a surface does not shadow itself. The end of a volume is closed.
    #[inline]
    pub const fn new(z: i64, margin: u32) -> Point {
        Point {
            z,
            entered: z - margin as i64,
        }
    }

    /// The point in units of `2^shift`, downwards: `near 2^shift <= entered` exactly if `near` is not above the coarse
    /// one.
    #[inline]
    pub const fn coarse(&self, shift: u8) -> Point {
        Point {
            z: self.z >> shift,
            entered: self.entered >> shift,
        }
    }

    /// False for the background, which is in no volume.
    #[inline]
    pub const fn is_surface(&self, format: &Format) -> bool {
        self.z < format.z_max()
    }
}

/// Is the point inside the unbounded quadric with the sums `near = f1 - r` and `far = f1 + r`; `negative` is `f2 < 0`.
///
/// A patch has no inside.
#[inline]
pub const fn in_quadric(class: Class, near: i64, far: i64, negative: bool, point: Point) -> bool {
    match class {
        Class::Side => !negative && near <= point.entered && point.z <= far,
        Class::Front => negative || point.z <= near || far <= point.entered,
        Class::Prism => !negative,
        Class::Patch => false,
    }
}

/// Is the point on the kept side of a plane of depth (or value) `zp`, all P bits of it: no saturation is needed.
#[inline]
pub const fn in_half_space(kind: PlaneKind, zp: i64, point: Point) -> bool {
    match kind {
        PlaneKind::None => true,
        PlaneKind::Front => zp <= point.entered,
        PlaneKind::Back => point.z <= zp,
        PlaneKind::Perpendicular => zp >= 0,
    }
}
