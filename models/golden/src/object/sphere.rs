//! The sphere processor of the first machine: an exact outline, and a paraboloid for the depth (source: Chaillou, IV.2.4).

use super::paraboloid::{
    Exact, NORMAL_LENGTH, bulge, contour, depth_guard, first_degree, normal_guard, second_degree,
};
use super::quadric::{ObjectPixel, ScreenBox};
use crate::format::{Format, wrap64};
use crate::unit::interval::{Class, FACE_NEAR, FACE_NEAR_END, halves};
use crate::unit::normal::{LINEAR_WIDTH, NEAR_END_NORMAL};
use crate::unit::pe1::{Linear, Pe1};
use crate::unit::pe2::{Pe2, Quadratic};
use imogene_algebra::rational::{integer, round_half_up};
use num_rational::BigRational;
use num_traits::ToPrimitive;
use serde::{Deserialize, Serialize};

/// A sphere of an orthographic view: centre in pixels and depth words, radius in pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SphereShape {
    /// Column of the centre.
    pub x: BigRational,
    /// Line of the centre.
    pub y: BigRational,
    /// Depth of the centre in depth words.
    pub z: BigRational,
    /// Radius in pixels, positive.
    pub radius: BigRational,
    /// Depth words per pixel, positive.
    pub scale: BigRational,
}

/// All coefficient words of one sphere for one zone.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
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

impl SphereShape {
    /// The paraboloid's front depth as an expression in pixels: `z - s (a R - b r^2 / R)`.
    pub fn paraboloid(&self) -> Exact {
        let (a, b) = bulge();
        let factor = b * &self.scale / &self.radius;
        let top = &self.z - a * &self.radius * &self.scale;
        self.round(&factor, top)
    }

    /// `factor ((x - x1)^2 + (y - y1)^2) + top`.
    fn round(&self, factor: &BigRational, top: BigRational) -> Exact {
        let minus_two = integer(-2) * factor;
        let far = factor * (&self.x * &self.x + &self.y * &self.y);
        [
            factor.clone(),
            factor.clone(),
            integer(0),
            &minus_two * &self.x,
            &minus_two * &self.y,
            top + far,
        ]
    }

    /// Not negative inside the outline: `R^2 - r^2`.
    pub fn outline(&self) -> Exact {
        self.round(&integer(-1), &self.radius * &self.radius)
    }

    /// The normal's parts along columns and along lines, of length [`NORMAL_LENGTH`].
    pub fn normal_across(&self) -> [[BigRational; 3]; 2] {
        let slope = integer(NORMAL_LENGTH) / &self.radius;
        [
            [slope.clone(), integer(0), -&slope * &self.x],
            [integer(0), slope.clone(), -&slope * &self.y],
        ]
    }

    /// The normal's part along the depth, by the same paraboloid as the depth.
    pub fn normal_deep(&self) -> Exact {
        let (high, low) = bulge();
        let length = integer(NORMAL_LENGTH);
        let deep = low * &length / (&self.radius * &self.radius);
        self.round(&deep, -high * length)
    }

    /// The coefficient words.
    pub fn words(&self, screen_box: ScreenBox, format: &Format) -> SphereWords {
        let [a, b, c, d, e, f] = contour(&self.outline());
        let across = |exact: &[BigRational; 3]| first_degree(exact, LINEAR_WIDTH - format.normal);
        let sum = round_half_up(&(integer(2) * &self.z));
        SphereWords {
            screen_box,
            contour: Quadratic { a, b, c, d, e, f },
            front: second_degree(&self.paraboloid(), depth_guard(format)),
            sum: sum
                .to_i64()
                .expect("twice a depth word has fewer than 64 bits"),
            normal: self.normal_across().each_ref().map(across),
            normal_z: second_degree(&self.normal_deep(), normal_guard(format)),
        }
    }
}

impl SphereWords {
    /// The words of the same object for a zone of `width` x `height` pixels whose first pixel is (x0, y0) of the present one: moved, not rounded again.
    pub fn for_zone(&self, x0: i64, y0: i64, width: i64, height: i64) -> SphereWords {
        let mut words = self.clone();
        words.screen_box = self.screen_box.in_zone(x0, y0, width, height);
        words.contour = self.contour.from_zone(x0, y0);
        words.front = self.front.from_zone(x0, y0);
        words.normal = self.normal.map(|n| n.from_zone(x0, y0));
        words.normal_z = self.normal_z.from_zone(x0, y0);
        words
    }

    /// The words of the same object on the lines `first, first + step, first + 2 step, ..` alone, which are counted 0, 1, 2, ..
    pub fn every_line(&self, step: i64, first: i64) -> SphereWords {
        let mut words = self.clone();
        words.screen_box = self.screen_box.every_line(step, first);
        words.contour = self.contour.every_line(step, first);
        words.front = self.front.every_line(step, first);
        words.normal = self.normal.map(|n| n.every_line(step, first));
        words.normal_z = self.normal_z.every_line(step, first);
        words
    }
}

/// Latency in clocks from the raster flags to the outputs: processors, back depth, depth interval, output.
pub const LATENCY: u32 = 4;

/// The processor running over a zone, pixel by pixel.
#[derive(Clone, Debug)]
pub struct SphereProcessor {
    format: Format,
    words: SphereWords,
    contour: Pe2,
    front: Pe2,
    normal: [Pe1; 2],
    normal_z: Pe2,
    x: i64,
    y: i64,
}

impl SphereProcessor {
    /// Zone start: all elementary processors load their words; the next pixel is (0, 0) of the zone.
    pub fn zone_start(words: &SphereWords, format: &Format) -> SphereProcessor {
        let pe2 = |q: &Quadratic| Pe2::object_start(q, format.quadratic);
        SphereProcessor {
            format: *format,
            words: words.clone(),
            contour: pe2(&words.contour),
            front: pe2(&words.front),
            normal: words.normal.map(|n| Pe1::object_start(&n, LINEAR_WIDTH)),
            normal_z: pe2(&words.normal_z),
            x: 0,
            y: 0,
        }
    }

    /// Line step: the next pixel is the first of the next line.
    pub fn line_step(&mut self) {
        self.contour.line_step();
        self.front.line_step();
        self.normal.iter_mut().for_each(Pe1::line_step);
        self.normal_z.line_step();
        self.x = 0;
        self.y += 1;
    }

    /// What the processor hands on for the next pixel of the line.
    pub fn pixel(&mut self) -> ObjectPixel {
        let format = self.format;
        let there = self.contour.pixel() >= 0 && self.words.screen_box.contains(self.x, self.y);
        let near = (self.front.pixel() >> depth_guard(&format)) as i64;
        let far = wrap64(self.words.sum - near, format.sum);
        let (interval, _) = halves(Class::Side, near, far, !there, &format);
        let [nx, ny] = [0, 1].map(|k| (self.normal[k].pixel() >> (LINEAR_WIDTH - 16)) as i16);
        let nz = (self.normal_z.pixel() >> normal_guard(&format)) as i16;
        self.x += 1;
        let normal = match interval.nf {
            FACE_NEAR if interval.is_present(&format) => [nx, ny, nz],
            FACE_NEAR_END => NEAR_END_NORMAL,
            _ => [0; 3],
        };
        ObjectPixel {
            zf: interval.zf,
            zb: interval.zb,
            number: interval.nf,
            normal,
        }
    }
}
