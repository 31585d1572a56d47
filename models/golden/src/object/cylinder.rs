//! The cylinder processor of the first machine: body and front disc in one exact outline, a parabolic body (source:
//! Chaillou, IV.2.5).

use super::paraboloid::{depth_guard, normal_guard, one_face, plane_guard};
use super::screen_box::ScreenBox;
use super::words::{Expression, Object, ObjectPixel, Parts, Words};
use crate::format::Format;
use crate::unit::depth_interval::{FACE_NEAR, FACE_PLANE};
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use serde::{Deserialize, Serialize};

/// All coefficient words of one cylinder for one zone.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct CylinderWords {
    /// Where the cylinder can be on the screen.
    pub screen_box: ScreenBox,
    /// Sides of the rectangle between the discs, P bits, not negative inside.
    pub sides: [Linear; 4],
    /// Outlines of the front and the back disc, F bits, not negative inside.
    pub discs: [Quadratic; 2],
    /// Depth of the body, in units of `2^-(W-2)` depth words.
    pub body: Quadratic,
    /// Normal of the body, F bits.
    pub normal: [Quadratic; 3],
    /// Depth of the front disc, in units of `2^-10` depth words.
    pub disc: Linear,
    /// Normal of the front disc.
    pub disc_normal: [i16; 3],
}

impl Words for CylinderWords {
    fn parts_mut(&mut self) -> Parts<'_> {
        let first = self.sides.iter_mut().chain([&mut self.disc]);
        let second = self.discs.iter_mut().chain([&mut self.body]);
        let second = second.chain(&mut self.normal).map(Expression::Second);
        let all = first.map(Expression::First).chain(second);
        (vec![&mut self.screen_box], all.collect())
    }
}

/// Latency in clocks from the raster flags to the outputs: processors, selection of the part, ends of the depth word.
pub const LATENCY: u32 = 3;
/// Number of the front disc among the faces.
pub const FACE_DISC: u8 = FACE_PLANE;

impl Object for CylinderWords {
    /// Front and back depth are the same, that of the visible part.
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel {
        let linear = |l: &Linear| l.wrapped_at(x, y, format.plane);
        let quadratic = |q: &Quadratic| q.wrapped_at(x, y, format.quadratic);
        let [front, back] = self.discs.each_ref().map(|disc| quadratic(disc) >= 0);
        let between = || self.sides.iter().all(|side| linear(side) >= 0);
        let there = self.screen_box.contains(x, y) && (front || back || between());
        let (z, number) = match front {
            true => (linear(&self.disc) >> plane_guard(format), FACE_DISC),
            false => (quadratic(&self.body) >> depth_guard(format), FACE_NEAR),
        };
        let face = one_face(z as i64, number, there, format);
        let component = |n: &Quadratic| (quadratic(n) >> normal_guard(format)) as i16;
        let normal = || match front {
            true => self.disc_normal,
            false => self.normal.each_ref().map(component),
        };
        ObjectPixel::of(face, normal, format)
    }
}
