//! Quadric core: both elementary processors, the root and the sums that give the two depths of a quadric (source: 2.4.2).

use super::pe1::{Linear, Pe1};
use super::pe2::{Pe2, Quadratic};
use super::root::restoring_root;
use crate::format::{Format, wrap64};

/// The quadric core running over a zone, pixel by pixel.
#[derive(Clone, Debug)]
pub struct QuadricPe {
    f1: Pe1,
    f2: Pe2,
}

/// Values of the core at a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuadricDepths {
    /// Value of the f1 processor, guard bits dropped.
    pub f1: i64,
    /// Value of the f2 processor, guard bits dropped.
    pub f2: i64,
    /// Root of f2; of no meaning where f2 is negative.
    pub root: i64,
    /// f1 - root.
    pub near: i64,
    /// f1 + root.
    pub far: i64,
}

impl QuadricPe {
    /// Start of an object: both processors load their words.
    pub fn object_start(f1: &Linear, f2: &Quadratic, format: &Format) -> QuadricPe {
        QuadricPe {
            f1: Pe1::object_start(f1, format.pe1_width()),
            f2: Pe2::object_start(f2, format.pe2_width()),
        }
    }

    /// Line step: the next pixel is the first of the next line.
    pub fn line_step(&mut self) {
        self.f1.line_step();
        self.f2.line_step();
    }

    /// Leaves the next pixel of the line out.
    pub fn skip(&mut self) {
        self.f1.pixel();
        self.f2.pixel();
    }

    /// The depths at the next pixel of the line.
    pub fn pixel(&mut self, format: &Format) -> QuadricDepths {
        let f1 = format.drop_linear(self.f1.pixel() as i64);
        let f2 = format.drop_quadratic(self.f2.pixel() as i64);
        let radicand = (f2 as u128) & ((1 << format.quadratic) - 1);
        // The network without its last rows: floor(sqrt(q / 4^d)) = floor(sqrt(q)) / 2^d, rounded down.
        let digits = restoring_root(radicand >> (2 * format.dropped_rows), format.root_rows());
        let root = (digits.root as i64) << format.dropped_rows;
        QuadricDepths {
            f1,
            f2,
            root,
            near: wrap64(f1 - root, format.sum),
            far: wrap64(f1 + root, format.sum),
        }
    }
}
