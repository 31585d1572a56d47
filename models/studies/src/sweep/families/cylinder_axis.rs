//! A cylinder whose axis turns towards the line of sight.
//!
//! With t the tangent of the angle between axis and line of sight, the cylinder of radius R about the axis (t, 0, 1) is
//! `x^2 + (1 + t^2) y^2 + t^2 z^2 - 2 t x z - R^2 (1 + t^2)`: its factor of z^2 falls as t^2, the slope of f1 grows as 1 / t.

use crate::sweep::grid::{
    BESIDE, cut, decades, decimal, orthographic, perspective, scene, solid, steps,
};
use crate::sweep::{Axis, Step, Sweep};
use imogene_algebra::rational::integer;
use imogene_golden::format::Format;
use imogene_scene::{SceneFile, Shape, Step as Place};
use num_rational::BigRational;
use num_traits::Zero;

/// The sweep.
pub const SWEEP: Sweep = Sweep {
    name: "cylinder-axis",
    title: "The axis of a cylinder turns towards the line of sight",
    about: "A rod of radius 12 pixels and 40 pixels length is turned until it is seen end-on. The slope of f1 grows as the cotangent of the angle and f2 \
            as its square, so the silhouette stays exact and the depth error stays a few words until f2 leaves its word; how far that is, the range of \
            depth decides. Exactly along the ray (0) the rod is a prism and is drawn again. In perspective the viewer stands on the cylinder at 0.06, and f2 leaves its word on the way there.",
    axis: Axis::falling("tangent of the angle between axis and line of sight"),
    series: &[
        "orthographic, half depth 1000 px",
        "orthographic, half depth 100000 px",
        "perspective, viewer at 200 px",
    ],
    has_own_formats: false,
    steps: all,
};

fn all(format: Format) -> Vec<Step> {
    let mut values = vec!["1".to_owned()];
    values.extend(decades(&[7, 5, 3, 2, 1], (-6..=-1).rev()));
    values.push("0".into());
    steps(3, &values, format, rod)
}

fn rod(series: usize, tangent: &BigRational) -> SceneFile {
    let zero = BigRational::zero();
    let square = tangent * tangent;
    let length = &square + integer(1);
    let coefficients = [
        integer(1),
        length.clone(),
        square,
        zero.clone(),
        -tangent,
        zero.clone(),
        zero.clone(),
        zero.clone(),
        zero,
        -integer(144) * length,
    ];
    let shape = Shape::Quadric {
        coefficients: coefficients.each_ref().map(decimal),
    };
    let cuts = [20.0, -20.0].map(|z: f64| cut([0.0, 0.0, z], [0.0, 0.0, z.signum()]));
    let camera = match series {
        0 => orthographic(1e3),
        1 => orthographic(1e5),
        _ => perspective(200.0),
    };
    let mut rod = solid("rod", shape, cuts.to_vec());
    rod.place = vec![Place::Translate(BESIDE)];
    scene("rod", camera, vec![rod])
}
