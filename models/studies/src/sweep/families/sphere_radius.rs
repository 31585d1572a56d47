//! A sphere from a tenth of a pixel to ten thousand pixels.

use crate::sweep::grid::{decades, decimal, orthographic, perspective, scene, solid, steps};
use crate::sweep::{Axis, Step, Sweep};
use imogene_algebra::rational::{fraction, integer, to_f64};
use imogene_golden::format::Format;
use imogene_scene::{SceneFile, Shape, Step as Place};
use num_rational::BigRational;
use num_traits::Zero;

/// The sweep.
pub const SWEEP: Sweep = Sweep {
    name: "sphere-radius",
    title: "The radius of a sphere",
    about: "From a tenth of a pixel, where one pixel centre or none is covered, to ten thousand pixels; from 20 pixels on the limb is kept on the screen, 20 pixels right of \
            its middle. The rounding errors of f1 and f2 depend on the box on the screen, not on the radius, so that the depth error stays put once \
            the box is the whole screen; the root of the error of f2 is largest at the limb, where f2 is small.",
    axis: Axis::growing("radius (pixels)"),
    series: &[
        "orthographic, half depth 1500 px",
        "perspective, viewer at 3000 px",
    ],
    has_own_formats: false,
    steps: all,
};

fn all(format: Format) -> Vec<Step> {
    let mut values = decades(&[1, 2, 5], -1..=3);
    values.push("10000".into());
    steps(2, &values, format, ball)
}

fn ball(series: usize, radius: &BigRational) -> SceneFile {
    let camera = match series {
        0 => orthographic(1500.0),
        _ => perspective(3000.0),
    };
    let shape = Shape::Sphere {
        radius: to_f64(radius),
    };
    let middle = (integer(20) - radius).min(BigRational::zero()) + fraction(1, 20);
    let mut ball = solid("ball", shape, vec![]);
    ball.place = vec![Place::Translate([decimal(&middle), 0.03, 0.0])];
    scene("ball", camera, vec![ball])
}
