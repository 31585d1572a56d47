//! Lanes: pixels of a line side by side.

use std::ops::Range;

/// Most pixels side by side. Shorter loops would be unrolled, and then not become vector instructions.
pub(super) const LANES: usize = 64;

/// Lanes in use are a multiple of this, so that no loop has a rest; those beyond the screen box are not handed on.
pub(super) const STEP: usize = 16;

/// The pixels that the lanes hold: the first one, and how many lanes are in use.
pub(super) struct Pixels {
    pub(super) x: i64,
    pub(super) y: i64,
    pub(super) used: usize,
}

impl Pixels {
    #[inline(always)]
    pub(super) fn lanes(&self) -> Range<usize> {
        // The compiler sees here that no index is out of its array.
        0..self.used.min(LANES)
    }
}
