//! Lines of sight in scene coordinates.
//!
//! The point at parameter t of the pixel (X, Y) is `from + t along`, both of first degree in X and Y. In perspective
//! t is 1 at twice the near end and the depth of a point, as a share of the depth word's greatest value, is
//! `1 - 1/t`; in parallel projection it is t itself, -1 at the near end and 1 at the far end.
//!
//! The screen axes of a camera are double-precision numbers, not quite at right angles. The scene is the exact scene
//! with these, so a line of sight follows the dual axes: cross products of the others over the determinant.

use crate::interval::Interval;
use crate::transform::{Vector, apply, placement, unit};
use crate::verdict::{Cell, Ends};
use imogene_algebra::rational::{from_decimal, from_f64_exact, integer, to_f64};
use imogene_scene::{Camera, DepthRange, Lens};
use num_rational::BigRational;
use num_traits::{One, Zero};
use std::ops::{Mul, Sub};

/// Coefficients of X, of Y, and a constant. X and Y are in half pixels from the middle of the picture.
pub type Affine = [Vector; 3];

/// The lines of sight of a picture.
#[derive(Clone, Debug)]
pub struct Sight {
    /// Columns.
    pub width: u32,
    /// Lines.
    pub height: u32,
    /// Where lines of sight begin.
    pub from: Affine,
    /// Where they go.
    pub along: Affine,
    /// Whether they meet in the eye.
    pub perspective: bool,
}

impl Sight {
    /// The lines of sight of a camera, for a picture of `width` x `height` pixels whose depth words cover a range.
    ///
    /// They go through the places of pixels at which the camera samples.
    pub fn new(camera: &Camera, range: &DepthRange, width: u32, height: u32) -> Sight {
        let ([eye, target], [view, up]) = observer(camera);
        let [right, down, forward] = screen_axes(view, up);
        let half_pixel = from_decimal(camera.view_height) / integer(2 * i64::from(height));
        let (half_pixel, start, still, perspective) = match camera.lens {
            Lens::Perspective {
                viewer_distance, ..
            } => {
                let distance = integer(2) * &range.near;
                // Of the window at that distance.
                let half_pixel = half_pixel * &distance / from_decimal(viewer_distance);
                (half_pixel, scaled(forward, &distance), eye, true)
            }
            Lens::Orthographic { .. } => {
                let far = range.far.as_ref().expect("a parallel view has a far end");
                let ends = [far + &range.near, far - &range.near];
                let [middle, half] = ends.map(|length| length / integer(2));
                let away = scaled(forward.clone(), &middle);
                let origin = std::array::from_fn(|k| &target[k] + &away[k]);
                (half_pixel, origin, scaled(forward, &half), false)
            }
        };
        let [right, down] = [right, down].map(|axis| scaled(axis, &half_pixel));
        let [x, y] = camera.sample_at.map(|v| from_decimal(v) * integer(2));
        let start = std::array::from_fn(|k| &start[k] + &right[k] * &x + &down[k] * &y);
        // Of places (X, Y), and the same for all.
        let moving = [right, down, start];
        let still = [Vector::default(), Vector::default(), still];
        let (from, along) = match perspective {
            true => (still, moving),
            false => (moving, still),
        };
        Sight {
            width,
            height,
            from,
            along,
            perspective,
        }
    }

    /// The parameters between which everything drawn lies.
    pub fn ends(&self) -> Ends {
        let (first, last) = match self.perspective {
            true => (BigRational::new(1.into(), 2.into()), None),
            false => (integer(-1), Some(integer(1))),
        };
        Ends { first, last }
    }

    /// The rectangle from one pixel to another, both in it.
    pub fn cell(&self, from: [u32; 2], to: [u32; 2]) -> Cell {
        let (left, top) = self.place(from[0], from[1]);
        let (right, bottom) = self.place(to[0], to[1]);
        let (first, last) = match self.perspective {
            true => (0.5, f64::INFINITY),
            false => (-1.0, 1.0),
        };
        Cell {
            x: (left + right) as f64 / 2.0,
            y: (top + bottom) as f64 / 2.0,
            reach_x: (right - left) as f64 / 2.0,
            reach_y: (bottom - top) as f64 / 2.0,
            first,
            last,
        }
    }

    /// Coordinates of a pixel's centre in half pixels.
    pub fn place(&self, column: u32, line: u32) -> (i64, i64) {
        let half = |at: u32, size: u32| 2 * i64::from(at) - i64::from(size);
        (half(column, self.width), half(line, self.height))
    }

    /// Depth at a parameter, as a share of the greatest depth word.
    pub fn depth(&self, t: Interval) -> Interval {
        let one = Interval::point(1.0);
        if self.perspective { one - one / t } else { t }
    }

    /// The parameter at a depth.
    pub fn parameter(&self, depth: Interval) -> Interval {
        let one = Interval::point(1.0);
        match self.perspective {
            true => one / (one - depth),
            false => depth,
        }
    }

    /// Depth at a parameter, exactly.
    pub fn exact_depth(&self, t: &BigRational) -> BigRational {
        match self.perspective {
            true => BigRational::one() - t.recip(),
            false => t.clone(),
        }
    }
}

/// A point as it is written.
pub(crate) fn point(at: &[f64; 3]) -> Vector {
    let [x, y, z] = at.map(from_decimal);
    [x, y, z, BigRational::one()]
}

fn scaled(axis: [BigRational; 3], factor: &BigRational) -> Vector {
    let [x, y, z] = axis.map(|v| v * factor);
    [x, y, z, BigRational::zero()]
}

/// Eye and target of an observer, and its directions of view and up: as written, unless placement steps move them.
fn observer(camera: &Camera) -> ([Vector; 2], [[f64; 3]; 2]) {
    let (ends, up) = ([&camera.eye, &camera.target], camera.up);
    let steps = &camera.node.place;
    if steps.is_empty() {
        let view = [0, 1, 2].map(|k| camera.target[k] - camera.eye[k]);
        return (ends.map(point), [view, up]);
    }
    let matrix = placement(steps);
    let ends = ends.map(|at| apply(&matrix, &point(at)));
    let up = apply(&matrix, &scaled(up.map(from_decimal), &BigRational::one()));
    let view = [0, 1, 2].map(|k| to_f64(&(&ends[1][k] - &ends[0][k])));
    (ends, [view, [0, 1, 2].map(|k| to_f64(&up[k]))])
}

/// The dual of the axes right, down and forward.
fn screen_axes(view: [f64; 3], up: [f64; 3]) -> [[BigRational; 3]; 3] {
    let forward = unit(view);
    let right = unit(cross(&forward, &unit(up)));
    let down = cross(&forward, &right);
    let [r, d, f] = [right, down, forward].map(|axis| axis.map(from_f64_exact));
    let duals = [cross(&d, &f), cross(&f, &r), cross(&r, &d)];
    let volume: BigRational = (0..3).map(|k| &duals[0][k] * &r[k]).sum();
    duals.map(|dual| dual.map(|v| v / &volume))
}

pub(crate) fn cross<T: Sub<Output = T>>(u: &[T; 3], v: &[T; 3]) -> [T; 3]
where
    for<'a> &'a T: Mul<Output = T>,
{
    let part = |i: usize, j: usize| &u[i] * &v[j] - &u[j] * &v[i];
    [part(1, 2), part(2, 0), part(0, 1)]
}
