//! Whether the pixels that rounding leaves open let the outline of an object move by a pixel or more.
//!
//! The outline of either picture separates the pixels at which the object certainly is from those at which it
//! certainly is not. At an open pixel that has both kinds among its eight neighbours, both outlines pass within a
//! pixel. A group of open pixels that is one pixel wide is no wider than a pixel either, whatever is around it. What
//! is left are open pixels of a square of four that lack one of the two: there a part of the object may be missing,
//! or be there where nothing is, that is wider than a pixel.

use super::verdict::Verdict;
use imogene_golden::object::quadric::ScreenBox;

/// Whether an object is at a pixel, as far as is proven.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Presence {
    /// It is certainly not there.
    Absent,
    /// It certainly is.
    Present,
    /// Rounding decides whether the line of sight meets it.
    Open,
    /// Rounding decides something else: a comparison with a plane or an end.
    Unclear,
}

impl Presence {
    pub(super) fn of(verdict: &Verdict) -> Presence {
        match verdict {
            Verdict::Absent => Presence::Absent,
            Verdict::Face(..) => Presence::Present,
            Verdict::Undecided { silhouette, .. } if *silhouette => Presence::Open,
            Verdict::Undecided { .. } => Presence::Unclear,
        }
    }
}

/// An object on its screen box, row-major; beside the box it is absent.
pub struct Silhouette {
    /// The box.
    pub window: ScreenBox,
    /// At each of its pixels.
    pub presence: Vec<Presence>,
    /// Columns and lines of the picture, beyond which nothing is known.
    pub size: (u32, u32),
}

impl Silhouette {
    /// The pixels at which the outline may be a pixel or more away from the true one.
    pub fn adrift(&self) -> Vec<(i64, i64)> {
        let pixels = self.window.each();
        pixels.filter(|&at| self.is_adrift(at)).collect()
    }

    fn is_adrift(&self, (x, y): (i64, i64)) -> bool {
        let is_open = |u: i64, v: i64| self.at((x + u, y + v)) == Some(Presence::Open);
        // One of the four squares of four pixels that hold this one is all open.
        let mut squares = [(-1, -1), (-1, 1), (1, -1), (1, 1)].into_iter();
        let is_square = |(u, v)| is_open(u, 0) && is_open(0, v) && is_open(u, v);
        if !is_open(0, 0) || !squares.any(is_square) {
            return false;
        }
        // This pixel is open itself, so it is neither of both.
        let around = ScreenBox::of([x - 1, x + 1], [y - 1, y + 1]);
        let is = |at, what| self.at(at).is_none_or(|found| found == what);
        let has = |what| around.each().any(|at| is(at, what));
        !(has(Presence::Absent) && has(Presence::Present))
    }

    /// Nothing beyond the picture.
    fn at(&self, (x, y): (i64, i64)) -> Option<Presence> {
        let (width, height) = self.size;
        if !ScreenBox::of_screen(width, height).contains(x, y) {
            return None;
        }
        let window = &self.window;
        if !window.contains(x, y) {
            return Some(Presence::Absent);
        }
        let [columns, _] = window.size();
        Some(self.presence[((y - window.y0) * columns + x - window.x0) as usize])
    }
}
