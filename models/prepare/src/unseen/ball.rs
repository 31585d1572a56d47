//! Balls of a scene in floating point, with margins that hold what rounding does.
//!
//! A ball that is framed exactly lies between two balls about the centre `c` found here in `f64`, of the radii
//! `r -+ spare`: every step of its placement and the change to the camera's axes moves a point by a few units in the
//! last place of the magnitudes that it adds, [`PLACE`] of which are allowed for, and rotations that are not exactly
//! orthogonal stretch it by as little, [`SHAPE`] of the radius.
//!
//! In perspective, on the ray `t (p, q, 1)` from the eye, with `K = |c|^2 - r^2`, the depth words of the two points of
//! a ball are `f1 -+ sqrt(f2)` with
//!
//! ```text
//! f1 = zmax - s (p x + q y + z)                                    s = 2 near zmax / K
//! f2 = s^2 (r^2 (1 + p^2 + q^2) - |(p, q, 1) x c|^2)
//! ```
//!
//! and with `p = x/z + a`, `q = y/z + b` the cross product is `z^2 (a^2 + b^2) + (a y - b x)^2`, in which nothing
//! cancels. The chord of a ray in the inner ball lies in that of the true one, and this in that of the outer one. So
//! `sqrt(f2)`, half the chord in depth words, of the true ball lies between those of the inner and the outer one.

use crate::witness::placed;
use imogene_scene::{FloatCamera, Object, Processor, Scale, Shape, Step, Surface};

/// Error of a placed point, as a part of the sum of the magnitudes on its way.
const PLACE: f64 = 1e-12;
/// Error of a radius, as a part of it; the evaluation of f2 in `f64` is off by less, too.
const SHAPE: f64 = 1e-9;

/// A ball in the camera's axes, from the eye or from the target, in scene units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ball {
    pub centre: [f64; 3],
    pub radius: f64,
    pub spare: f64,
}

impl Ball {
    /// The ball that an object is; nothing for any other, and for one whose rounding is not small beside it.
    pub fn of(object: &Object, camera: &FloatCamera) -> Option<Ball> {
        let Shape::Sphere { mut radius } = object.shape else {
            return None;
        };
        let is_plain = object.cuts.is_empty()
            && object.mode == Surface::Solid
            && object.drawn_by() == Some(Processor::Quadric);
        if !is_plain {
            return None;
        }
        let mut sum = 0.0;
        for step in &object.place {
            match step {
                Step::Translate(offset) => sum += size(offset),
                Step::Rotate(_) => {}
                Step::Scale(Scale::Uniform(factor)) => {
                    (sum, radius) = (sum * factor.abs(), radius * factor.abs());
                }
                Step::Scale(Scale::PerAxis(_)) => return None,
            }
        }
        let spare = PLACE * (sum + size(&camera.origin)) + SHAPE * radius;
        (spare < 1e-3 * radius).then(|| Ball {
            centre: camera.seen(placed(object, [0.0; 3])),
            radius,
            spare,
        })
    }

    /// Least and greatest distance along the view of the outer ball.
    pub fn along_view(&self) -> [f64; 2] {
        let reach = self.radius + self.spare;
        [self.centre[2] - reach, self.centre[2] + reach]
    }
}

fn size(v: &[f64; 3]) -> f64 {
    v.iter().map(|v| v.abs()).sum()
}
