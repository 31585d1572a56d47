//! The viewer from as near as it may stand to so far that the view is parallel.

use crate::sweep::grid::{BESIDE, cut, decades, perspective, scene, solid, steps};
use crate::sweep::{Axis, Step, Sweep};
use imogene_algebra::rational::to_f64;
use imogene_golden::format::Format;
use imogene_scene::{SceneFile, Shape, Step as Place};
use num_rational::BigRational;

/// The sweep.
pub const SWEEP: Sweep = Sweep {
    name: "viewer-distance",
    title: "The distance of the viewer",
    about: "A cut ball of radius 20 pixels in the screen plane, seen from its surface (20) to 10^11 pixels away. Nearer than 29 pixels f2 leaves its word. The depth word reaches to infinity whatever the distance, so a word is worth \
            D / 2^(W-1) pixels: errors in words stay, errors in pixels grow with the distance. Once a word is worth more than the ball is deep, f2 is a few last bits and the silhouette has no bound: \
            `imogene check` fails and says so, and the pixels are announced as undecided. A parallel view has no such limit and is the remedy.",
    axis: Axis::growing("distance of the viewer (pixels)"),
    series: &["whole ball", "cut ball"],
    has_own_formats: false,
    steps: all,
};

fn all(format: Format) -> Vec<Step> {
    let near = [
        "20", "20.0001", "20.01", "21", "25", "26", "27", "28", "29", "30", "40", "50",
    ];
    let mut values = near.map(String::from).to_vec();
    values.extend(decades(&[1], 2..=11));
    steps(2, &values, format, ball)
}

fn ball(series: usize, distance: &BigRational) -> SceneFile {
    let cuts = match series {
        0 => vec![],
        _ => vec![cut([5.0, 0.0, 10.0], [0.5, 0.25, 1.0])],
    };
    let shape = Shape::Sphere { radius: 20.0 };
    let mut ball = solid("ball", shape, cuts);
    ball.place = vec![Place::Translate(BESIDE)];
    scene("ball", perspective(to_f64(distance)), vec![ball])
}
