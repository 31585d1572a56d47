//! The quadric processor of the first generation: silhouette and plane contours on the screen decide (source: 2.4.1, its algorithm corrected).
//!
//! Two parallel planes, the front one before the back one, cut a quadric seen from outside. Nothing compares depths: the signs of two conics and two lines
//! say which face is seen.

use super::quadric::{ObjectPixel, ScreenBox};
use crate::format::Format;
use crate::unit::interval::{Class, FACE_PLANE, Interval, halves};
use crate::unit::normal::{NormalWords, select};
use crate::unit::patch_decider::{Faces, decide, visible};
use crate::unit::pe1::{Linear, Pe1};
use crate::unit::pe2::{Pe2, Quadratic};
use crate::unit::plane_depth::saturate;
use crate::unit::quadric_pe::{QuadricDepths, QuadricPe};
use serde::{Deserialize, Serialize};

/// Coefficient words of one of the two planes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct ContourPlane {
    /// Depth of the plane, P bits.
    pub depth: Linear,
    /// The conic in which it cuts the quadric, seen on the screen: not negative where the plane is inside the quadric. F bits, of any scale.
    pub conic: Quadratic,
    /// The line in which it meets the polar plane: negative where the middle of the quadric is on the removed side. P bits, of any scale.
    pub polar: Linear,
    /// Constant normal.
    pub normal: [i16; 3],
}

/// Which side of a plane is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kept {
    /// Depths behind the plane: the front plane.
    Behind,
    /// Depths before it: the back plane.
    Before,
}

impl ContourPlane {
    /// The words of a plane of depth `depth` that cuts the quadric `f1 -+ sqrt(f2)`, in the units of the depths:
    /// conic `f2 - (depth - f1)^2` and line `f1 - depth`, or its negative for the back plane.
    pub fn new(
        depth: Linear,
        f1: &Linear,
        f2: &Quadratic,
        kept: Kept,
        normal: [i16; 3],
    ) -> ContourPlane {
        let (p, q, r) = (depth.a - f1.a, depth.b - f1.b, depth.c - f1.c);
        let sign = match kept {
            Kept::Behind => -1,
            Kept::Before => 1,
        };
        ContourPlane {
            depth,
            conic: Quadratic {
                a: f2.a - p * p,
                b: f2.b - q * q,
                c: f2.c - 2 * p * q,
                d: f2.d - 2 * p * r,
                e: f2.e - 2 * q * r,
                f: f2.f - r * r,
            },
            polar: Linear::new(sign * p, sign * q, sign * r),
            normal,
        }
    }
}

/// All coefficient words of one object for one zone. f1 and f2 may have guard bits, which the core drops; conics and lines have a scale of their own.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
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

impl FirstGenerationWords {
    /// The words of the same object for a zone of `width` x `height` pixels whose first pixel is (x0, y0) of the present one: moved, not rounded again.
    pub fn for_zone(&self, x0: i64, y0: i64, width: i64, height: i64) -> FirstGenerationWords {
        let mut words = self.clone();
        words.screen_box = self.screen_box.in_zone(x0, y0, width, height);
        words.f1 = self.f1.from_zone(x0, y0);
        words.f2 = self.f2.from_zone(x0, y0);
        words.normal.g = self.normal.g.map(|g| g.from_zone(x0, y0));
        for plane in [&mut words.front, &mut words.back] {
            plane.depth = plane.depth.from_zone(x0, y0);
            plane.conic = plane.conic.from_zone(x0, y0);
            plane.polar = plane.polar.from_zone(x0, y0);
        }
        words
    }

