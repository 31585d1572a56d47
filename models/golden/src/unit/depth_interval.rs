//! The quadric elementary processor's two depths f1 -+ r and the depth interval they open, by class of object
//! (source: 2.3.1, 2.4.2; the case f2 < 0 seen from inside is corrected).

use crate::format::Format;
use imogene_contract::words;
use serde::{Deserialize, Serialize};

/// How an object lies to the viewer; decided once in the preparation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[repr(u8)]
pub enum Class {
    /// Solid between its two roots; the eye is outside the unbounded quadric.
    #[default]
    Side = words::SIDE as u8,
    /// Solid outside its two roots; the eye is inside the unbounded quadric.
    Front = words::FRONT as u8,
    /// The surface itself; both roots are candidate faces.
    Patch = words::PATCH as u8,
    /// A quadric that does not depend on the depth: present where f2 >= 0.
    Prism = words::PRISM as u8,
}

impl Class {
    /// All of them, in the order of their words.
    pub const ALL: [Class; 4] = [Self::Side, Self::Front, Self::Patch, Self::Prism];
}

/// Number of the quadric's near root among the faces of an object.
pub const FACE_NEAR: u8 = words::NEAR_ROOT as u8;
/// Number of the quadric's far root.
pub const FACE_FAR: u8 = words::FAR_ROOT as u8;
/// Number of the first cut plane; plane i has `FACE_PLANE + i`.
pub const FACE_PLANE: u8 = words::FIRST_PLANE as u8;
/// Number of the cap drawn where a solid reaches nearer than the near end.
pub const FACE_NEAR_END: u8 = words::CAP as u8;

/// A depth interval with the numbers of the faces that bound it; absent is `zf = zb = z_max`, numbers 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Interval {
    /// Front depth.
    pub zf: i64,
    /// Back depth.
    pub zb: i64,
    /// Number of the front face.
    pub nf: u8,
    /// Number of the back face.
    pub nb: u8,
}

impl Interval {
    /// From a front depth with the number of its face to a back depth with its own.
    #[inline]
    pub const fn new((zf, nf): (i64, u8), (zb, nb): (i64, u8)) -> Interval {
        Interval { zf, zb, nf, nb }
    }

    /// The absent object.
    #[inline]
    pub const fn absent(format: &Format) -> Interval {
        let z_max = format.z_max();
        Interval::new((z_max, 0), (z_max, 0))
    }

    /// True if something is there to be seen.
    #[inline]
    pub const fn is_present(&self, format: &Format) -> bool {
        self.zf != format.z_max()
    }
}

/// The two halves of an object's depth interval at a pixel inside its screen box; half B exists only for
/// [`Class::Front`].
///
/// `near = f1 - r` and `far = f1 + r` before saturation; `negative` is `f2 < 0`, where the root has no meaning.
#[inline]
pub fn halves(
    class: Class,
    near: i64,
    far: i64,
    negative: bool,
    format: &Format,
) -> (Interval, Interval) {
    let absent = Interval::absent(format);
    match class {
        Class::Side if !negative => (side(near, far, format), absent),
        Class::Patch if !negative => (patch(near, far, format), absent),
        Class::Front if !negative => (front_a(near, format), front_b(far, format)),
        // Seen from inside, a line that misses the surface is wholly inside; the source drilled a hole here.
        Class::Front => (whole_line(format), absent),
        Class::Prism if !negative => (whole_line(format), absent),
        _ => (absent, absent),
    }
}

fn whole_line(format: &Format) -> Interval {
    Interval::new(
        (format.z_low(), FACE_NEAR_END),
        (format.z_max(), FACE_NEAR_END),
    )
}

/// A front face, or the cap if it is nearer than the near end.
#[inline]
fn capped(z: i64, number: u8, format: &Format) -> (i64, u8) {
    match z < format.z_low() {
        true => (format.z_low(), FACE_NEAR_END),
        false => (z, number),
    }
}

#[inline]
fn side(near: i64, far: i64, format: &Format) -> Interval {
    if near >= format.z_max() || far < format.z_low() {
        return Interval::absent(format);
    }
    let back = (far.min(format.z_max()), FACE_FAR);
    Interval::new(capped(near, FACE_NEAR, format), back)
}

#[inline]
fn front_a(near: i64, format: &Format) -> Interval {
    if near < format.z_low() {
        return Interval::absent(format);
    }
    let back = (near.min(format.z_max()), FACE_NEAR);
    Interval::new((format.z_low(), FACE_NEAR_END), back)
}

#[inline]
fn front_b(far: i64, format: &Format) -> Interval {
    if far >= format.z_max() {
        return Interval::absent(format);
    }
    let back = (format.z_max(), FACE_NEAR_END);
    Interval::new(capped(far, FACE_FAR, format), back)
}

#[inline]
fn patch(near: i64, far: i64, format: &Format) -> Interval {
    let visible = |z: i64| z >= format.z_low() && z < format.z_max();
    let one = |z: i64, number: u8| Interval::new((z, number), (z, number));
    match (visible(near), visible(far)) {
        (true, true) => Interval::new((near, FACE_NEAR), (far, FACE_FAR)),
        (true, false) => one(near, FACE_NEAR),
        (false, true) => one(far, FACE_FAR),
        (false, false) => Interval::absent(format),
    }
}
