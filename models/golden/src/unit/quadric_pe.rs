//! Quadric core: both elementary processors, the root and the sums that give the two depths of a quadric (source:
//! 2.4.2).

use super::pe1::Linear;
use super::pe2::Quadratic;
use super::root::restoring_root;
use crate::format::{Format, wrap64};

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

impl QuadricDepths {
    /// The depths at pixel (x, y) of the zone.
    pub fn at(f1: &Linear, f2: &Quadratic, x: i64, y: i64, format: &Format) -> QuadricDepths {
        let f1 = format.drop_linear(f1.wrapped_at(x, y, format.pe1_width()) as i64);
        let f2 = format.drop_quadratic(f2.wrapped_at(x, y, format.pe2_width()) as i64);
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
