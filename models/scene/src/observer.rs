//! Where a camera stands in the scene, and how its pictures follow from that.

use super::camera::Camera;
use super::error::SceneError;
use super::limits::check_up;
use super::transform::Transform;
use imogene_algebra::matrix::image;
use imogene_algebra::rational::{from_decimal, to_f64};
use imogene_algebra::vector::{cross, minus, normalised};
use num_rational::BigRational;

pub(super) struct Sight {
    pub eye: [BigRational; 3],
    pub target: [BigRational; 3],
    view: [f64; 3],
    pub up: [f64; 3],
}

impl Sight {
    pub fn of(camera: &Camera) -> Result<Sight, SceneError> {
        let place = &camera.node.place;
        let exact = [camera.eye, camera.target].map(|point| point.map(from_decimal));
        if place.is_empty() {
            let [eye, target] = exact;
            return Ok(Sight {
                eye,
                target,
                view: minus(camera.target, camera.eye),
                up: camera.up,
            });
        }
        let placed = Transform::placement(place);
        let [eye, target] = exact.map(|point| placed.point(&point));
        let view = minus(&target, &eye).map(|v| to_f64(&v));
        let up = placed.vector(&camera.up.map(from_decimal));
        let up = up.map(|v| to_f64(&v));
        let name = camera.node.name.as_deref().unwrap_or_default();
        check_up(&format!("camera `{name}`, up"), view, up)?;
        Ok(Sight {
            eye,
            target,
            view,
            up,
        })
    }

    /// Directions to the right, down and along the view.
    pub fn axes(&self) -> [[f64; 3]; 3] {
        let forward = normalised(self.view);
        let right = normalised(cross(forward, normalised(self.up)));
        [right, cross(forward, right), forward]
    }

    /// The frame with its origin at `origin`, z along the view, and `up` towards -y.
    pub fn frame(&self, origin: &[BigRational; 3], pixels_per_unit: &BigRational) -> Transform {
        let to_origin = Transform::translation(origin.each_ref().map(|value| -value));
        let turned = Transform::linear(self.axes()).after(&to_origin);
        Transform::scaling(std::array::from_fn(|_| pixels_per_unit.clone())).after(&turned)
    }
}

/// A camera in floating point: how pixels and distances follow from a point of the scene.
pub struct FloatCamera {
    /// The eye of a perspective camera, the target of an orthographic one.
    pub origin: [f64; 3],
    /// To the right, down and along the view; the framed scene takes these very numbers as exact.
    pub axes: [[f64; 3]; 3],
    /// Pixels for one scene unit: at a distance of one unit from the eye, or everywhere.
    pub pixels: f64,
    /// Where pixels are sampled: columns and lines from whole coordinates.
    pub sample_at: [f64; 2],
}

impl FloatCamera {
    /// A point of the scene from the origin, along the axes.
    pub fn seen(&self, point: [f64; 3]) -> [f64; 3] {
        image(&self.axes, &minus(point, self.origin))
    }

    /// The camera of a picture of so many lines.
    pub fn of(camera: &Camera, height: u32) -> Result<FloatCamera, SceneError> {
        let sight = Sight::of(camera)?;
        let (origin, pixels) = match camera.viewer_distance() {
            Some(distance) => (&sight.eye, distance / camera.view_height),
            None => (&sight.target, camera.view_height.recip()),
        };
        Ok(FloatCamera {
            origin: origin.each_ref().map(to_f64),
            axes: sight.axes(),
            pixels: pixels * f64::from(height),
            sample_at: camera.sample_at,
        })
    }
}
