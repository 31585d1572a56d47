//! Is an object in a zone, and which of its planes matter there?

use super::blocks::everywhere;
use super::surface::{Planes, Surface, all_planes, keep};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};

/// What of an object matters on a window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Matter {
    /// Nothing: it is at no pixel.
    Nothing,
    /// The object with these of its planes; the others cut nothing.
    With(Planes),
}

/// What of an object matters on a window of its own pixels, by bounds alone: [`Matter::Nothing`] and idle planes are
/// certain, the rest is what could not be excluded.
pub fn matter(words: &QuadricWords, window: &ScreenBox, format: &Format) -> Matter {
    let mut planes = all_planes(words.planes.len());
    let absent = |planes| {
        everywhere(window, &|w| {
            Surface::new(words, format, w).is_absent(planes)
        })
    };
    if absent(planes) {
        return Matter::Nothing;
    }
    // One after the other: what is left out is idle beside the planes that are still there.
    for index in 0..words.planes.len() {
        let without = planes & !(1 << index);
        let idle = |w: &ScreenBox| {
            let surface = Surface::new(words, format, w);
            surface.is_absent(without) || surface.is_idle(index, without)
        };
        if everywhere(window, &idle) {
            planes = without;
        }
    }
    Matter::With(planes)
}

/// The words with these planes only, one after the other; the faces behind one that is left out have smaller numbers.
pub fn with_planes(words: &QuadricWords, planes: Planes) -> QuadricWords {
    let mut left = words.clone();
    keep(&mut left.planes, planes);
    left
}
