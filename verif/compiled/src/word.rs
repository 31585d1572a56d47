//! Words of a circuit in those of vectors: what stands above their bits, and how they are made clean.

use crate::line::{Line, Two, Value};
use crate::size::Size;

/// A word of so many bits, in the forms that are known of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Word {
    width: u32,
    /// With anything above.
    pub(crate) value: Value,
    /// With zeros above.
    pub(crate) zeros: Option<Value>,
    /// With the sign above; a word of one bit is all ones or zero.
    pub(crate) signs: Option<Value>,
    /// Its bits are the highest, with zeros or ones below if it is of one bit, else with zeros.
    high: Option<Value>,
}

impl Word {
    /// With anything above.
    pub(crate) fn new(value: Value, width: u32) -> Word {
        let clean = (width == value.1.bits()).then_some(value);
        Word {
            width,
            value,
            zeros: clean,
            signs: clean,
            high: clean,
        }
    }

    pub(crate) fn with_zeros_above(value: Value, width: u32) -> Word {
        Word {
            zeros: Some(value),
            ..Word::new(value, width)
        }
    }

    pub(crate) fn with_signs_above(value: Value, width: u32) -> Word {
        let word = Word::new(value, width);
        Word {
            signs: Some(value),
            high: word.high.or((width == 1).then_some(value)),
            ..word
        }
    }

    /// As it stands in memory: see [`Word::kept`].
    pub(crate) fn as_kept(value: Value, width: u32) -> Word {
        match width {
            1 => Word::with_signs_above(value, 1),
            _ => Word::new(value, width),
        }
    }

    pub(crate) fn constant(bits: u64, width: u32, size: Size, to: &mut Line) -> Word {
        let free = 64 - width;
        let signs = ((bits << free) as i64 >> free) as u64;
        Word {
            width,
            value: to.constant(size, bits),
            zeros: Some(to.constant(size, bits)),
            signs: Some(to.constant(size, signs)),
            high: Some(to.constant(size, bits << (size.bits() - width))),
        }
    }

    /// A word of which only the highest bit is known to be right.
    pub(crate) fn with_bit_on_top(self, high: Value) -> Word {
        Word {
            high: Some(self.high.unwrap_or(high)),
            ..self
        }
    }

    /// It has this form already.
    pub(crate) fn is_of(&self, signed: bool) -> bool {
        match signed {
            true => self.signs.is_some(),
            false => self.zeros.is_some(),
        }
    }

    /// Of the words of vectors in which it lies.
    pub(crate) fn size(&self) -> Size {
        self.value.1
    }

    pub(crate) fn zeros(&mut self, to: &mut Line) -> Value {
        let size = self.size();
        *self
            .zeros
            .get_or_insert_with(|| match (self.width, self.signs) {
                (1, Some(signs)) => to.right(signs, size.bits() - 1),
                (width, _) => {
                    let mask = to.constant(size, u64::MAX >> (64 - width));
                    to.two(Two::And, self.value, mask)
                }
            })
    }

    pub(crate) fn signs(&mut self, to: &mut Line) -> Value {
        if let Some(signs) = self.signs {
            return signs;
        }
        let signs = match (self.width, self.zeros) {
            (1, Some(zeros)) => {
                let zero = to.constant(self.size(), 0);
                to.two(Two::Sub, zero, zeros)
            }
            (1, None) => {
                let high = self.high(to);
                to.sign(high)
            }
            (width, _) => {
                // Zero to 2^(w-1) stay as they are, the others come 2^w lower.
                let zeros = self.zeros(to);
                let top = to.constant(self.size(), 1 << (width - 1));
                let moved = to.two(Two::Xor, zeros, top);
                to.two(Two::Sub, moved, top)
            }
        };
        self.signs = Some(signs);
        signs
    }

    pub(crate) fn high(&mut self, to: &mut Line) -> Value {
        let free = self.size().bits() - self.width;
        *self.high.get_or_insert_with(|| to.left(self.value, free))
    }

    /// As it stands in memory: one bit with its sign above, more with anything.
    pub(crate) fn kept(&mut self, to: &mut Line) -> Value {
        match self.width {
            1 => self.signs(to),
            _ => self.value,
        }
    }
}

/// As it stands in memory: see [`Word::kept`].
pub(crate) fn kept(word: u64, width: u32) -> u64 {
    match width {
        1 => 0u64.wrapping_sub(word & 1),
        _ => word,
    }
}
