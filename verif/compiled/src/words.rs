//! Words that begin at a line of four, so that no vector lies across two lines of a cache.

use std::ops::{Deref, DerefMut};

/// Words whose first lies at a multiple of 32 bytes.
pub(crate) struct Words {
    words: Vec<u64>,
    begin: usize,
}

impl Words {
    pub(crate) fn new(count: usize) -> Words {
        let words = vec![0u64; count + 3];
        Words {
            begin: words.as_ptr().align_offset(32),
            words,
        }
    }

    /// Each four times, for every lane.
    pub(crate) fn of_constants(constants: &[u64]) -> Words {
        let mut words = Words::new(4 * constants.len());
        for (place, word) in words.chunks_exact_mut(4).zip(constants) {
            place.fill(*word);
        }
        words
    }
}

impl Deref for Words {
    type Target = [u64];

    fn deref(&self) -> &[u64] {
        &self.words[self.begin..]
    }
}

impl DerefMut for Words {
    fn deref_mut(&mut self) -> &mut [u64] {
        &mut self.words[self.begin..]
    }
}
