//! A cut plane that turns until it holds the eye.

use crate::sweep::grid::{cut, decades, decimal, orthographic, perspective, scene, solid, steps};
use crate::sweep::{Axis, Step, Sweep};
use imogene_algebra::rational::{fraction, from_decimal, integer};
use imogene_golden::format::Format;
use imogene_scene::{SceneFile, Shape, Step as Place};
use num_rational::BigRational;

/// The sweep.
pub const SWEEP: Sweep = Sweep {
    name: "steep-plane",
    title: "A cut plane turns perpendicular to the screen",
    about: "The plane that cuts a ball turns about a line of the screen plane until it holds the eye (0). Its depth has the inverse of the inclination as slope: \
            when that leaves the plane word, the plane is loaded as a half-plane if both forms are proven equal at every pixel, and refused if they are not. \
            The error of a depth does not grow on the way, since the slope is rounded to the same last bit whatever its size. \
            Where the edge passes through pixel centres, the sign of such a pixel hangs on the inclination itself, and there is a range in which neither form will do; between pixel centres there is none.",
    axis: Axis::falling("inclination of the plane to the line of sight (tangent)"),
    series: &[
        "perspective, ball of 30 px, through pixel centres",
        "perspective, ball of 30 px, between pixel centres",
        "orthographic, ball of 2000 px, through pixel centres",
        "orthographic, ball of 2000 px, between pixel centres",
    ],
    has_own_formats: false,
    steps: all,
};

fn all(format: Format) -> Vec<Step> {
    let mut values = decades(&[1], (-9..=0).rev());
    values.push("0".into());
    steps(4, &values, format, cut_ball)
}

fn cut_ball(series: usize, inclination: &BigRational) -> SceneFile {
    let edge = fraction([20, 21][series % 2], 4);
    // Seen from (0, 0, 100) a plane through (e, 0, 0) with the normal (100, 0, s) holds the eye at s = e.
    let (camera, radius, slope) = match series {
        0 | 1 => (perspective(100.0), 30.0, inclination * integer(100) + &edge),
        _ => (orthographic(3000.0), 2000.0, inclination * integer(100)),
    };
    // The limb of the large ball crosses the screen.
    let middle = [f64::min(0.3, 30.3 - radius), 0.2, 0.0];
    let through = edge - from_decimal(middle[0]);
    let cuts = vec![cut(
        [decimal(&through), 0.0, 0.0],
        [100.0, 0.0, decimal(&slope)],
    )];
    let mut ball = solid("ball", Shape::Sphere { radius }, cuts);
    ball.place = vec![Place::Translate(middle)];
    scene("cut ball", camera, vec![ball])
}
