//! The range of the depth word: which distances it tells apart.
//!
//! In perspective the depth word is of first degree in the inverse of the distance Z from the eye,
//! `w = z_max (1 - 2 near / Z)`: it is least at the near end and greatest at infinity. In an orthographic view it is
//! of first degree in the distance itself, between a near and a far end on both sides of the screen plane.

use super::camera::{Camera, Lens};
use imogene_algebra::rational::{fraction, from_decimal, integer, power_of_two, to_f64};
use num_rational::BigRational;
use serde::Serialize;

/// How the camera frame is projected on the screen plane z = 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Projection {
    /// From the eye (0, 0, -D).
    Perspective {
        /// D in pixels.
        distance: BigRational,
    },
    /// Along z.
    Orthographic {
        /// Depth in pixels covered on each side of the screen plane.
        half_depth: BigRational,
    },
}

impl Projection {
    /// The point of the camera frame that a pixel shows at depth `z_p` (pixels).
    pub fn antecedent(&self, [x, y]: [f64; 2], depth: f64) -> [f64; 3] {
        match self {
            Projection::Perspective { distance } => {
                let d = to_f64(distance);
                let k = d / (d - depth);
                [x * k, y * k, depth * k]
            }
            Projection::Orthographic { .. } => [x, y, depth],
        }
    }

    /// The depth in pixels that fills the depth word: the viewer distance, or the stated half depth.
    pub fn full(&self) -> &BigRational {
        let (Projection::Perspective { distance: full }
        | Projection::Orthographic { half_depth: full }) = self;
        full
    }

    /// The same as a number.
    pub fn full_depth(&self) -> f64 {
        to_f64(self.full())
    }

    /// From a point towards the viewer, of any length.
    pub fn towards_viewer(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        match self {
            Projection::Perspective { distance } => [-x, -y, -to_f64(distance) - z],
            Projection::Orthographic { .. } => [0.0, 0.0, -1.0],
        }
    }
}

/// What the depth word covers, in scene units along the view.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DepthRange {
    /// The near end: perspective from the eye, orthographic from the screen plane, negative towards the observer.
    pub near: BigRational,
    /// The far end in the same way; nothing for infinity, where every perspective range ends.
    pub far: Option<BigRational>,
    /// Who chose it.
    pub origin: RangeOrigin,
    /// Objects of which something on the screen may lie beyond an end, in their order.
    pub cut: Vec<CutOff>,
}

/// An object that an end of the depth cuts.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct CutOff {
    /// Its name.
    pub object: String,
    /// By which end.
    pub end: End,
}

/// An end of the depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum End {
    /// Towards the observer.
    Near,
    /// Away from the observer.
    Far,
}

/// Who chose a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RangeOrigin {
    /// The file names its ends.
    Hand,
    /// It is what the camera suggests: half of `viewer_distance`, or `half_depth` to both sides.
    Camera,
    /// The preparation chose it for the scene.
    Scene,
}

/// A range as reports state it: exact fractions, and the same as decimals.
#[derive(Clone, Debug, Serialize)]
pub struct RangeReport {
    /// The near end, exactly.
    pub near: String,
    /// The far end, exactly; nothing for infinity.
    pub far: Option<String>,
    /// The near end rounded.
    pub near_units: f64,
    /// The far end rounded.
    pub far_units: Option<f64>,
    /// Who chose it.
    pub origin: RangeOrigin,
    /// The distance, in scene units, of a depth word `w`: from the eye in perspective, from the screen plane in an
    /// orthographic view.
    pub distance: String,
    /// Objects that an end cuts.
    pub cut: Vec<CutOff>,
}

