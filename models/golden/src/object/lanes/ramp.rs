//! Lanes, pixels of a line side by side, and first-degree expressions along them.

use crate::unit::pe1::Linear;
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

/// An expression from the first lane on. The word stands at the top of 64 bits, where it wraps by itself.
pub(super) struct Ramp {
    width: u32,
    value: i64,
    step: i64,
}

/// The same in 32 bits: twice as many lanes in a vector, and sums need no second word.
pub(super) struct ShortRamp {
    value: i32,
    step: i32,
}

impl Ramp {
    #[inline(always)]
    pub(super) fn at(expression: &Linear, pixels: &Pixels, width: u32) -> Ramp {
        let Linear { a, b, c } = *expression;
        let line = (b as i64).wrapping_mul(pixels.y).wrapping_add(c as i64);
        let value = (a as i64).wrapping_mul(pixels.x).wrapping_add(line);
        Ramp {
            width,
            value: value << (64 - width),
            step: (a as i64) << (64 - width),
        }
    }

    #[inline(always)]
    pub(super) fn next(&mut self) -> i64 {
        let value = self.value;
        self.value = value.wrapping_add(self.step);
        value
    }

    /// The upper 32 bits, for a word that is no longer: it still wraps by itself.
    #[inline(always)]
    pub(super) fn upper(&self) -> ShortRamp {
        ShortRamp {
            value: (self.value >> 32) as i32,
            step: (self.step >> 32) as i32,
        }
    }

    /// The word itself if it stays between `-most` and `most`, neither of them reached, and fits 32 bits.
    ///
    /// Between its first and its last value it takes none beyond them. There are 16 lanes at least, so a step of it is
    /// shorter than the word.
    #[inline(always)]
    pub(super) fn within(&self, most: i64, pixels: &Pixels) -> Option<ShortRamp> {
        let [first, step] = [self.value, self.step].map(|word| word >> (64 - self.width));
        let last = first + step * (pixels.used as i64 - 1);
        let most = most.min(1 << 31);
        let fits = first.max(last) < most && first.min(last) > -most;
        fits.then_some(ShortRamp {
            value: first as i32,
            step: step as i32,
        })
    }
}

impl ShortRamp {
    #[inline(always)]
    pub(super) fn next(&mut self) -> i32 {
        let value = self.value;
        self.value = value.wrapping_add(self.step);
        value
    }
}
