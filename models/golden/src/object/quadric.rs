//! The quadric object processor of the second generation, any number of cut planes (source: 2.4.2).

use crate::format::Format;
use crate::unit::cut_plane::{PlaneKind, cut};
use crate::unit::interval::{Class, FACE_PLANE, Interval, halves};
use crate::unit::merge::merge;
use crate::unit::normal::{NormalWords, select};
use crate::unit::pe1::{Linear, Pe1};
use crate::unit::pe2::Quadratic;
use crate::unit::plane_depth::saturate;
use crate::unit::quadric_pe::{QuadricDepths, QuadricPe};
use imogene_contract::words;
use serde::{Deserialize, Serialize};

/// Largest number of cut planes of one object.
pub const MAX_PLANES: usize = words::MOST_PLANES as usize;

/// The screen box of an object in pixels of the zone, inclusive; empty if `x0 > x1` or `y0 > y1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ScreenBox {
    /// First column.
    pub x0: i64,
    /// Last column.
    pub x1: i64,
    /// First line.
    pub y0: i64,
    /// Last line.
    pub y1: i64,
}

impl ScreenBox {
    /// A whole screen.
    pub fn of_screen(width: u32, height: u32) -> ScreenBox {
        ScreenBox {
            x0: 0,
            x1: i64::from(width) - 1,
            y0: 0,
            y1: i64::from(height) - 1,
        }
    }

    /// A box that contains no pixel.
    pub const EMPTY: ScreenBox = ScreenBox {
        x0: 1,
        x1: 0,
        y0: 1,
        y1: 0,
    };

    /// True if no pixel is inside.
    pub fn is_empty(&self) -> bool {
        self.x0 > self.x1 || self.y0 > self.y1
    }

    /// The least box around two that contain pixels.
    pub fn around(&self, other: &ScreenBox) -> ScreenBox {
        ScreenBox {
            x0: self.x0.min(other.x0),
            x1: self.x1.max(other.x1),
            y0: self.y0.min(other.y0),
            y1: self.y1.max(other.y1),
        }
    }

    /// True if the boxes have a pixel in common, or pixels side by side.
    pub fn touches(&self, other: &ScreenBox) -> bool {
        let along = |a0: i64, a1: i64, b0: i64, b1: i64| a0 <= b1 + 1 && b0 <= a1 + 1;
        along(self.x0, self.x1, other.x0, other.x1) && along(self.y0, self.y1, other.y0, other.y1)
    }

    /// True if the pixel is inside.
    #[inline]
    pub fn contains(&self, x: i64, y: i64) -> bool {
        (self.x0..=self.x1).contains(&x) && (self.y0..=self.y1).contains(&y)
    }

    /// Number of pixels inside.
    pub fn pixels(&self) -> u64 {
        if self.is_empty() {
            0
        } else {
            ((self.x1 - self.x0 + 1) * (self.y1 - self.y0 + 1)) as u64
        }
    }

    /// The part of the box in a zone of `width` x `height` pixels whose first pixel is (x0, y0), in that zone's pixels.
    pub fn in_zone(&self, x0: i64, y0: i64, width: i64, height: i64) -> ScreenBox {
        let part = ScreenBox {
            x0: self.x0.max(x0) - x0,
            x1: self.x1.min(x0 + width - 1) - x0,
            y0: self.y0.max(y0) - y0,
            y1: self.y1.min(y0 + height - 1) - y0,
        };
        part.or_empty()
    }

    /// The part of the box on the lines `first, first + step, first + 2 step, ..`, which are counted 0, 1, 2, ..
    pub fn every_line(&self, step: i64, first: i64) -> ScreenBox {
        let part = ScreenBox {
            y0: (self.y0 - first + step - 1).div_euclid(step),
            y1: (self.y1 - first).div_euclid(step),
            ..*self
        };
        part.or_empty()
    }

    /// The part of the box at the columns `column, column + step, ..` and lines `line, line + step, ..`, which are
    /// counted 0, 1, 2, ..
    pub fn every_sample(&self, step: i64, column: i64, line: i64) -> ScreenBox {
        let part = ScreenBox {
            x0: (self.x0 - column + step - 1).div_euclid(step),
            x1: (self.x1 - column).div_euclid(step),
            y0: (self.y0 - line + step - 1).div_euclid(step),
            y1: (self.y1 - line).div_euclid(step),
        };
        part.or_empty()
    }

    fn or_empty(self) -> ScreenBox {
        if self.is_empty() {
            ScreenBox::EMPTY
        } else {
            self
        }
    }
}

