//! Words that begin at a line of eight, so that no vector lies across two lines of a cache.

use std::ops::{Deref, DerefMut, Range};

/// Words whose first lies at a multiple of 64 bytes.
pub(crate) struct Words {
    words: Vec<u64>,
    begin: usize,
}

/// Words more than are wanted, of which as many stand before the first as its place asks for.
const MORE: usize = 7;

impl Words {
    pub(crate) fn new(count: usize) -> Words {
        let words = vec![0u64; count + MORE];
        Words {
            begin: words.as_ptr().align_offset(64),
            words,
        }
    }

    fn range(&self) -> Range<usize> {
        self.begin..self.begin + self.words.len() - MORE
    }
}

impl Deref for Words {
    type Target = [u64];

    fn deref(&self) -> &[u64] {
        &self.words[self.range()]
    }
}

impl DerefMut for Words {
    fn deref_mut(&mut self) -> &mut [u64] {
        let range = self.range();
        &mut self.words[range]
    }
}
