//! Quadric core: both elementary processors, the root and the sums that give the two depths of a quadric (source:
//! 2.4.2).

use super::pe1::Linear;
use super::pe2::Quadratic;
use super::root::{Method, fast_root, root};
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
        let root = root_of(f2, format);
        QuadricDepths {
            f1,
            f2,
            root,
            near: wrap64(f1 - root, format.sum),
            far: wrap64(f1 + root, format.sum),
        }
    }
}

/// The root of f2 as the network of a format finds it; of no meaning where f2 is negative, whose sign the network does
/// not see.
fn root_of(f2: i64, format: &Format) -> i64 {
    let radicand = (f2 as u128) & ((1 << (format.quadratic - 1)) - 1);
    // The network without its last rows: floor(sqrt(q / 4^d)) = floor(sqrt(q)) / 2^d, rounded down.
    let (rows, dropped) = (format.root_rows(), format.dropped_rows);
    let method = Method::of(format.root_form);
    let found = root(method, radicand >> (2 * dropped), rows);
    (found.root << dropped) as i64
}

impl Format {
    /// The root that the network finds of f2; of no meaning where that is negative.
    #[inline]
    pub fn root_of(&self, f2: i64) -> i64 {
        match self.root_form.is_exact() {
            true => self.keep_rows(fast_root(f2)),
            false => root_of(f2, self),
        }
    }
}
