//! Is an object in a zone, and which of its planes matter there?

use super::blocks::everywhere;
pub use super::surface::Matter;
use super::surface::{Planes, Surface, keep};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::words::Words;

/// What of an object matters on a window of its own pixels, by bounds alone: [`Matter::Nothing`] and idle planes are
/// certain, the rest is what could not be excluded.
pub fn matter(words: &QuadricWords, window: &ScreenBox, format: &Format) -> Matter {
    Matter::of(words.planes.len(), |planes, idle| {
        everywhere(window, &|w| {
            let surface = Surface::new(words, format, w);
            surface.is_absent(planes) || idle.is_some_and(|index| surface.is_idle(index, planes))
        })
    })
}

/// The words with these planes only, one after the other; the faces behind one that is left out have smaller numbers.
pub fn with_planes(words: &QuadricWords, planes: Planes) -> QuadricWords {
    let mut left = words.clone();
    keep(&mut left.planes, planes);
    left
}

pub(crate) fn in_box(words: &ProcessorWords, screen_box: ScreenBox) -> ProcessorWords {
    let mut words = words.clone();
    *words.screen_box_mut() = screen_box;
    words
}

/// Is a part at any pixel of its box?
pub(crate) fn is_drawn(words: &ProcessorWords, format: &Format) -> bool {
    let window = words.screen_box();
    (window.y0..=window.y1).any(|y| {
        let mut drawn = false;
        words.for_each_present(format, y, |_, _| drawn = true);
        drawn
    })
}
