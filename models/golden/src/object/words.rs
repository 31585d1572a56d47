//! What all processors have in common: words that are moved with the raster, and a pixel that is handed on.

use super::screen_box::ScreenBox;
use crate::format::Format;
use crate::unit::depth_interval::Interval;
use crate::unit::lattice::Lattice;
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use serde::Serialize;

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

impl ObjectPixel {
    /// Of an object that is absent.
    pub fn absent(format: &Format) -> ObjectPixel {
        ObjectPixel::of(Interval::absent(format), || [0; 3], format)
    }

    /// A face with its normal, which is asked for only if something is there.
    #[inline]
    pub fn of(face: Interval, normal: impl FnOnce() -> [i16; 3], format: &Format) -> ObjectPixel {
        let is_present = face.is_present(format);
        ObjectPixel {
            zf: face.zf,
            zb: face.zb,
            number: face.nf,
            normal: if is_present { normal() } else { [0; 3] },
        }
    }
}

/// An expression in pixels among the words of a processor.
pub enum Expression<'a> {
    /// Of a PE1.
    First(&'a mut Linear),
    /// Of a PE2.
    Second(&'a mut Quadratic),
}

/// The boxes and the expressions among the words of a processor.
pub type Parts<'a> = (Vec<&'a mut ScreenBox>, Vec<Expression<'a>>);

/// Coefficient words of one processor for one zone. They are moved, not rounded again, so every pixel keeps its value.
pub trait Words {
    /// The boxes of all objects whose words these are, its own first, and all words that depend on where the raster
    /// begins.
    fn parts_mut(&mut self) -> Parts<'_>;

    /// Its box, to be changed; an empty one switches the processor off.
    fn screen_box_mut(&mut self) -> &mut ScreenBox {
        self.parts_mut().0.swap_remove(0)
    }

    /// The words at the pixels of a lattice alone.
    fn on(&self, pixels: &Lattice) -> Self
    where
        Self: Clone,
    {
        let mut words = self.clone();
        let (boxes, expressions) = words.parts_mut();
        for window in boxes {
            *window = window.on(pixels);
        }
        for expression in expressions {
            match expression {
                Expression::First(linear) => *linear = linear.on(pixels),
                Expression::Second(quadratic) => *quadratic = quadratic.on(pixels),
            }
        }
        words
    }

    /// Leaves of its boxes what lies in a zone of so many columns and lines.
    fn crop(&mut self, size: [impl Into<i64>; 2])
    where
        Self: Sized,
    {
        let [width, height] = size.map(Into::into);
        for window in self.parts_mut().0 {
            *window = window.in_zone(0, 0, width, height);
        }
    }

    /// The words for a zone of `width` x `height` pixels whose first pixel is (x0, y0) of the present one.
    fn for_zone(&self, x0: i64, y0: i64, width: i64, height: i64) -> Self
    where
        Self: Clone,
    {
        let mut words = self.on(&Lattice::zone(x0, y0));
        words.crop([width, height]);
        words
    }
}

/// A processor that draws an object: what it hands on depends on its words and the pixel alone.
pub trait Object: Words {
    /// What is handed on for pixel (x, y) of the zone.
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel;
}