impl DepthRange {
    /// The range that a camera suggests, or names.
    pub fn of_camera(camera: &Camera) -> DepthRange {
        let (near, far, origin) = match camera.lens {
            Lens::Perspective {
                near: Some(near), ..
            } => (from_decimal(near), None, RangeOrigin::Hand),
            Lens::Perspective {
                viewer_distance: d, ..
            } => (from_decimal(d) / integer(2), None, RangeOrigin::Camera),
            Lens::Orthographic {
                ends: Some(ends), ..
            } => {
                let [near, far] = ends.map(from_decimal);
                (near, Some(far), RangeOrigin::Hand)
            }
            Lens::Orthographic { half_depth, .. } => {
                let half = from_decimal(half_depth.unwrap_or(camera.view_height));
                let origin = match half_depth {
                    Some(_) => RangeOrigin::Camera,
                    None => RangeOrigin::Scene,
                };
                (-half.clone(), Some(half), origin)
            }
        };
        DepthRange::of_ends(near, far, origin)
    }

    fn of_ends(near: BigRational, far: Option<BigRational>, origin: RangeOrigin) -> DepthRange {
        DepthRange {
            near,
            far,
            origin,
            cut: vec![],
        }
    }

    /// Writes its ends, rounded to numbers, into a camera.
    pub fn put_into(&self, camera: &mut Camera) {
        let begin = to_f64(&self.near);
        match &mut camera.lens {
            Lens::Perspective { near, .. } => *near = Some(begin),
            Lens::Orthographic { half_depth, ends } => {
                let far = self.far.as_ref().map(to_f64);
                (*half_depth, *ends) = (None, far.map(|far| [begin, far]));
            }
        }
    }

    /// The range of a scene that is given in pixels, not by a file: what fills the depth word of its projection.
    pub fn of_pixels(projection: &Projection) -> DepthRange {
        let (near, far) = match projection {
            Projection::Perspective { distance } => (distance / integer(2), None),
            Projection::Orthographic { half_depth } => (-half_depth, Some(half_depth.clone())),
        };
        DepthRange::of_ends(near, far, RangeOrigin::Hand)
    }

    /// The range with its ends moved by a power of two: the near end of a perspective view, both ends of an
    /// orthographic one.
    pub fn scaled(&self, exponent: i32) -> DepthRange {
        let power = power_of_two(exponent.unsigned_abs());
        let factor = if exponent < 0 { power.recip() } else { power };
        let origin = match (exponent, self.origin) {
            (0, origin) => origin,
            _ => RangeOrigin::Scene,
        };
        let far = self.far.as_ref().map(|far| far * &factor);
        DepthRange::of_ends(&self.near * &factor, far, origin)
    }

    /// Middle of an orthographic range, from the screen plane, and half its length.
    pub(super) fn middle_and_half(&self) -> [BigRational; 2] {
        let far = self.far.as_ref().unwrap_or(&self.near);
        [&self.near + far, far - &self.near].map(|twice| twice / integer(2))
    }

    /// The distance of a depth, given as a share of the greatest depth word: from the eye in perspective, from the
    /// screen plane in an orthographic view.
    pub fn distance(&self, share: f64) -> f64 {
        if self.far.is_none() {
            return 2.0 * to_f64(&self.near) / (1.0 - share);
        }
        let [middle, half] = self.middle_and_half().map(|v| to_f64(&v));
        middle + half * share
    }

    /// What a report says of the range, for depth words up to `z_max`.
    pub fn report(&self, z_max: i64) -> RangeReport {
        let distance = match &self.far {
            None => {
                let product = &self.near * integer(2) * integer(z_max);
                format!("({product}) / ({z_max} - w)")
            }
            Some(_) => {
                let [middle, half] = self.middle_and_half();
                format!("({middle}) + ({}) * w", half * fraction(1, z_max))
            }
        };
        RangeReport {
            near: self.near.to_string(),
            far: self.far.as_ref().map(BigRational::to_string),
            near_units: to_f64(&self.near),
            far_units: self.far.as_ref().map(to_f64),
            origin: self.origin,
            distance,
            cut: self.cut.clone(),
        }
    }
}
