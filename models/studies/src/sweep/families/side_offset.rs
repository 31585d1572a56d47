//! A sphere moves off the optical axis until it leaves the screen.

use crate::sweep::grid::{SCREEN, cut, decimal, orthographic, perspective, scene, solid, steps};
use crate::sweep::{Axis, Step, Sweep};
use imogene_algebra::rational::fraction;
use imogene_golden::format::Format;
use imogene_scene::{ImageSize, SceneFile, Shape, Step as Place};
use num_rational::BigRational;

/// Columns: at 48 pixels from the viewer the last one is 76 degrees off the axis.
const WIDTH: u32 = 384;

/// The sweep.
pub const SWEEP: Sweep = Sweep {
    name: "side-offset",
    title: "A ball moves off the axis of the screen",
    about: "A cut ball of radius 16 pixels moves to the right edge of a screen of 384 columns and beyond it. In perspective it is drawn out to an ellipse, up to \
            the edge at 76 degrees off the axis. Coefficients are rounded about the middle of each object's own box, so that distance from the middle of \
            the screen costs nothing: errors follow the size of the box. Beyond the edge nothing is drawn, and the tool says so.",
    axis: Axis::linear("offset of the ball from the axis (pixels)"),
    series: &[
        "perspective, viewer at 48 px",
        "perspective, viewer at 400 px",
        "orthographic, half depth 64 px",
    ],
    has_own_formats: false,
    steps: all,
};

fn all(format: Format) -> Vec<Step> {
    let values = [
        "0", "40", "80", "120", "160", "180", "190", "200", "205", "210", "220", "230", "240",
        "260",
    ];
    steps(3, &values.map(String::from), format, ball)
}

fn ball(series: usize, offset: &BigRational) -> SceneFile {
    let camera = match series {
        0 => perspective(48.0),
        1 => perspective(400.0),
        _ => orthographic(64.0),
    };
    let cuts = vec![cut([0.0, 8.0, 0.0], [0.2, 1.0, 0.3])];
    let mut ball = solid("ball", Shape::Sphere { radius: 16.0 }, cuts);
    ball.place = vec![Place::Translate([
        decimal(&(offset + fraction(3, 10))),
        0.2,
        0.0,
    ])];
    let mut file = scene("ball", camera, vec![ball]);
    file.image = ImageSize {
        width: WIDTH,
        height: SCREEN.1,
    };
    file
}