/// Coefficient words of one cut plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PlaneWords {
    /// How the plane lies to the viewer.
    pub kind: PlaneKind,
    /// Depth of the plane, or its signed half-plane value if perpendicular.
    pub depth: Linear,
    /// Constant normal.
    pub normal: [i16; 3],
}

/// All coefficient words of one object for one zone.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct QuadricWords {
    /// How the object lies to the viewer.
    pub class: Class,
    /// Where the object can be on the screen; outside it is absent whatever the accumulators hold.
    pub screen_box: ScreenBox,
    /// Linear part of the depth, in units of `2^-g1` depth words.
    pub f1: Linear,
    /// Discriminant part of the depth, in units of `2^-g2` of its last bit; its sign is the silhouette.
    pub f2: Quadratic,
    /// Normal of the quadric.
    pub normal: NormalWords,
    /// Cut planes in the order of the chain.
    pub planes: Vec<PlaneWords>,
}

impl QuadricWords {
    /// f1 at a pixel of the zone, guard bits dropped.
    #[inline]
    pub fn f1_at(&self, x: i64, y: i64, format: &Format) -> i64 {
        format.drop_linear(self.f1.wrapped_at(x, y, format.pe1_width()) as i64)
    }

    /// f2 at a pixel of the zone, guard bits dropped.
    #[inline]
    pub fn f2_at(&self, x: i64, y: i64, format: &Format) -> i64 {
        format.drop_quadratic(self.f2.wrapped_at(x, y, format.pe2_width()) as i64)
    }

    /// The words of the same object for a zone of `width` x `height` pixels whose first pixel is (x0, y0) of the
    /// present one.
    ///
    /// The integers are moved, not rounded again, so every pixel keeps its value.
    pub fn for_zone(&self, x0: i64, y0: i64, width: i64, height: i64) -> QuadricWords {
        let mut words = self.clone();
        words.screen_box = self.screen_box.in_zone(x0, y0, width, height);
        words.f1 = self.f1.from_zone(x0, y0);
        words.f2 = self.f2.from_zone(x0, y0);
        words.normal.g = self.normal.g.map(|g| g.from_zone(x0, y0));
        for plane in &mut words.planes {
            plane.depth = plane.depth.from_zone(x0, y0);
        }
        words
    }

    /// The same words as the registers of a format hold them; every accumulator takes the same values.
    pub fn wrapped(&self, format: &Format) -> QuadricWords {
        let mut words = self.clone();
        words.f1 = self.f1.wrapped(format.pe1_width());
        words.f2 = self.f2.wrapped(format.pe2_width());
        words.normal.g = self.normal.g.map(|g| g.wrapped(format.normal_linear));
        for plane in &mut words.planes {
            plane.depth = plane.depth.wrapped(format.plane);
        }
        words
    }

    /// The words of the same object at one sample of each pixel: columns `column, column + step, ..` and lines `line,
    /// line + step, ..` (Nyiri, 3.2.2).
    pub fn every_sample(&self, step: i64, column: i64, line: i64) -> QuadricWords {
        let mut words = self.clone();
        words.screen_box = self.screen_box.every_sample(step, column, line);
        words.f1 = self.f1.every_sample(step, column, line);
        words.f2 = self.f2.every_sample(step, column, line);
        let g = self.normal.g;
        words.normal.g = g.map(|g| g.every_sample(step, column, line));
        for plane in &mut words.planes {
            plane.depth = plane.depth.every_sample(step, column, line);
        }
        words
    }

    /// The words of the same object on the lines `first, first + step, first + 2 step, ..` alone: a field of an
    /// interlaced picture.
    pub fn every_line(&self, step: i64, first: i64) -> QuadricWords {
        let mut words = self.clone();
        words.screen_box = self.screen_box.every_line(step, first);
        words.f1 = self.f1.every_line(step, first);
        words.f2 = self.f2.every_line(step, first);
        words.normal.g = self.normal.g.map(|g| g.every_line(step, first));
        for plane in &mut words.planes {
            plane.depth = plane.depth.every_line(step, first);
        }
        words
    }
}

/// What the processor hands on for one pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct ObjectPixel {
    /// Front depth, or the format's `z_max` if the object is absent.
    pub zf: i64,
    /// Back depth.
    pub zb: i64,
    /// Number of the front face.
    pub number: u8,
    /// Normal of the front face.
    pub normal: [i16; 3],
}

