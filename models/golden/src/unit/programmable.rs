//! The programmable elementary processor: one PE2 of 2n bits, or four PE1 of n bits with a decision on their signs
//! (source: Chaillou, IV.1.7).
//!
//! The two adders of a PE2 pixel become four of half the width by one AND in each carry chain, and its eight registers
//! hold exactly the four words of four PE1. What is added to a PE2 is these two ANDs, one selection of an addend, and
//! the decision.

use super::pe2::PreconditionedWords;
use crate::format::wrap;

/// First-degree processors in one programmable processor.
pub const LANES: usize = 4;

/// The register words of a programmable processor in either mode, as its six coefficient words of 2n bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProgrammableWords {
    /// Four lanes instead of one second-degree expression.
    pub split: bool,
    /// The words; in split mode two words of n bits each, the lane of the lower number in the low half: the constants
    /// of lanes 0 and 1 in f, their factors of y in i0 and of x in 2b, those of lanes 2 and 3 in p0, c and 2a.
    pub words: PreconditionedWords,
    /// Lanes that the decision asks, in split mode.
    pub used: [bool; LANES],
}

/// The adder: 2n bits, its carry cut in the middle if `split`.
pub const fn add(a: i128, b: i128, half: u32, split: bool) -> i128 {
    let mask: i128 = (1 << half) - 1;
    let low = (a & mask) + (b & mask);
    let carry = if split { 0 } else { low >> half };
    let high = (a >> half) + (b >> half) + carry;
    wrap(high << half | (low & mask), 2 * half)
}

/// What the processor emits at one pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProgrammablePixel {
    /// The second-degree expression; of no meaning in split mode.
    pub value: i128,
    /// The four first-degree expressions; of no meaning otherwise.
    pub lanes: [i128; LANES],
    /// No negative value: of the used lanes in split mode, of the one expression otherwise.
    pub inside: bool,
}

/// The processor, register by register.
#[derive(Clone, Debug)]
pub struct Programmable {
    half: u32,
    split: bool,
    used: [bool; LANES],
    a2: i128,
    b2: i128,
    c: i128,
    /// I of a PE2; factors of y of lanes 0 and 1.
    line_increment: i128,
    /// Q of a PE2; line values of lanes 0 and 1.
    line: i128,
    /// P of a PE2; line values of lanes 2 and 3.
    first_increment: i128,
    /// J of a PE2; values of lanes 2 and 3.
    increment: i128,
    /// V of a PE2; values of lanes 0 and 1.
    value: i128,
}

impl Programmable {
    /// First pixel of a zone: load the words; `half` is n, at most 32.
    pub fn start(words: &ProgrammableWords, half: u32) -> Programmable {
        let w = &words.words;
        Programmable {
            half,
            split: words.split,
            used: words.used,
            a2: w.a2,
            b2: w.b2,
            c: w.c,
            line_increment: w.i0,
            line: w.f,
            first_increment: w.p0,
            increment: w.p0,
            value: w.f,
        }
    }

    /// To the next pixel of the line.
    pub fn next_pixel(&mut self) {
        let addend = if self.split { self.b2 } else { self.increment };
        self.value = self.sum(self.value, addend);
        self.increment = self.sum(self.increment, self.a2);
    }

    /// To the first pixel of the next line.
    pub fn next_line(&mut self) {
        self.line = self.sum(self.line, self.line_increment);
        self.value = self.line;
        self.first_increment = self.sum(self.first_increment, self.c);
        self.increment = self.first_increment;
        if !self.split {
            self.line_increment = self.sum(self.line_increment, self.b2);
        }
    }

    /// What is emitted at the present pixel.
    pub fn pixel(&self) -> ProgrammablePixel {
        let n = self.half;
        let lanes = [
            wrap(self.value, n),
            wrap(self.value >> n, n),
            wrap(self.increment, n),
            wrap(self.increment >> n, n),
        ];
        let inside = match self.split {
            true => (lanes.iter().zip(self.used)).all(|(&v, used)| !used || v >= 0),
            false => self.value >= 0,
        };
        ProgrammablePixel {
            value: self.value,
            lanes,
            inside,
        }
    }

    fn sum(&self, a: i128, b: i128) -> i128 {
        add(a, b, self.half, self.split)
    }
}
