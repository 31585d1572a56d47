//! The non-planar facet: second-degree sides, depth and normals (source: Chaillou, IV.2.6.1).

use super::paraboloid::{Exact, contour, depth_guard, normal_guard, one_face, second_degree};
use super::quadric::{ObjectPixel, ScreenBox};
use crate::format::Format;
use crate::unit::interval::FACE_NEAR;
use crate::unit::pe2::{Pe2, Quadratic};
use imogene_contract::words;
use serde::{Deserialize, Serialize};

/// Most sides of a facet.
pub const MAX_SIDES: usize = words::MOST_SIDES as usize;

/// The word of a side: its sign is that of the exact expression, not negative on the facet.
pub fn side(exact: &Exact) -> Quadratic {
    let [a, b, c, d, e, f] = contour(exact);
    Quadratic { a, b, c, d, e, f }
}

/// The same side for the neighbour: `-q - 1` is not negative exactly where q is negative, so no pixel is in both or in neither.
pub fn other_side(q: &Quadratic) -> Quadratic {
    Quadratic {
        a: -q.a,
        b: -q.b,
        c: -q.c,
        d: -q.d,
        e: -q.e,
        f: -q.f - 1,
    }
}

/// All coefficient words of one facet for one zone, F bits each.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
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

    /// The words of the same object for a zone of `width` x `height` pixels whose first pixel is (x0, y0) of the present one: moved, not rounded again.
    pub fn for_zone(&self, x0: i64, y0: i64, width: i64, height: i64) -> CurvedFacetWords {
        let mut words = self.clone();
        words.screen_box = self.screen_box.in_zone(x0, y0, width, height);
        for side in &mut words.sides {
            *side = side.from_zone(x0, y0);
        }
        words.depth = self.depth.from_zone(x0, y0);
        words.normal = self.normal.map(|n| n.from_zone(x0, y0));
        words
    }

    /// The words of the same object on the lines `first, first + step, first + 2 step, ..` alone, which are counted 0, 1, 2, ..
    pub fn every_line(&self, step: i64, first: i64) -> CurvedFacetWords {
        let mut words = self.clone();
        words.screen_box = self.screen_box.every_line(step, first);
        for side in &mut words.sides {
            *side = side.every_line(step, first);
        }
        words.depth = self.depth.every_line(step, first);
        words.normal = self.normal.map(|n| n.every_line(step, first));
        words
    }
}

/// Latency in clocks from the raster flags to the outputs: processors; signs, ends of the depth word and selection.
pub const LATENCY: u32 = 2;

/// The processor running over a zone, pixel by pixel.
#[derive(Clone, Debug)]
pub struct CurvedFacetProcessor {
    format: Format,
    screen_box: ScreenBox,
    sides: Vec<Pe2>,
    depth: Pe2,
    normal: [Pe2; 3],
    x: i64,
    y: i64,
}

impl CurvedFacetProcessor {
    /// Zone start: all elementary processors load their words; the next pixel is (0, 0) of the zone.
    pub fn zone_start(words: &CurvedFacetWords, format: &Format) -> CurvedFacetProcessor {
        let pe2 = |q: &Quadratic| Pe2::object_start(q, format.quadratic);
        CurvedFacetProcessor {
            format: *format,
            screen_box: words.screen_box,
            sides: words.sides.iter().map(pe2).collect(),
            depth: pe2(&words.depth),
            normal: words.normal.each_ref().map(pe2),
            x: 0,
            y: 0,
        }
    }

    /// Line step: the next pixel is the first of the next line.
    pub fn line_step(&mut self) {
        self.sides.iter_mut().for_each(Pe2::line_step);
        self.depth.line_step();
        self.normal.iter_mut().for_each(Pe2::line_step);
        self.x = 0;
        self.y += 1;
    }

    /// What the processor hands on for the next pixel of the line; front and back depth are the same.
    pub fn pixel(&mut self) -> ObjectPixel {
        let values: Vec<i128> = self.sides.iter_mut().map(Pe2::pixel).collect();
        let z = (self.depth.pixel() >> depth_guard(&self.format)) as i64;
        let guard = normal_guard(&self.format);
        let normal = self
            .normal
            .each_mut()
            .map(|pe| (pe.pixel() >> guard) as i16);
        let in_box = self.screen_box.contains(self.x, self.y);
        self.x += 1;
        let inside = in_box && values.iter().all(|&v| v >= 0);
        let face = one_face(z, FACE_NEAR, inside, &self.format);
        ObjectPixel {
            zf: face.zf,
            zb: face.zb,
            number: face.nf,
            normal: if face.is_present(&self.format) {
                normal
            } else {
                [0; 3]
            },
        }
    }
}
