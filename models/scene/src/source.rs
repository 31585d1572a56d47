//! Light sources as shadows and spots need them: exact, in the camera frame.

use super::light::{Aim, Beam, Light};
use super::quadric::{Plane, Quadric};
use super::transform::{Transform, sine_and_cosine};
use imogene_algebra::matrix::image;
use imogene_algebra::rational::{from_decimal, from_f64_exact, integer};
use imogene_algebra::vector::{dot, minus, square};
use num_rational::BigRational;

/// A light source, exactly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FramedSource {
    /// Homogeneous point (x, y, z, 1) of a source that stands somewhere, or (x, y, z, 0), the direction towards one
    /// that is infinitely far.
    pub point: [BigRational; 4],
    /// Whether objects in its way keep its light off others.
    pub shadows: bool,
    /// What a spot lights; other sources reach everything.
    pub cone: Option<SpotCone>,
}

/// The volume that a spot lights: one half of a cone, where `quadric <= 0` and `plane <= 0`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpotCone {
    /// The double cone.
    pub quadric: Quadric,
    /// The plane through the source that leaves the half in front of it.
    pub plane: Plane,
}

impl FramedSource {
    pub(super) fn new(light: &Light, camera: &Transform) -> FramedSource {
        FramedSource {
            point: homogeneous(light, camera),
            shadows: light.shadows,
            cone: spot_cone(light, camera),
        }
    }
}

/// The homogeneous point of a source in the frame of a camera.
pub(super) fn homogeneous(light: &Light, camera: &Transform) -> [BigRational; 4] {
    let to_camera = camera.after(&Transform::placement(&light.node.place));
    let ([x, y, z], w) = match &light.beam {
        Beam::Directional { from } => (to_camera.vector(&from.map(from_decimal)), 0),
        // Within its cone a spot is a point; the cone is a volume.
        Beam::Point { position } | Beam::Spot { position, .. } => {
            (to_camera.point(&position.map(from_decimal)), 1)
        }
    };
    [x, y, z, integer(w)]
}

fn spot_cone(light: &Light, camera: &Transform) -> Option<SpotCone> {
    let Beam::Spot {
        position,
        aim,
        half_angle,
    } = light.beam
    else {
        return None;
    };
    // The steps move the apex and the axis; about them the cone stays a right circular one, also under a scale.
    let placed = Transform::placement(&light.node.place);
    let apex = placed.point(&position.map(from_decimal));
    let axis = match aim {
        Aim::Towards(direction) => placed.vector(&direction.map(from_decimal)),
        Aim::Target(target) => minus(placed.point(&target.map(from_decimal)), &apex),
    };
    let quadric = cone_about(&apex, &axis, half_angle);
    // Kept on the side of the axis.
    let d = dot(&axis, &apex);
    let [a, b, c] = axis.map(|u| -u);
    let plane = Plane { a, b, c, d };
    Some(SpotCone {
        quadric: quadric.transformed(camera).primitive(),
        plane: plane.transformed(camera).primitive(),
    })
}

/// `cos^2 |axis|^2 |v|^2 - (axis . v)^2` with v from the apex: not positive within the angle of the axis, on both sides
/// of the apex. The one number that is not rational, cos^2, is computed once from `cos 2a`, which is exact at 45
/// degrees.
fn cone_about(apex: &[BigRational; 3], axis: &[BigRational; 3], degrees: f64) -> Quadric {
    let (_, cosine) = sine_and_cosine(2.0 * degrees);
    let equal = (integer(1) + from_f64_exact(cosine)) / integer(2) * square(axis);
    let entry = |row: usize, column: usize| {
        let product = &axis[row] * &axis[column];
        if row == column {
            &equal - product
        } else {
            -product
        }
    };
    let m = [0, 1, 2].map(|row| [0, 1, 2].map(|column| entry(row, column)));
    // About the origin the cone is v' M v; moved to the apex it is v' M v - 2 (M apex)' v + apex' M apex.
    let moved = image(&m, apex);
    let constant = dot(&moved, apex);
    let [g, h, i] = moved.map(|v| -v);
    let [[a, d, e], [_, b, f], [_, _, c]] = m;
    Quadric::from_array([a, b, c, d, e, f, g, h, i, constant])
}
