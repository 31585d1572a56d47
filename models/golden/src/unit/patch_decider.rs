//! The decider of a patch: the first face that every plane keeps, all planes at once (source: 2.4.3).
//!
//! A plane keeps or removes each of the two faces without looking at the other face or at another plane, so two bits of
//! each plane and two wide ANDs stand in the place of the chain of [`super::cut_plane`].

use super::cut_plane::PlaneKind;
use super::depth_interval::{FACE_FAR, FACE_NEAR, Interval};
use crate::format::Format;

/// For each of the two faces: is it there, or does a plane keep it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Faces {
    /// The front face, at the near root: the source's signal E_F.
    pub front: bool,
    /// The back face, at the far root: the source's signal E_B.
    pub back: bool,
}

impl Faces {
    /// The faces that are there.
    #[inline]
    pub const fn new(front: bool, back: bool) -> Faces {
        Faces { front, back }
    }

    /// Both faces.
    pub const BOTH: Faces = Faces::new(true, true);

    /// The faces that are in both sets.
    #[inline]
    pub const fn and(self, other: Faces) -> Faces {
        Faces::new(self.front && other.front, self.back && other.back)
    }
}

/// The faces at `near = f1 - r` and `far = f1 + r` (sum words) that exist between the near and the far end; `there` is
/// false outside the screen box and where f2 is negative.
///
/// The two ends are planes of constant depth, so this is formed beside the signals of the planes and not before them.
#[inline]
pub const fn visible(near: i64, far: i64, there: bool, format: &Format) -> Faces {
    let (low, end) = (format.z_low(), format.z_max());
    Faces::new(
        there && low <= near && near < end,
        there && low <= far && far < end,
    )
}

/// The two signals of one plane of saturated depth (or value) `zp`. Closed: a face in the plane is kept.
#[inline]
pub const fn kept(kind: PlaneKind, zp: i64, near: i64, far: i64) -> Faces {
    match kind {
        PlaneKind::None => Faces::BOTH,
        PlaneKind::Front => Faces::new(near >= zp, far >= zp),
        PlaneKind::Back => Faces::new(near <= zp, far <= zp),
        PlaneKind::Perpendicular => Faces::new(zp >= 0, zp >= 0),
    }
}

/// What is left of the two faces: both, one of them (then it is front and back at once) or nothing.
#[inline]
pub const fn decide(near: i64, far: i64, left: Faces, format: &Format) -> Interval {
    let (one, two) = ((near, FACE_NEAR), (far, FACE_FAR));
    match (left.front, left.back) {
        (true, true) => Interval::new(one, two),
        (true, false) => Interval::new(one, one),
        (false, true) => Interval::new(two, two),
        (false, false) => Interval::absent(format),
    }
}
