//! Samples of a pixel, each drawn in passes of its own over the zone.

use crate::unit::lattice::Lattice;
use serde::Serialize;

/// One of the `of x of` samples of every pixel of a zone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Sample {
    /// Samples along each side of a pixel: 1, 2 or 4.
    pub of: u32,
    /// Its column in the pixel.
    pub column: u32,
    /// Its line in the pixel.
    pub line: u32,
}

impl Sample {
    /// The samples of a pixel in the order in which they are drawn.
    pub fn all(of: u32) -> impl Iterator<Item = Sample> {
        let line = move |line| (0..of).map(move |column| Sample { of, column, line });
        (0..of).flat_map(line)
    }

    /// Its place in every pixel of a picture of samples.
    pub fn pixels(&self) -> Lattice {
        Lattice::samples(self.of.into(), self.column.into(), self.line.into())
    }

    /// The first that is drawn.
    pub fn is_first(&self) -> bool {
        (self.column, self.line) == (0, 0)
    }

    /// The last that is drawn.
    pub fn is_last(&self) -> bool {
        self.column + 1 == self.of && self.line + 1 == self.of
    }

    /// As bits 8..3 of a show command: first in bit 3, last in 4, column in 6..5, line in 8..7; 0 if there is but one.
    pub fn bits(&self) -> u64 {
        if self.of == 1 {
            return 0;
        }
        let flags = u64::from(self.is_first()) | u64::from(self.is_last()) << 1;
        (flags | u64::from(self.column) << 2 | u64::from(self.line) << 4) << 3
    }

    /// The sample that a show command of a machine with `of x of` samples is for; none if there is no such one.
    pub fn of_bits(bits: u64, of: u32) -> Option<Sample> {
        let sample = Sample {
            of,
            column: (bits >> 5 & 3) as u32,
            line: (bits >> 7 & 3) as u32,
        };
        let found = sample.column < of && sample.line < of && sample.bits() == bits & 0x1f8;
        found.then_some(sample)
    }
}
