//! A camera in floating point, for what need not be exact.

use super::error::SceneError;
use super::file::Camera;
use super::frame::Sight;
use imogene_algebra::rational::to_f64;

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
        let from: [f64; 3] = std::array::from_fn(|k| point[k] - self.origin[k]);
        self.axes
            .map(|axis| (0..3).map(|k| axis[k] * from[k]).sum())
    }

    /// The camera of a picture of so many lines.
    pub fn of(camera: &Camera, height: u32) -> Result<FloatCamera, SceneError> {
        let sight = Sight::of(camera)?;
        let (origin, pixels) = match camera {
            Camera::Perspective {
                viewer_distance,
                view_height,
                ..
            } => (&sight.eye, viewer_distance / view_height),
            Camera::Orthographic { view_height, .. } => (&sight.target, view_height.recip()),
        };
        Ok(FloatCamera {
            origin: origin.each_ref().map(to_f64),
            axes: sight.axes(),
            pixels: pixels * f64::from(height),
            sample_at: camera.sample_at(),
        })
    }
}
