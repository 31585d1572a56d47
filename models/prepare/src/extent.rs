//! The extent of a closed quadric from its tangent planes: exact, without a search.
//!
//! A plane touches a quadric of matrix Q iff its coefficients p satisfy `p' adj(Q) p = 0`. For the planes `x = v` that
//! is an equation of second degree in v, whose roots are the least and the greatest x of the quadric.

use super::cell::Cell;
use imogene_algebra::matrix::{Matrix4, cofactor, symmetric};
use imogene_golden::object::quadric::ScreenBox;
use imogene_scene::Quadric;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive, Zero};

/// Least and greatest x, y and z of an ellipsoid, each as `(middle -+ sqrt(radicand)) / scale` with whole numbers.
#[derive(Clone, Debug)]
pub struct Extent {
    scale: BigInt,
    middle: [BigInt; 3],
    radicand: [BigInt; 3],
}

/// An integer beyond this, halved and added to another, may be rounded in `f64`.
const FARTHEST: f64 = (1u64 << 50) as f64;

impl Extent {
    /// The extent of the inside of a quadric; nothing unless that is an ellipsoid.
    pub fn of(quadric: &Quadric) -> Option<Extent> {
        let primitive = quadric.clone().primitive();
        Extent::of_whole(primitive.coefficients().map(|value| value.to_integer()))
    }

    /// The same of whole coefficients a to j.
    pub fn of_whole(coefficients: [BigInt; 10]) -> Option<Extent> {
        let matrix = symmetric(coefficients.each_ref());
        let last = is_positive_definite(&matrix).then(|| cofactor(&matrix, 3, 3))?;
        let middle: [BigInt; 3] = std::array::from_fn(|k| cofactor(&matrix, k, 3));
        let radicand: [BigInt; 3] =
            std::array::from_fn(|k| &middle[k] * &middle[k] - &last * cofactor(&matrix, k, k));
        // Without a real point the radicands are negative.
        radicand.iter().all(|r| !r.is_negative()).then_some(Extent {
            scale: last,
            middle,
            radicand,
        })
    }

    /// The least integer not below, and the greatest not above, the extent along an axis moved by `halves / 2`.
    fn integers_within(&self, axis: usize, halves: i64) -> (BigInt, BigInt) {
        let (middle, root) = self.doubled(axis, halves);
        let scale = &self.scale * 2;
        // n scale >= middle - sqrt(r) with whole numbers iff n scale >= middle - floor(sqrt(r)).
        (
            (&middle - &root).div_ceil(&scale),
            (&middle + &root).div_floor(&scale),
        )
    }

    fn doubled(&self, axis: usize, halves: i64) -> (BigInt, BigInt) {
        let middle = &self.middle[axis] * 2 + &self.scale * halves;
        (middle, (&self.radicand[axis] * 4u32).sqrt())
    }

    fn integers_around(&self, axis: usize) -> (f64, f64) {
        let (middle, root) = self.doubled(axis, 0);
        let (scale, root): (BigInt, BigInt) = (&self.scale * 2, root + 1);
        let float = |value: BigInt| value.to_f64().unwrap_or(f64::INFINITY);
        (
            float((&middle - &root).div_floor(&scale)),
            float((&middle + &root).div_ceil(&scale)),
        )
    }

    /// The pixels of a screen at which the quadric, given in screen coordinates, can be met; `None` if it passes a
    /// side of the screen or an end of the depths `-depth .. depth`, where only a part of it counts.
    pub fn screen_box(&self, width: u32, height: u32, depth: f64) -> Option<ScreenBox> {
        let (near, far) = self.integers_around(2);
        if near < -depth || far > depth {
            return None;
        }
        let columns = self.pixels(0, width)?;
        let lines = self.pixels(1, height)?;
        let (Some((x0, x1)), Some((y0, y1))) = (columns, lines) else {
            return Some(ScreenBox::EMPTY);
        };
        Some(ScreenBox { x0, x1, y0, y1 }.or_empty())
    }

    /// Pixels along an axis of a screen of `size` pixels, the first at `-size / 2`, an inner nothing beside it; `None`
    /// if the extent passes a side.
    fn pixels(&self, axis: usize, size: u32) -> Option<Option<(i64, i64)>> {
        let (first, last) = self.integers_within(axis, i64::from(size));
        let end = BigInt::from(size) - 1;
        if last.is_negative() || first > end {
            return Some(None);
        }
        if first.is_negative() || last > end {
            return None;
        }
        Some(Some((first.to_i64()?, last.to_i64()?)))
    }

    /// A cell around the quadric; `None` if it reaches so far that `f64` does not hold all integers and their halves.
    pub fn cell(&self) -> Option<Cell> {
        let around = [0, 1, 2].map(|axis| self.integers_around(axis));
        let (low, high) = (around.map(|(low, _)| low), around.map(|(_, high)| high));
        let is_held = low.iter().chain(&high).all(|v| v.abs() < FARTHEST);
        is_held.then(|| Cell::between(low, high))
    }
}

/// Sylvester's criterion on the second-degree part.
fn is_positive_definite(m: &Matrix4<BigInt>) -> bool {
    let two = &m[0][0] * &m[1][1] - &m[0][1] * &m[1][0];
    m[0][0].is_positive() && two.is_positive() && cofactor(m, 3, 3) > BigInt::zero()
}
