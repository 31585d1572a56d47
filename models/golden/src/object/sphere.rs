//! The sphere processor of the first machine: an exact outline, and a paraboloid for the depth (source: Chaillou,
//! IV.2.4).

use super::facet::linear_component;
use super::paraboloid::{depth_guard, normal_guard};
use super::screen_box::ScreenBox;
use super::words::{Expression, Object, ObjectPixel, Parts, Words};
use crate::format::{Format, wrap64};
use crate::unit::depth_interval::{Class, FACE_NEAR_END, halves};
use crate::unit::normal::NEAR_END_NORMAL;
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use serde::{Deserialize, Serialize};

/// All coefficient words of one sphere for one zone.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct SphereWords {
    /// Where the sphere can be on the screen.
    pub screen_box: ScreenBox,
    /// Not negative inside the outline.
    pub contour: Quadratic,
    /// Front depth, in units of `2^-(W-2)` depth words.
    pub front: Quadratic,
    /// Front and back depth together, the same at every pixel: what the source spends a fourth PE2 on.
    pub sum: i64,
    /// Normal in x and y, 24 bits.
    pub normal: [Linear; 2],
    /// Normal in z, F bits.
    pub normal_z: Quadratic,
}

impl Words for SphereWords {
    fn parts_mut(&mut self) -> Parts<'_> {
        let second = [&mut self.contour, &mut self.front, &mut self.normal_z];
        let first = self.normal.iter_mut().map(Expression::First);
        let all = first.chain(second.map(Expression::Second));
        (vec![&mut self.screen_box], all.collect())
    }
}

/// Latency in clocks from the raster flags to the outputs: processors, back depth, depth interval, output.
pub const LATENCY: u32 = 4;

impl Object for SphereWords {
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel {
        let value = |q: &Quadratic| q.wrapped_at(x, y, format.quadratic);
        let there = self.screen_box.contains(x, y) && value(&self.contour) >= 0;
        let near = (value(&self.front) >> depth_guard(format)) as i64;
        let far = wrap64(self.sum - near, format.sum);
        let (interval, _) = halves(Class::Side, near, far, !there, format);
        let normal = || match interval.nf {
            FACE_NEAR_END => NEAR_END_NORMAL,
            _ => {
                let [nx, ny] = self.normal.each_ref().map(|n| linear_component(n, x, y));
                let nz = value(&self.normal_z) >> normal_guard(format);
                [nx, ny, nz as i16]
            }
        };
        ObjectPixel::of(interval, normal, format)
    }
}
