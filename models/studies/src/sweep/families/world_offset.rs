//! The whole world, viewer and object, moved away from the origin.

use crate::sweep::grid::{SCREEN, decades, decimal, scene, solid, steps};
use crate::sweep::{Axis, Step, Sweep};
use imogene_algebra::rational::{fraction, integer};
use imogene_golden::format::Format;
use imogene_scene::{Camera, Node, SceneFile, Shape, Step as Place};
use num_rational::BigRational;

/// The sweep.
pub const SWEEP: Sweep = Sweep {
    name: "world-offset",
    title: "The whole world moves away from the origin",
    about: "Viewer and ellipsoid are moved together by the same decimal along x, -y and z. A pipeline in floating point that solves the quadric in scene coordinates \
            loses the picture (32 bits from an offset of a few thousand, 64 bits later), because the constant of the quadric grows with the square of the offset; \
            here the scene is moved to the viewer in exact fractions before a factor is rounded, and every word of the machine stays the same.",
    axis: Axis::growing("offset of viewer and object (pixels)"),
    series: &["perspective, viewer at 200 px"],
    has_own_formats: false,
    steps: all,
};

fn all(format: Format) -> Vec<Step> {
    let mut values = vec!["0".to_owned()];
    // Tenths, which binary numbers do not hold.
    values.extend(["0.1", "1.1"].map(String::from));
    values.extend((1..=9).map(|e| format!("{}.1", 10u64.pow(e))));
    values.extend(decades(&[1], 10..=11));
    let mut steps = steps(1, &values, format, ellipsoid);
    for step in &mut steps {
        step.with_naive = true;
    }
    steps
}

fn ellipsoid(_series: usize, offset: &BigRational) -> SceneFile {
    let place = [offset.clone(), -offset, offset.clone()];
    let middle = place.each_ref().map(decimal);
    let eye = place[2].clone() + integer(200);
    let camera = Camera::Perspective {
        eye: [middle[0], middle[1], decimal(&eye)],
        target: middle,
        up: [0.0, 1.0, 0.0],
        viewer_distance: 200.0,
        view_height: f64::from(SCREEN.1),
        near: Some(100.0),
        sample_at: [0.0; 2],
        node: Node::default(),
    };
    let shape = Shape::Ellipsoid {
        radii: [30.0, 20.0, 25.0],
    };
    let mut object = solid("ellipsoid", shape, vec![]);
    let aside = &place[0] + fraction(5, 2);
    object.place = vec![Place::Translate([decimal(&aside), middle[1], middle[2]])];
    scene("ellipsoid", camera, vec![object])
}