/// Every value inside the processor at one pixel, under the names of the hardware; for traces and for finding a fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Probe {
    /// Value of the f1 processor, guard bits dropped.
    pub f1: i64,
    /// Value of the f2 processor, guard bits dropped.
    pub f2: i64,
    /// Root of f2; of no meaning where f2 is negative.
    pub root: i64,
    /// f1 - root.
    pub near: i64,
    /// f1 + root.
    pub far: i64,
    /// Depth interval before the planes, half A and B.
    pub halves: (Interval, Interval),
    /// Saturated value of each plane.
    pub plane: Vec<i64>,
    /// Both halves after each plane.
    pub cut: Vec<(Interval, Interval)>,
    /// After the merge of the halves.
    pub merged: Interval,
    /// Linear parts of the normal.
    pub g: [i64; 3],
    /// What is handed on.
    pub output: ObjectPixel,
}

/// Latency in clocks from the raster flags to the outputs of a quadric processor.
pub fn latency(format: &Format, planes: usize, rows_per_stage: u32) -> u32 {
    format.root_rows().div_ceil(rows_per_stage) + planes as u32 + 7
}

/// The processor running over a zone, pixel by pixel.
#[derive(Clone, Debug)]
pub struct QuadricProcessor {
    format: Format,
    words: QuadricWords,
    normals: Vec<[i16; 3]>,
    core: QuadricPe,
    planes: Vec<Pe1>,
    g: [Pe1; 3],
    x: i64,
    y: i64,
}

impl QuadricProcessor {
    /// Zone start: all elementary processors load their words; the next pixel is (0, 0) of the zone.
    pub fn zone_start(words: &QuadricWords, format: &Format) -> QuadricProcessor {
        QuadricProcessor {
            format: *format,
            words: words.clone(),
            normals: words.planes.iter().map(|p| p.normal).collect(),
            core: QuadricPe::object_start(&words.f1, &words.f2, format),
            planes: words
                .planes
                .iter()
                .map(|p| Pe1::object_start(&p.depth, format.plane))
                .collect(),
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
        self.planes.iter_mut().for_each(Pe1::line_step);
        self.g.iter_mut().for_each(Pe1::line_step);
        self.x = 0;
        self.y += 1;
    }

    /// The values of the next pixel of the line, with everything in between.
    pub fn probe(&mut self) -> Probe {
        let format = &self.format;
        let QuadricDepths {
            f1,
            f2,
            root,
            near,
            far,
        } = self.core.pixel(format);
        let inside = self.words.screen_box.contains(self.x, self.y);
        let interval = if inside {
            halves(self.words.class, near, far, f2 < 0, format)
        } else {
            (Interval::absent(format), Interval::absent(format))
        };
        let plane: Vec<i64> = self
            .planes
            .iter_mut()
            .map(|pe| saturate(pe.pixel() as i64, format))
            .collect();
        let cut = self.chain(interval, &plane);
        let (a, b) = cut.last().copied().unwrap_or(interval);
        let merged = merge(a, b);
        let g = std::array::from_fn(|k| self.g[k].pixel() as i64);
        let output = self.output(merged, g, root);
        self.x += 1;
        Probe {
            f1,
            f2,
            root,
            near,
            far,
            halves: interval,
            plane,
            cut,
            merged,
            g,
            output,
        }
    }

    /// What the processor hands on for the next pixel of the line.
    pub fn pixel(&mut self) -> ObjectPixel {
        if self.words.screen_box.contains(self.x, self.y) {
            return self.probe().output;
        }
        // Nothing is there, and no plane changes that.
        self.core.skip();
        let linear = self.planes.iter_mut().chain(&mut self.g);
        linear.for_each(|pe| _ = pe.pixel());
        self.x += 1;
        ObjectPixel {
            zf: self.format.z_max(),
            zb: self.format.z_max(),
            number: 0,
            normal: [0; 3],
        }
    }

    fn chain(&self, start: (Interval, Interval), depths: &[i64]) -> Vec<(Interval, Interval)> {
        let patch = self.words.class == Class::Patch;
        let mut state = start;
        let mut after = Vec::with_capacity(depths.len());
        for (i, (plane, &zp)) in self.words.planes.iter().zip(depths).enumerate() {
            let number = FACE_PLANE + i as u8;
            let one = |half| cut(half, plane.kind, zp, number, patch, &self.format);
            state = (one(state.0), one(state.1));
            after.push(state);
        }
        after
    }

    fn output(&self, merged: Interval, g: [i64; 3], root: i64) -> ObjectPixel {
        let present = merged.is_present(&self.format);
        ObjectPixel {
            zf: merged.zf,
            zb: merged.zb,
            number: merged.nf,
            normal: select(
                merged.nf,
                present,
                g,
                root,
                &self.words.normal,
                &self.normals,
                &self.format,
            ),
        }
    }
}
