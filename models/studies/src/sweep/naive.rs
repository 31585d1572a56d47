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

/// The observer of a perspective scene that looks along -z.
struct Viewer {
    eye: [f64; 3],
    distance: f64,
    /// Scene units to the pixel in the screen plane.
    unit: f64,
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
    let viewer = Viewer {
        eye: file.camera.eye,
        distance: viewer_distance,
        unit: file.camera.view_height / f64::from(file.image.height),
    };
    Naive {
        single: error(file, &viewer, coefficients.map(|c| c as f32)),
        double: error(file, &viewer, coefficients),
    }
}

fn error<T: Float>(file: &SceneFile, viewer: &Viewer, quadric: [T; 10]) -> FloatError {
    let (width, height) = (file.image.width, file.image.height);
    let scene = file.frame(width, height).expect("sweeps are valid");
    let format = Format::BASE;
    let truth = Truth::new(&scene, format.z_max());
    let distance = to_f64(&(from_decimal(viewer.distance) / from_decimal(viewer.unit)));
    let word = distance / format.z_max() as f64;
    let mut found = FloatError::default();
    for (x, y) in ScreenBox::of_screen(width, height).each() {
        let place = [2 * x - i64::from(width), i64::from(height) - 2 * y].map(|v| v as f64 / 2.0);
        let seen = first_depth(&quadric, viewer, place);
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

/// Projected depth of the near root in viewer distances, all in the precision of the coefficients.
fn first_depth<T: Float>(quadric: &[T; 10], viewer: &Viewer, place: [f64; 2]) -> Option<f64> {
    let cast = |value: f64| T::from(value).expect("a finite number");
    let eye = viewer.eye.map(cast);
    let [px, py] = place.map(|p| cast(p * viewer.unit));
    let along = [px, py, cast(-viewer.distance)];
    let two = cast(2.0);
    let [a, b, c, d, e, f, g, h, i, j] = *quadric;
    // Rows of the matrix times a vector.
    let times = |[x, y, z]: [T; 3]| {
        [
            a * x + d * y + e * z,
            d * x + b * y + f * z,
            e * x + f * y + c * z,
        ]
    };
    let dot = |[x, y, z]: [T; 3], [u, v, w]: [T; 3]| x * u + y * v + z * w;
    let linear = [g, h, i];
    let square = dot(times(along), along);
    let mixed = dot(times(eye), along) + dot(linear, along);
    let constant = dot(times(eye), eye) + two * dot(linear, eye) + j;
    let discriminant = mixed * mixed - square * constant;
    if discriminant < T::zero() {
        return None;
    }
    let t = (-mixed - discriminant.sqrt()) / square;
    (t > T::zero()).then(|| (T::one() - T::one() / t).to_f64().expect("a float"))
}
