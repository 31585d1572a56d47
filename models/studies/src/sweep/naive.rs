//! What a pipeline in floating point makes of the same scene: ten coefficients in *scene* coordinates, one quadratic
//! equation for each line of sight.
//!
//! It is what a renderer does that neither moves the scene to the viewer first nor has exact numbers. The coefficients
//! are the exact ones rounded once, which is the best case.

use super::truth::{DEPTH_BITS, Truth};
use imogene_algebra::rational::{from_decimal, to_f64};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_prepare::Framing;
use imogene_scene::{Lens, Quadric, SceneFile, Transform};
use num_traits::Float;
use serde::Serialize;

/// Errors in both common precisions; the keys are stable.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Naive {
    /// In 32 bits.
    pub single: FloatError,
    /// In 64 bits.
    pub double: FloatError,
}

/// The error of a picture in floating point; the keys are stable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct FloatError {
    /// Pixels at which both pictures show the object.
    pub compared: usize,
    /// Greatest depth error there, in pixels of projected depth.
    pub depth_px: f64,
    /// Pixels that are covered in one picture alone.
    pub silhouette_pixels: usize,
}

/// Draws the first object of a scene as a whole quadric: one without cuts, seen in perspective along -z.
pub fn compare(file: &SceneFile) -> Naive {
    let Lens::Perspective {
        viewer_distance, ..
    } = file.camera.lens
    else {
        panic!("only perspective scenes are drawn in floating point");
    };
    let object = &file.objects[0];
    let quadric = Quadric::from_shape(&object.shape).expect("a quadric");
    let quadric = quadric.transformed(&Transform::placement(&object.place));
    let coefficients = quadric.coefficients().map(to_f64);
    Naive {
        single: error(file, viewer_distance, coefficients.map(|c| c as f32)),
        double: error(file, viewer_distance, coefficients),
    }
}

fn error<T: Float>(file: &SceneFile, viewer_distance: f64, quadric: [T; 10]) -> FloatError {
    let (width, height) = (file.image.width, file.image.height);
    let scene = file.frame(width, height).expect("sweeps are valid");
    let format = Format::BASE;
    let truth = Truth::new(&scene, format.z_max());
    // Scene units to the pixel in the screen plane.
    let unit = file.camera.view_height / f64::from(height);
    let distance = to_f64(&(from_decimal(viewer_distance) / from_decimal(unit)));
    let word = distance / format.z_max() as f64;
    let mut found = FloatError::default();
    for (x, y) in ScreenBox::of_screen(width, height).each() {
        let [px, py] = [2 * x - i64::from(width), i64::from(height) - 2 * y];
        let [px, py] = [px, py].map(|v| v as f64 / 2.0 * unit);
        let along = [px, py, -viewer_distance];
        let seen = first_depth(&quadric, file.camera.eye.map(cast), along.map(cast));
        match (seen, truth.at(x, y)) {
            (Some(parts), Some(exact)) => {
                let exact = exact.depth as f64 / (1u64 << DEPTH_BITS) as f64 * word;
                let off = (distance * parts - exact).abs();
                found.compared += 1;
                found.depth_px = found.depth_px.max(off);
            }
            (None, None) => {}
            _ => found.silhouette_pixels += 1,
        }
    }
    found
}

fn cast<T: Float>(value: f64) -> T {
    T::from(value).expect("a finite number")
}

/// Projected depth of the near root in viewer distances, all in the precision of the coefficients.
fn first_depth<T: Float>(quadric: &[T; 10], eye: [T; 3], along: [T; 3]) -> Option<f64> {
    let [a, b, c, d, e, f, g, h, i, j] = *quadric;
    let dot = |[x, y, z]: [T; 3], [u, v, w]: [T; 3]| x * u + y * v + z * w;
    // The matrix times a vector.
    let times = |v: [T; 3]| [[a, d, e], [d, b, f], [e, f, c]].map(|row| dot(row, v));
    let linear = [g, h, i];
    let square = dot(times(along), along);
    let mixed = dot(times(eye), along) + dot(linear, along);
    let constant = dot(times(eye), eye) + cast::<T>(2.0) * dot(linear, eye) + j;
    let discriminant = mixed * mixed - square * constant;
    if discriminant < T::zero() {
        return None;
    }
    let t = (-mixed - discriminant.sqrt()) / square;
    (t > T::zero()).then(|| (T::one() - T::one() / t).to_f64().expect("a float"))
}
