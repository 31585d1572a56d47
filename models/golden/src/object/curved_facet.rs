//! The non-planar facet: second-degree sides, depth and normals (source: Chaillou, IV.2.6.1).

use super::paraboloid::{depth_guard, normal_guard, one_face};
use super::screen_box::ScreenBox;
use super::words::{Expression, Object, ObjectPixel, Parts, Words};
use crate::format::Format;
use crate::unit::depth_interval::FACE_NEAR;
use crate::unit::pe2::Quadratic;
use serde::{Deserialize, Serialize};

/// All coefficient words of one facet for one zone, F bits each.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct CurvedFacetWords {
    /// Where the facet can be on the screen.
    pub screen_box: ScreenBox,
    /// Its sides, at most [`MOST_SIDES`](imogene_contract::words::MOST_SIDES), not negative inside.
    pub sides: Vec<Quadratic>,
    /// Its depth, in units of `2^-(W-2)` depth words.
    pub depth: Quadratic,
    /// Its normal, in units of `2^-(F-16)`.
    pub normal: [Quadratic; 3],
}

impl Words for CurvedFacetWords {
    fn parts_mut(&mut self) -> Parts<'_> {
        let all = self.sides.iter_mut().chain([&mut self.depth]);
        let all = all.chain(&mut self.normal).map(Expression::Second);
        (vec![&mut self.screen_box], all.collect())
    }
}

/// Latency in clocks from the raster flags to the outputs: processors; signs and ends of the depth word; selection.
pub const LATENCY: u32 = 3;

impl Object for CurvedFacetWords {
    /// Front and back depth are the same.
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel {
        let value = |q: &Quadratic| q.wrapped_at(x, y, format.quadratic);
        let inside = self.screen_box.contains(x, y) && self.sides.iter().all(|s| value(s) >= 0);
        let z = (value(&self.depth) >> depth_guard(format)) as i64;
        let face = one_face(z, FACE_NEAR, inside, format);
        let component = |n: &Quadratic| (value(n) >> normal_guard(format)) as i16;
        ObjectPixel::of(face, || self.normal.each_ref().map(component), format)
    }
}
