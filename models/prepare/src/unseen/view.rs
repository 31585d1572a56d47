//! How pixels and depth words follow from a camera and a range of the depth.

use super::ball::Ball;
use imogene_golden::object::quadric::ScreenBox;
use imogene_scene::FloatCamera;

/// How depth words follow from the camera's distances.
pub(crate) struct View<'a> {
    pub camera: &'a FloatCamera,
    pub width: u32,
    pub height: u32,
    pub depth: DepthWord,
    pub z_max: f64,
}

/// A depth word of a distance along the view.
#[derive(Clone, Copy)]
pub(crate) enum DepthWord {
    /// `zmax (1 - 2 near / distance)`.
    Perspective { near: f64 },
    /// `zmax (distance - middle) / half`.
    Orthographic { middle: f64, half: f64 },
}

impl View<'_> {
    pub fn is_perspective(&self) -> bool {
        matches!(self.depth, DepthWord::Perspective { .. })
    }

    /// Does a ball lie wholly behind the viewer, if there is any.
    pub fn is_behind(&self, ball: &Ball) -> bool {
        self.is_perspective() && ball.along_view()[1] < 0.0
    }

    /// The depth in pixels that fills the word.
    pub fn full_depth(&self) -> f64 {
        match self.depth {
            DepthWord::Perspective { .. } => self.camera.pixels,
            DepthWord::Orthographic { half, .. } => half * self.camera.pixels,
        }
    }

    /// Depth words of one pixel of depth.
    pub fn words_per_pixel(&self) -> f64 {
        self.z_max / self.full_depth()
    }

    /// The depth in pixels of a distance along the view.
    pub fn depth_in_pixels(&self, distance: f64) -> f64 {
        match self.depth {
            DepthWord::Perspective { near, .. } => {
                self.full_depth() * (1.0 - 2.0 * near / distance)
            }
            DepthWord::Orthographic { middle, .. } => (distance - middle) * self.camera.pixels,
        }
    }

    /// Pixel columns and lines of the screen's middle.
    pub fn middle(&self) -> [f64; 2] {
        let half = [self.width, self.height].map(|n| 0.5 * f64::from(n));
        std::array::from_fn(|k| half[k] - self.camera.sample_at[k])
    }

    /// Most columns and lines from the middle to a pixel.
    pub fn farthest(&self) -> [f64; 2] {
        let last = [self.width, self.height].map(|n| f64::from(n) - 1.0);
        let middle = self.middle();
        std::array::from_fn(|k| middle[k].max(last[k] - middle[k]))
    }
    pub fn screen(&self) -> ScreenBox {
        ScreenBox::of_screen(self.width, self.height)
    }
}
