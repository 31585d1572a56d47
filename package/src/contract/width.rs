//! Widths as formulas in the depth word.

use std::fmt;

/// `times W + plus` bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Width {
    times: usize,
    plus: usize,
}

impl Width {
    /// A number of bits that does not depend on the format.
    pub const fn fixed(plus: usize) -> Width {
        Width { times: 0, plus }
    }

    /// `W + plus` bits.
    pub const fn word(plus: usize) -> Width {
        Width { times: 1, plus }
    }

    /// `2W` bits.
    pub const fn double() -> Width {
        Width { times: 2, plus: 0 }
    }

    /// Bits at a depth word.
    pub const fn bits(self, depth_word: usize) -> usize {
        self.times * depth_word + self.plus
    }
}

impl fmt::Display for Width {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.times, self.plus) {
            (0, plus) => write!(f, "{plus}"),
            (1, 0) => write!(f, "W"),
            (1, plus) => write!(f, "W + {plus}"),
            (times, 0) => write!(f, "{times}W"),
            (times, plus) => write!(f, "{times}W + {plus}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Width;

    #[test]
    fn formulas_are_read_as_they_count() {
        let formats = [
            Width::fixed(12),
            Width::word(0),
            Width::word(2),
            Width::double(),
        ];
        assert_eq!(formats.map(|w| w.to_string()), ["12", "W", "W + 2", "2W"]);
        assert_eq!(formats.map(|w| w.bits(20)), [12, 20, 22, 40]);
    }
}
