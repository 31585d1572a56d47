//! An object as a member of a product of a solid: what it hands on of it where its own face is seen.
//!
//! Each object of a product has a quadric processor. Of one taken away the back is seen, from within: its processor is
//! given the words of the object seen from behind (depths complemented, so that what it finds in front is the back),
//! and both depths that it finds are complemented again.

use super::quadric::QuadricWords;
use super::screen_box::ScreenBox;
use super::words::{Expression, Object, ObjectPixel, Words};
use crate::format::Format;
use crate::machine::csg::{Extent, front};
use crate::unit::depth_interval::FACE_NEAR_END;
use serde::Serialize;

/// The words of all objects of a product, and which of them this is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct MemberWords {
    /// Of the objects intersected, then of those taken away, each seen from behind.
    pub objects: Vec<QuadricWords>,
    /// How many are intersected.
    pub intersected: usize,
    /// Index of this one.
    pub place: usize,
}

impl MemberWords {
    /// Those of its own processor.
    pub fn own(&self) -> &QuadricWords {
        &self.objects[self.place]
    }

    /// Where the object ends along the line of sight.
    fn extent(&self, place: usize, pixel: &ObjectPixel, format: &Format) -> Extent {
        let ObjectPixel { zf, zb, number, .. } = *pixel;
        if place < self.intersected {
            return Extent { zf, zb };
        }
        // What reaches the far end has its cap there.
        let is_open = number == FACE_NEAR_END && zf != format.z_max();
        Extent {
            zf: !zb,
            zb: if is_open { format.z_max() } else { !zf },
        }
    }
}

impl Words for MemberWords {
    fn screen_box(&self) -> &ScreenBox {
        &self.own().screen_box
    }

    fn screen_box_mut(&mut self) -> &mut ScreenBox {
        &mut self.objects[self.place].screen_box
    }

    fn boxes_mut(&mut self) -> Vec<&mut ScreenBox> {
        let objects = self.objects.iter_mut();
        objects.map(|words| &mut words.screen_box).collect()
    }

    fn expressions(&mut self) -> Vec<Expression<'_>> {
        let objects = self.objects.iter_mut();
        objects.flat_map(QuadricWords::expressions).collect()
    }
}

impl Object for MemberWords {
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel {
        let pixels = self.objects.iter().map(|words| words.at(x, y, format));
        let pixels: Vec<ObjectPixel> = pixels.collect();
        let extents = pixels.iter().enumerate();
        let extents = extents.map(|(place, pixel)| self.extent(place, pixel, format));
        let extents: Vec<Extent> = extents.collect();
        let (intersected, subtracted) = extents.split_at(self.intersected);
        let seen = front(intersected, subtracted, format.z_max());
        match seen.filter(|seen| seen.object == self.place) {
            Some(seen) => ObjectPixel {
                zf: seen.depth,
                zb: seen.depth,
                ..pixels[self.place]
            },
            None => ObjectPixel {
                zf: format.z_max(),
                zb: format.z_max(),
                number: 0,
                normal: [0; 3],
            },
        }
    }
}
