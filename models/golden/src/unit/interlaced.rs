//! The source's PE2 with a coefficient memory and a microprogram, clock by clock, and its interlaced scan (source:
//! Chaillou, IV.1.5).
//!
//! Two adders and three registers do all the work of a line and between lines; the memory has one port, and only the
//! last register can be written back. This project's pe2 has registers instead of the memory and no bubble between
//! lines; for it a field is other words ([`Quadratic::on`]).

use super::pe2::Quadratic;
use crate::format::wrap;

/// Where a register gets its next value from.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Next {
    /// Itself.
    Hold,
    /// Zero.
    Clear,
    /// The memory port.
    Memory,
    /// Its adder: R1 + R2 for R2, R2 + R3 for R3.
    Sum,
}

/// What the one port of the memory does in a clock.
#[derive(Clone, Copy)]
enum Port {
    Idle,
    Read(usize),
    /// Takes R3.
    Write(usize),
}

/// Addresses of the words that lines change.
const LINE_WORDS: std::ops::Range<usize> = 3..6;
/// Where an interlaced picture keeps what they were.
const KEPT_WORDS: usize = 6;

/// The processor.
///
/// Words 0 to 5 are 2A, 2B, C, E - B, D - A and F. The adders work before a value is emitted, so at the first pixel x
/// and y are 1. An interlaced picture has three words more; the source provides twelve, but three of its copies would
/// never differ from the originals.
#[derive(Clone, Debug)]
pub struct MemoryPe2 {
    width: u32,
    memory: Vec<i128>,
    r: [i128; 3],
    steps_per_line: u32,
    steps_due: u32,
    clocks: u64,
}

impl MemoryPe2 {
    /// Loads the words for a progressive picture whose first pixel is (0, 0) of the expression.
    pub fn progressive(expression: &Quadratic, width: u32) -> MemoryPe2 {
        let q = expression.from_zone(-1, -1);
        let words = [2 * q.a, 2 * q.b, q.c, q.e - q.b, q.d - q.a, q.f];
        MemoryPe2 {
            width,
            memory: words.iter().map(|&w| wrap(w, width)).collect(),
            r: [0; 3],
            steps_per_line: 1,
            steps_due: 1,
            clocks: 0,
        }
    }

    /// Loads the words for an interlaced picture; [`MemoryPe2::field_start`] comes next.
    pub fn interlaced(expression: &Quadratic, width: u32) -> MemoryPe2 {
        let mut pe = MemoryPe2::progressive(expression, width);
        pe.memory.extend_from_within(LINE_WORDS);
        pe.steps_per_line = 2;
        pe
    }

    /// Words of memory.
    pub fn memory_words(&self) -> usize {
        self.memory.len()
    }

    /// Clocks since the words were loaded.
    pub fn clocks(&self) -> u64 {
        self.clocks
    }

    /// Start of field 0 (lines 0, 2, 4, ..) or 1 (lines 1, 3, 5, ..), any number of times in any order.
    /// Panics if the words were loaded for a progressive picture.
    pub fn field_start(&mut self, field: u32) {
        use Next::{Hold, Memory};
        for (i, word) in LINE_WORDS.enumerate() {
            self.clock([Hold, Hold, Memory], Port::Read(KEPT_WORDS + i));
            self.clock([Hold; 3], Port::Write(word));
        }
        self.steps_due = field + 1;
    }

    /// Start of a line, the first one too.
    pub fn line_start(&mut self) {
        use Next::{Hold, Memory, Sum};
        for _ in 0..self.steps_due {
            self.line_step();
        }
        self.steps_due = self.steps_per_line;
        self.clock([Hold, Hold, Memory], Port::Read(5));
        self.clock([Memory, Hold, Hold], Port::Read(0));
        // In the pixel loop R3 takes what R2 was one clock before, so R2 goes ahead.
        self.clock([Hold, Sum, Hold], Port::Idle);
    }

    /// One pixel: both adders in one clock.
    pub fn pixel(&mut self) -> i128 {
        self.clock([Next::Hold, Next::Sum, Next::Sum], Port::Idle);
        self.r[2]
    }

    /// I += 2B, Q += I and J0 += C in memory; R2 is left at J0.
    fn line_step(&mut self) {
        use Next::{Clear, Hold, Memory, Sum};
        let program = [
            ([Memory, Hold, Hold], Port::Read(1)),
            ([Hold, Memory, Hold], Port::Read(3)),
            ([Hold, Sum, Memory], Port::Read(5)),
            ([Hold, Hold, Sum], Port::Idle),
            ([Hold, Hold, Clear], Port::Write(5)),
            ([Hold, Hold, Sum], Port::Idle),
            ([Hold, Hold, Clear], Port::Write(3)),
            ([Memory, Hold, Hold], Port::Read(2)),
            ([Hold, Memory, Hold], Port::Read(4)),
            ([Hold, Sum, Hold], Port::Idle),
            ([Hold, Hold, Sum], Port::Idle),
            ([Hold, Hold, Hold], Port::Write(4)),
        ];
        for (next, port) in program {
            self.clock(next, port);
        }
    }

    fn clock(&mut self, next: [Next; 3], port: Port) {
        let [r1, r2, r3] = self.r;
        let read = match port {
            Port::Read(word) => self.memory[word],
            Port::Write(word) => {
                self.memory[word] = r3;
                0
            }
            Port::Idle => 0,
        };
        // R1 has no adder.
        let sums = [r1, wrap(r1 + r2, self.width), wrap(r2 + r3, self.width)];
        for (k, source) in next.into_iter().enumerate() {
            match source {
                Next::Hold => {}
                Next::Clear => self.r[k] = 0,
                Next::Memory => self.r[k] = read,
                Next::Sum => self.r[k] = sums[k],
            }
        }
        self.clocks += 1;
    }
}
