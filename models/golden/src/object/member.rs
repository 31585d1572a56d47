//! An object as a member of a product of a solid: what it hands on of it where its own face is seen.
//!
//! Each object of a product has a quadric processor. Of one taken away the back is seen, from within: its processor is
//! given the words of the object seen from behind (depths complemented, so that what it finds in front is the back),
//! and both depths that it finds are complemented again.

use super::quadric::QuadricWords;
use super::screen_box::ScreenBox;
use super::words::{Object, ObjectPixel, Parts, Words};
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

    /// The same, to be changed.
    pub fn own_mut(&mut self) -> &mut QuadricWords {
        &mut self.objects[self.place]
    }
}

/// Where an object ends along the line of sight.
fn extent(is_intersected: bool, pixel: &ObjectPixel, format: &Format) -> Extent {
    let ObjectPixel { zf, zb, number, .. } = *pixel;
    if is_intersected {
        return Extent { zf, zb };
    }
    // What reaches the far end has its cap there.
    let is_open = number == FACE_NEAR_END && zf != format.z_max();
    Extent {
        zf: !zb,
        zb: if is_open { format.z_max() } else { !zf },
    }
}

/// What is seen of a product at pixel (x, y), both ends at the face that is seen, and which object's face it is. The
/// first objects are intersected, the others taken away and seen from behind.
fn seen_at(
    objects: &[QuadricWords],
    intersected: usize,
    [x, y]: [i64; 2],
    format: &Format,
) -> Option<(usize, ObjectPixel)> {
    let pixels: Vec<ObjectPixel> = objects.iter().map(|words| words.at(x, y, format)).collect();
    let extents = pixels.iter().enumerate();
    let extents = extents.map(|(place, pixel)| extent(place < intersected, pixel, format));
    let extents: Vec<Extent> = extents.collect();
    let (kept, taken_away) = extents.split_at(intersected);
    let seen = front(kept, taken_away, format.z_max())?;
    let pixel = ObjectPixel {
        zf: seen.depth,
        zb: seen.depth,
        ..pixels[seen.object]
    };
    Some((seen.object, pixel))
}

/// Calls `sink(x, object, pixel)` for every pixel of line `y` at which a product is seen, left to right, with the
/// object whose face it is. The first objects are intersected, the others taken away and seen from behind.
pub fn for_each_seen(
    objects: &[QuadricWords],
    intersected: usize,
    format: &Format,
    y: i64,
    mut sink: impl FnMut(i64, usize, ObjectPixel),
) {
    let boxes = objects[..intersected].iter().map(|words| words.screen_box);
    let window = boxes.reduce(|all, one| all.shared(&one));
    let Some(window) = window.filter(|window| (window.y0..=window.y1).contains(&y)) else {
        return;
    };
    for x in window.x0..=window.x1 {
        if let Some((object, pixel)) = seen_at(objects, intersected, [x, y], format) {
            sink(x, object, pixel);
        }
    }
}

impl Words for MemberWords {
    fn parts_mut(&mut self) -> Parts<'_> {
        let parts = self.objects.iter_mut().map(QuadricWords::parts_mut);
        let (boxes, expressions): (Vec<_>, Vec<_>) = parts.unzip();
        let mut boxes: Vec<&mut ScreenBox> = boxes.into_iter().flatten().collect();
        boxes.swap(0, self.place);
        (boxes, expressions.into_iter().flatten().collect())
    }
}

impl Object for MemberWords {
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel {
        match seen_at(&self.objects, self.intersected, [x, y], format) {
            Some((place, pixel)) if place == self.place => pixel,
            _ => ObjectPixel::absent(format),
        }
    }
}
