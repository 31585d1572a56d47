//! How many bits a word has in each lane of a vector.

use crate::lanes::Lanes;

const LOW: u64 = u32::MAX as u64;

/// Of a word in a lane. A vector of 256 bits holds eight halves or four whole words; half words lie in pairs, that of a
/// lane below that of the fourth lane behind it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Size {
    Half,
    Whole,
}

impl Size {
    /// Of a net with so many bits: halves where there are eight lanes.
    pub(crate) fn of(width: u32, lanes: Lanes) -> Size {
        match lanes == Lanes::Eight && width <= Size::Half.bits() {
            true => Size::Half,
            false => Size::Whole,
        }
    }

    /// How many vectors a net of this size has.
    pub(crate) fn vectors(self, lanes: Lanes) -> usize {
        match (lanes, self) {
            (Lanes::Eight, Size::Whole) => 2,
            _ => 1,
        }
    }

    pub(crate) fn bits(self) -> u32 {
        match self {
            Size::Half => 32,
            Size::Whole => 64,
        }
    }

    /// A word in both halves, or as it is.
    pub(crate) fn in_each(self, word: u64) -> u64 {
        match self {
            Size::Half => word & LOW | word << 32,
            Size::Whole => word,
        }
    }

    /// Of one lane.
    pub(crate) fn first(self, words: u64) -> u64 {
        match self {
            Size::Half => words & LOW,
            Size::Whole => words,
        }
    }

    /// What a function gives for the words of each lane, of which the low bits count.
    pub(crate) fn apply(self, words: [u64; 2], how: impl Fn([u64; 2]) -> u64) -> u64 {
        match self {
            Size::Whole => how(words),
            Size::Half => {
                let high = how(words.map(|word| word >> 32));
                how(words.map(|word| word & LOW)) & LOW | high << 32
            }
        }
    }

    pub(crate) fn left(self, words: u64, count: u32) -> u64 {
        self.apply([words, 0], |[word, _]| word << count)
    }

    pub(crate) fn right(self, words: u64, count: u32) -> u64 {
        self.apply([words, 0], |[word, _]| word >> count)
    }

    /// As a number of 64 bits.
    pub(crate) fn signed(self, word: u64) -> u64 {
        let free = 64 - self.bits();
        ((word << free) as i64 >> free) as u64
    }

    /// All ones in each lane whose top bit is 1.
    pub(crate) fn tops(self, words: u64) -> u64 {
        self.apply([words, 0], |[word, _]| {
            match word >> (self.bits() - 1) & 1 {
                0 => 0,
                _ => u64::MAX,
            }
        })
    }
}

/// The low halves of one vector, the high ones of another.
pub(crate) fn blended(low: u64, high: u64) -> u64 {
    low & LOW | high & !LOW
}
