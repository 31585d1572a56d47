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

    /// One for each lane, side by side.
    pub(crate) fn of_constants(constants: &[[u64; 4]]) -> Words {
        let mut words = Words::new(4 * constants.len());
        words[..4 * constants.len()].copy_from_slice(constants.as_flattened());
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
