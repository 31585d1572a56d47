//! The quadric processor of the first generation: silhouette and plane contours on the screen decide (source: 2.4.1,
//! its algorithm corrected).
//!
//! Two parallel planes, the front one before the back one, cut a quadric seen from outside. Nothing compares depths:
//! the signs of two conics and two lines say which face is seen.

use super::screen_box::ScreenBox;
use super::words::Expression::{First, Second};
use super::words::{Object, ObjectPixel, Parts, Words};
use crate::format::Format;
use crate::unit::depth_interval::{Class, FACE_PLANE, Interval, halves};
use crate::unit::normal::{NormalWords, select};
use crate::unit::patch_decider::{Faces, decide, visible};
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use crate::unit::plane_depth::saturate;
use crate::unit::quadric_pe::QuadricDepths;
use serde::{Deserialize, Serialize};

/// Coefficient words of one of the two planes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct ContourPlane {
    /// Depth of the plane, P bits.
    pub depth: Linear,
    /// The conic in which it cuts the quadric, seen on the screen: not negative where the plane is inside the quadric.
    /// F bits, of any scale.
    pub conic: Quadratic,
    /// The line in which it meets the polar plane: negative where the middle of the quadric is on the removed side. P
    /// bits, of any scale.
    pub polar: Linear,
    /// Constant normal; that of the back plane, which is never seen, is not loaded.
    pub normal: [i16; 3],
}

/// All coefficient words of one object for one zone. f1 and f2 may have guard bits, which the core drops; conics and
/// lines have a scale of their own.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct FirstGenerationWords {
    /// The surface alone, not the solid.
    pub patch: bool,
    /// Where the object can be on the screen.
    pub screen_box: ScreenBox,
    /// Linear part of the depth.
    pub f1: Linear,
    /// Discriminant part of the depth.
    pub f2: Quadratic,
    /// Normal of the quadric.
    pub normal: NormalWords,
    /// The front plane, which keeps what is behind it.
    pub front: ContourPlane,
    /// The back plane, parallel to the front plane and behind it.
    pub back: ContourPlane,
}

impl Words for FirstGenerationWords {
    fn parts_mut(&mut self) -> Parts<'_> {
        let mut all = vec![First(&mut self.f1), Second(&mut self.f2)];
        all.extend(self.normal.g.iter_mut().map(First));
        for plane in [&mut self.front, &mut self.back] {
            all.extend([&mut plane.depth, &mut plane.polar].map(First));
            all.push(Second(&mut plane.conic));
        }
        (vec![&mut self.screen_box], all)
    }
}

/// Signs of the contour expressions at a pixel: what the control unit of the source decides on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Contours {
    /// The front plane is inside the quadric.
    pub front: bool,
    /// The back plane is inside the quadric.
    pub back: bool,
    /// The middle of the quadric is on the kept side of both planes.
    pub middle: bool,
}

impl Contours {
    /// Nothing is left: no plane passes through the quadric here, and it lies on the removed side of one of them.
    pub const fn removed(&self) -> bool {
        !self.front && !self.back && !self.middle
    }
}

/// Depths and faces of a solid: a plane inside the quadric is the face on its side.
pub fn solid(
    near: i64,
    far: i64,
    planes: [i64; 2],
    contours: Contours,
    format: &Format,
) -> Interval {
    let (mut left, _) = halves(Class::Side, near, far, contours.removed(), format);
    let present = left.is_present(format);
    if present && contours.front && planes[0] > format.z_low() {
        (left.zf, left.nf) = (planes[0], FACE_PLANE);
    }
    if present && contours.back && planes[1] < format.z_max() {
        (left.zb, left.nb) = (planes[1], FACE_PLANE + 1);
    }
    // Only a plane beyond an end of the depth word can leave nothing here.
    match left.zf <= left.zb && left.is_present(format) {
        true => left,
        false => Interval::absent(format),
    }
}

/// Depths and faces of a patch: a plane inside the quadric has removed the face on its side.
pub fn patch(near: i64, far: i64, contours: Contours, format: &Format) -> Interval {
    let kept = Faces::new(!contours.front, !contours.back);
    let faces = visible(near, far, !contours.removed(), format);
    decide(near, far, faces.and(kept), format)
}

/// Latency in clocks from the raster flags to the outputs.
pub fn latency(format: &Format, rows_per_stage: u32) -> u32 {
    format.root_latency(rows_per_stage) + 9
}

impl Object for FirstGenerationWords {
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel {
        let depths = QuadricDepths::at(&self.f1, &self.f2, x, y, format);
        let (f2, root, near, far) = (depths.f2, depths.root, depths.near, depths.far);
        let planes = [&self.front, &self.back];
        let linear = |l: &Linear| l.wrapped_at(x, y, format.plane);
        let inside = planes.map(|p| p.conic.wrapped_at(x, y, format.quadratic) >= 0);
        let contours = Contours {
            front: inside[0],
            back: inside[1],
            middle: planes.iter().all(|p| linear(&p.polar) >= 0),
        };
        let there = f2 >= 0 && self.screen_box.contains(x, y);
        let depths = planes.map(|p| saturate(linear(&p.depth) as i64, format));
        let left = match (there, self.patch) {
            (false, _) => Interval::absent(format),
            (true, false) => solid(near, far, depths, contours, format),
            (true, true) => patch(near, far, contours, format),
        };
        let g = self.normal.linear_at(x, y, format);
        let normals = planes.map(|p| p.normal);
        let normal = || select(left.nf, true, g, root, &self.normal, &normals, format);
        ObjectPixel::of(left, normal, format)
    }
}