    /// The words of the same object on the lines `first, first + step, first + 2 step, ..` alone, which are counted 0, 1, 2, ..
    pub fn every_line(&self, step: i64, first: i64) -> FirstGenerationWords {
        let mut words = self.clone();
        words.screen_box = self.screen_box.every_line(step, first);
        words.f1 = self.f1.every_line(step, first);
        words.f2 = self.f2.every_line(step, first);
        words.normal.g = self.normal.g.map(|g| g.every_line(step, first));
        for plane in [&mut words.front, &mut words.back] {
            plane.depth = plane.depth.every_line(step, first);
            plane.conic = plane.conic.every_line(step, first);
            plane.polar = plane.polar.every_line(step, first);
        }
        words
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
    if left.zf <= left.zb && left.is_present(format) {
        left
    } else {
        Interval::absent(format)
    }
}

/// Depths and faces of a patch: a plane inside the quadric has removed the face on its side.
pub fn patch(near: i64, far: i64, contours: Contours, format: &Format) -> Interval {
    let kept = Faces {
        front: !contours.front,
        back: !contours.back,
    };
    let faces = visible(near, far, !contours.removed(), format);
    decide(near, far, faces.and(kept), format)
}

/// Latency in clocks from the raster flags to the outputs.
pub fn latency(format: &Format, rows_per_stage: u32) -> u32 {
    format.root.div_ceil(rows_per_stage) + 6
}

/// The processor running over a zone, pixel by pixel.
#[derive(Clone, Debug)]
pub struct FirstGenerationProcessor {
    format: Format,
    words: FirstGenerationWords,
    core: QuadricPe,
    depths: [Pe1; 2],
    conics: [Pe2; 2],
    polars: [Pe1; 2],
    g: [Pe1; 3],
    x: i64,
    y: i64,
}

impl FirstGenerationProcessor {
    /// Zone start: all elementary processors load their words; the next pixel is (0, 0) of the zone.
    pub fn zone_start(words: &FirstGenerationWords, format: &Format) -> FirstGenerationProcessor {
        let planes = [words.front, words.back];
        let plane_pe = |l: &Linear| Pe1::object_start(l, format.plane);
        FirstGenerationProcessor {
            format: *format,
            words: words.clone(),
            core: QuadricPe::object_start(&words.f1, &words.f2, format),
            depths: planes.each_ref().map(|p| plane_pe(&p.depth)),
            conics: planes
                .each_ref()
                .map(|p| Pe2::object_start(&p.conic, format.quadratic)),
            polars: planes.each_ref().map(|p| plane_pe(&p.polar)),
            g: words
                .normal
                .g
                .map(|g| Pe1::object_start(&g, format.normal_linear)),
            x: 0,
            y: 0,
        }
    }

    /// Line step: the next pixel is the first of the next line.
    pub fn line_step(&mut self) {
        self.core.line_step();
        self.depths.iter_mut().for_each(Pe1::line_step);
        self.conics.iter_mut().for_each(Pe2::line_step);
        self.polars.iter_mut().for_each(Pe1::line_step);
        self.g.iter_mut().for_each(Pe1::line_step);
        self.x = 0;
        self.y += 1;
    }

    /// What the processor hands on for the next pixel of the line.
    pub fn pixel(&mut self) -> ObjectPixel {
        let format = self.format;
        let QuadricDepths {
            f2,
            root,
            near,
            far,
            ..
        } = self.core.pixel(&format);
        let planes = self
            .depths
            .each_mut()
            .map(|pe| saturate(pe.pixel() as i64, &format));
        let [front, back] = self.conics.each_mut().map(|pe| pe.pixel() >= 0);
        let sides = self.polars.each_mut().map(|pe| pe.pixel() >= 0);
        let g = self.g.each_mut().map(|pe| pe.pixel() as i64);
        let contours = Contours {
            front,
            back,
            middle: sides == [true; 2],
        };
        let there = f2 >= 0 && self.words.screen_box.contains(self.x, self.y);
        self.x += 1;
        let left = match (there, self.words.patch) {
            (false, _) => Interval::absent(&format),
            (true, false) => solid(near, far, planes, contours, &format),
            (true, true) => patch(near, far, contours, &format),
        };
        let normals = [self.words.front.normal, self.words.back.normal];
        let present = left.is_present(&format);
        ObjectPixel {
            zf: left.zf,
            zb: left.zb,
            number: left.nf,
            normal: select(
                left.nf,
                present,
                g,
                root,
                &self.words.normal,
                &normals,
                &format,
            ),
        }
    }
}
