//! Lines of sight of a framed scene, in floating point.

use super::frame::FramedScene;
use super::range::Projection;
use imogene_algebra::rational::to_f64;

type Vector = [f64; 3];

impl FramedScene {
    /// Where a pixel samples the screen plane of the camera frame, which is moved to where pixels are sampled.
    pub fn pixel_centre(&self, column: usize, line: usize) -> [f64; 2] {
        [
            column as f64 - 0.5 * f64::from(self.width),
            line as f64 - 0.5 * f64::from(self.height),
        ]
    }

    /// The normal in a frame at right angles, of one in the frame that is moved to where pixels are sampled.
    pub fn upright(&self, [x, y, z]: Vector) -> Vector {
        match &self.projection {
            Projection::Perspective { distance } => {
                let [u, v] = self.sample_at;
                [x, y, z - (u * x + v * y) / to_f64(distance)]
            }
            Projection::Orthographic { .. } => [x, y, z],
        }
    }
}

impl Projection {
    /// The point of the camera frame that a pixel shows at depth `z_p` (pixels).
    pub fn antecedent(&self, [x, y]: [f64; 2], depth: f64) -> Vector {
        match self {
            Projection::Perspective { distance } => {
                let d = to_f64(distance);
                let k = d / (d - depth);
                [x * k, y * k, depth * k]
            }
            Projection::Orthographic { .. } => [x, y, depth],
        }
    }

    /// Pixels of depth that fill the depth word.
    pub fn full_depth(&self) -> f64 {
        match self {
            Projection::Perspective { distance } => to_f64(distance),
            Projection::Orthographic { half_depth } => to_f64(half_depth),
        }
    }

    /// From a point towards the viewer, of any length.
    pub fn towards_viewer(&self, [x, y, z]: Vector) -> Vector {
        match self {
            Projection::Perspective { distance } => [-x, -y, -to_f64(distance) - z],
            Projection::Orthographic { .. } => [0.0, 0.0, -1.0],
        }
    }
}
