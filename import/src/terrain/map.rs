//! Where the nodes of a grid of heights are in the scene, and what it is seen by.

use super::TerrainOptions;
use super::grid::HeightGrid;
use crate::error::{Error, Result};
use crate::kit::material;
use imogene_algebra::rational::{fraction, from_decimal, integer, to_f64};
use imogene_algebra::vector::length;
use imogene_scene::{Camera, ImageSize, Light, SceneFile};
use num_rational::BigRational;

/// Colours of altitudes, lowest first, as on a map.
pub(super) const BANDS: [[f64; 3]; 7] = [
    [0.25, 0.45, 0.30],
    [0.40, 0.58, 0.32],
    [0.60, 0.68, 0.38],
    [0.78, 0.72, 0.46],
    [0.70, 0.56, 0.38],
    [0.58, 0.48, 0.42],
    [0.93, 0.94, 0.96],
];

pub(super) const IMAGE: ImageSize = ImageSize {
    width: 640,
    height: 480,
};

/// Height of the picture at the distance of the screen plane, in viewer distances.
pub(super) const VIEW: f64 = 0.8;

pub(super) struct Map<'a> {
    pub options: &'a TerrainOptions,
    pub step: [BigRational; 2],
    /// Scene coordinates of the first node: x and z.
    pub first: [BigRational; 2],
    pub heights: (f64, f64),
    pub eye: [f64; 3],
    pub target: [f64; 3],
    /// In scene units.
    pub viewer_distance: f64,
}

impl<'a> Map<'a> {
    pub fn new(grid: &HeightGrid, options: &'a TerrainOptions) -> Result<Map<'a>> {
        let factor = options.height_factor;
        let problem = "no node of the region has a height";
        let none = || Error::whole(problem, "choose another region");
        let (low, high) = grid.range().ok_or_else(none)?;
        let heights = match factor > 0.0 {
            true => (low * factor, high * factor),
            false => (high * factor, low * factor),
        };
        let step = grid.step.map(from_decimal);
        let nodes = [grid.columns, grid.rows];
        let first: [BigRational; 2] =
            std::array::from_fn(|k| -&step[k] * fraction(nodes[k] as i64 - 1, 2));
        let half = first.each_ref().map(|v| -to_f64(v));
        let extent = 2.0 * half[0].max(half[1]);
        let middle = 0.5 * (heights.0 + heights.1);
        let (above, behind) = (heights.1 + 0.3 * extent, half[1] + 0.45 * extent);
        let eye = options.eye.unwrap_or([0.0, short(above), short(behind)]);
        // The range of the depth begins at half the viewer distance unless more of it is needed.
        let outside = |value: f64, low: f64, high: f64| (low - value).max(value - high).max(0.0);
        let nearest = length([
            outside(eye[0], -half[0], half[0]),
            outside(eye[1], heights.0, heights.1),
            outside(eye[2], -half[1], half[1]),
        ]);
        Ok(Map {
            options,
            first,
            heights,
            eye,
            target: options.target.unwrap_or([0.0, short(middle), 0.0]),
            viewer_distance: short(nearest.clamp(extent / 200.0, extent / 8.0)),
            step,
        })
    }

    /// Scene coordinates (x, z) of a node.
    pub(super) fn place(&self, node: [usize; 2]) -> [BigRational; 2] {
        std::array::from_fn(|k| &self.first[k] + &self.step[k] * integer(node[k] as i64))
    }

    pub(super) fn empty_scene(&self) -> SceneFile {
        let material = |(index, colour): (usize, &[f64; 3])| {
            material(format!("altitude-{index}"), *colour, [0.25, 0.75, 0.0], 1)
        };
        let pose = [self.eye, self.target, [0.0, 1.0, 0.0]];
        let window = short(VIEW * self.viewer_distance);
        let camera = Camera::perspective(pose, self.viewer_distance, window);
        SceneFile {
            background: [0.62, 0.74, 0.88],
            ambient: [1.0; 3],
            image: IMAGE,
            lights: vec![Light::directional([-3.0, 3.0, 1.0], 1.0)],
            materials: BANDS.iter().enumerate().map(material).collect(),
            ..SceneFile::new(&self.options.title, camera)
        }
    }
}

/// The number rounded to three digits.
fn short(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}
