//! The polyhedron processor: a convex solid of planes with its front and back depth and both faces (source: annex A;
//! Chaillou: IV.2.3).

use super::quadric::PlaneWords;
use super::screen_box::ScreenBox;
use super::words::{Expression, Object, ObjectPixel, Parts, Words};
use crate::format::Format;
use crate::unit::depth_interval::{FACE_NEAR_END, FACE_PLANE, Interval};
use crate::unit::half_spaces::{close, leaf, tree, tree_levels};
use crate::unit::normal::NEAR_END_NORMAL;
use serde::{Deserialize, Serialize};

/// All coefficient words of one polyhedron for one zone; at least one plane, at most [`super::quadric::MAX_PLANES`].
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PolyhedronWords {
    /// Where the object can be on the screen.
    pub screen_box: ScreenBox,
    /// Its planes, each with the outward normal.
    pub planes: Vec<PlaneWords>,
}

impl Words for PolyhedronWords {
    fn parts_mut(&mut self) -> Parts<'_> {
        let planes = self.planes.iter_mut();
        let expressions = planes.map(|p| Expression::First(&mut p.depth));
        (vec![&mut self.screen_box], expressions.collect())
    }
}

/// What the processor hands on for one pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct PolyhedronPixel {
    /// Depths and face numbers.
    pub interval: Interval,
    /// Outward normal of the front face.
    pub front_normal: [i16; 3],
    /// Outward normal of the back face.
    pub back_normal: [i16; 3],
}

/// Latency in clocks from the raster flags to the outputs: pe1, saturation in two, tree, the two ends, what is between
/// them, normals.
pub fn latency(planes: usize) -> u32 {
    tree_levels(planes) + 6
}

impl PolyhedronWords {
    /// Both faces at pixel (x, y) of the zone.
    /// Panics if there is no plane.
    pub fn faces_at(&self, x: i64, y: i64, format: &Format) -> PolyhedronPixel {
        let planes = self.planes.iter().enumerate();
        let leaves = planes.map(|(i, p)| leaf(p.kind, p.depth_at(x, y, format), i, format));
        let all = tree(leaves.collect()).expect("a polyhedron has at least one plane");
        let interval = close(all, self.screen_box.contains(x, y), format);
        let normal = |number: u8, end: [i16; 3]| match number {
            _ if !interval.is_present(format) => [0; 3],
            FACE_NEAR_END => end,
            plane => self.planes[usize::from(plane - FACE_PLANE)].normal,
        };
        PolyhedronPixel {
            interval,
            front_normal: normal(interval.nf, NEAR_END_NORMAL),
            back_normal: normal(interval.nb, FAR_END_NORMAL),
        }
    }
}

impl Object for PolyhedronWords {
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel {
        let faces = self.faces_at(x, y, format);
        ObjectPixel::of(faces.interval, || faces.front_normal, format)
    }
}

/// Normal of a back face that no plane bounds before the far end: away from the viewer.
pub const FAR_END_NORMAL: [i16; 3] = [0, 0, 32767];
