//! The non-planar facet: second-degree sides, depth and normals (source: Chaillou, IV.2.6.1).

use super::paraboloid::{Exact, contour, depth_guard, normal_guard, one_face, second_degree};
use super::screen_box::ScreenBox;
use super::words::{Expression, Object, ObjectPixel, Parts, Words};
use crate::format::Format;
use crate::unit::depth_interval::FACE_NEAR;
use crate::unit::pe2::Quadratic;
use imogene_contract::words;
use serde::{Deserialize, Serialize};

/// Most sides of a facet.
pub const MAX_SIDES: usize = words::MOST_SIDES as usize;

/// The word of a side: its sign is that of the exact expression, not negative on the facet.
pub fn side(exact: &Exact) -> Quadratic {
    Quadratic::new(contour(exact))
}

/// The same side for the neighbour: `-q - 1` is not negative exactly where q is negative, so no pixel is in both or in
/// neither.
pub fn other_side(q: &Quadratic) -> Quadratic {
    Quadratic::new([-q.a, -q.b, -q.c, -q.d, -q.e, -q.f - 1])
}

/// All coefficient words of one facet for one zone, F bits each.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct CurvedFacetWords {
    /// Where the facet can be on the screen.
    pub screen_box: ScreenBox,
    /// Its sides, at most [`MAX_SIDES`], not negative inside.
    pub sides: Vec<Quadratic>,
    /// Its depth, in units of `2^-(W-2)` depth words.
    pub depth: Quadratic,
    /// Its normal, in units of `2^-(F-16)`.
    pub normal: [Quadratic; 3],
}

impl CurvedFacetWords {
    /// The words of a facet with these sides, depth (in depth words) and normal (in units of its 16-bit components).
    pub fn new(
        sides: Vec<Quadratic>,
        depth: &Exact,
        normal: [&Exact; 3],
        screen_box: ScreenBox,
        format: &Format,
    ) -> CurvedFacetWords {
        CurvedFacetWords {
            screen_box,
            sides,
            depth: second_degree(depth, depth_guard(format)),
            normal: normal.map(|n| second_degree(n, normal_guard(format))),
        }
    }
}

impl Words for CurvedFacetWords {
    fn screen_box(&self) -> &ScreenBox {
        &self.screen_box
    }

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
