//! How large a pixel is where the objects are nearest.

use super::error::SceneError;
use super::file::{Camera, SceneFile};
use super::frame::Sight;
use super::look::ENDLESS;
use super::reach::Body;
use super::transform::dot;
use imogene_algebra::rational::to_f64;
use rayon::prelude::*;

impl SceneFile {
    /// Side of a pixel, in scene units, at the depth of the nearest point of all objects with an end; `lines` is the
    /// height of the picture. What is shorter than this is less than a pixel of the picture, wherever it is.
    ///
    /// An object that reaches behind a perspective eye makes it 0.
    ///
    /// # Errors
    ///
    /// If the camera would not be accepted.
    pub fn nearest_pixel(&self, lines: u32) -> Result<f64, SceneError> {
        let scene = self.flattened();
        let sight = Sight::of(&scene.camera)?;
        let eye = sight.eye.each_ref().map(to_f64);
        let between: [f64; 3] = std::array::from_fn(|k| eye[k] - to_f64(&sight.target[k]));
        let far = ENDLESS * dot(between, between).sqrt();
        let [_, _, forward] = sight.axes();
        let towards = forward.map(|v| -v);
        let reaches = scene.objects.par_iter().map(|object| {
            let reach = Body::of(object, eye, 10.0 * far).reach(towards);
            if reach < far {
                reach
            } else {
                f64::NEG_INFINITY
            }
        });
        let nearest = -reaches.reduce(|| f64::NEG_INFINITY, f64::max);
        Ok(match scene.camera {
            Camera::Perspective {
                view_height,
                viewer_distance,
                ..
            } => view_height / f64::from(lines) * nearest.max(0.0) / viewer_distance,
            Camera::Orthographic { view_height, .. } => view_height / f64::from(lines),
        })
    }
}
