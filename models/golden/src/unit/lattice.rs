//! Pixels of a raster that are evenly spaced: those of a zone, of a field, or one sample of each pixel.

/// The columns `x0, x0 + dx, ..` and lines `y0, y0 + dy, ..` of a raster, both counted 0, 1, 2, ..
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lattice {
    /// First column.
    pub x0: i64,
    /// First line.
    pub y0: i64,
    /// From column to column.
    pub dx: i64,
    /// From line to line.
    pub dy: i64,
}

impl Lattice {
    /// All pixels from (x0, y0) on: a zone.
    pub const fn zone(x0: i64, y0: i64) -> Lattice {
        let (dx, dy) = (1, 1);
        Lattice { x0, y0, dx, dy }
    }

    /// The lines `first, first + step, ..`: a field, or one of several groups of lines.
    pub const fn lines(step: i64, first: i64) -> Lattice {
        Lattice {
            dy: step,
            ..Lattice::zone(0, first)
        }
    }

    /// The columns `first, first + step, ..`: one lane of several pixels at once.
    pub const fn columns(step: i64, first: i64) -> Lattice {
        Lattice {
            dx: step,
            ..Lattice::zone(first, 0)
        }
    }

    /// One sample of each pixel (Nyiri, 3.2.2).
    pub const fn samples(step: i64, column: i64, line: i64) -> Lattice {
        Lattice {
            dx: step,
            dy: step,
            ..Lattice::zone(column, line)
        }
    }
}
