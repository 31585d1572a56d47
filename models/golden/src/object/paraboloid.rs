//! The words that carry a second-degree depth, and a surface of one depth (source: Chaillou, IV.2.4).

use crate::format::Format;
use crate::unit::depth_interval::{Class, Interval, halves};

/// Bits of a second-degree depth below the depth word: an F-bit pe2 leaves S bits above them.
pub const fn depth_guard(format: &Format) -> u32 {
    format.quadratic - format.sum
}

/// Bits of a second-degree normal component below its 16.
pub const fn normal_guard(format: &Format) -> u32 {
    format.quadratic - format.normal
}

/// Bits of a first-degree depth below the depth word: a P-bit pe1 leaves S bits above them.
pub const fn plane_guard(format: &Format) -> u32 {
    format.plane - format.sum
}

/// The interval of a surface with one depth, front and back at once; absent beyond the ends of the depth word.
pub fn one_face(z: i64, number: u8, there: bool, format: &Format) -> Interval {
    let (mut face, _) = halves(Class::Patch, z, z, !there, format);
    if face.is_present(format) {
        (face.nf, face.nb) = (number, number);
    }
    face
}
