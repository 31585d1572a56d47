//! A point of an object's inside, where a search would take long to find one.

use imogene_algebra::rational::to_f64;
use imogene_scene::{
    Cut, DepthRange, FloatCamera, Object, Rotation, Scale, SceneFile, Shape, Step, rotation_matrix,
};
use rayon::prelude::*;

/// For each object of a flat scene, a point in screen space that probably lies in it: pixels from the middle of the
/// screen, and of depth in a range; nothing where none is known, or an eye is needed and is not in front.
pub(super) fn witnesses(
    scene: &SceneFile,
    height: u32,
    range: &DepthRange,
) -> Vec<Option<[f64; 3]>> {
    let Ok(camera) = FloatCamera::of(&scene.camera, height) else {
        return vec![None; scene.objects.len()];
    };
    let of = |object: &Object| {
        let point = placed(object, inside(object)?);
        let [x, y, z] = camera.seen(point);
        Some(match &range.far {
            None if z <= 0.0 => return None,
            None => {
                let depth = camera.pixels * (1.0 - 2.0 * to_f64(&range.near) / z);
                [x / z * camera.pixels, y / z * camera.pixels, depth]
            }
            Some(_) => [x, y, z - range.distance(0.0)].map(|v| v * camera.pixels),
        })
    };
    scene.objects.par_iter().map(of).collect()
}

/// A point inside an object, in its own coordinates.
fn inside(object: &Object) -> Option<[f64; 3]> {
    match object.shape {
        Shape::Sphere { .. } | Shape::Ellipsoid { .. } => Some([0.0; 3]),
        Shape::EllipticCylinder { .. } => {
            let crossings = object.cuts.iter().filter_map(crossing);
            let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
            for (y, is_upper) in crossings {
                match is_upper {
                    true => high = high.min(y),
                    false => low = low.max(y),
                }
            }
            let y = match (low.is_finite(), high.is_finite()) {
                (true, true) => 0.5 * (low + high),
                (true, false) => low + 1.0,
                (false, true) => high - 1.0,
                (false, false) => 0.0,
            };
            Some([0.0, y, 0.0])
        }
        _ => None,
    }
}

/// Where the y axis crosses the plane of a cut, and whether the cut removes what is above.
fn crossing(Cut { point, normal }: &Cut) -> Option<(f64, bool)> {
    let along: f64 = (0..3).map(|k| point[k] * normal[k]).sum();
    (normal[1] != 0.0).then(|| (along / normal[1], normal[1] > 0.0))
}

pub(super) fn placed(object: &Object, point: [f64; 3]) -> [f64; 3] {
    object.place.iter().fold(point, |point, step| match step {
        Step::Translate(offset) => std::array::from_fn(|k| point[k] + offset[k]),
        Step::Rotate(rotation) => turned(rotation, point),
        Step::Scale(Scale::Uniform(factor)) => point.map(|v| v * factor),
        Step::Scale(Scale::PerAxis(factors)) => std::array::from_fn(|k| point[k] * factors[k]),
    })
}

fn turned(rotation: &Rotation, point: [f64; 3]) -> [f64; 3] {
    rotation_matrix(rotation).map(|row| (0..3).map(|k| row[k] * point[k]).sum())
}
