//! The eye approaches the surface of a sphere, and goes through it.
//!
//! The factor of z^2 is the quadric's value at the eye, over the square of the viewer distance. It vanishes on the
//! surface, and f1 and f2 with its inverse and the square of its inverse go out of every word.

use crate::sweep::grid::{decades, decimal, scene, solid, steps};
use crate::sweep::{Axis, Step, Sweep};
use imogene_algebra::rational::{fraction, integer};
use imogene_golden::format::Format;
use imogene_scene::{Camera, Node, SceneFile, Shape, Surface};
use num_rational::BigRational;
use num_traits::Zero;

const RADIUS: i64 = 50;

/// The sweep.
pub const SWEEP: Sweep = Sweep {
    name: "eye-distance",
    title: "The eye approaches the surface of a sphere",
    about: "A sphere of radius 50 is looked at from a distance of 100 down to a millionth, 0 being the surface itself; the near end of the depth is 5 units away. \
            A solid shows a flat cap once its front is nearer than that, a patch its far wall, from outside as from inside. \
            Distance to the surface enters the depth factors as its inverse, and f2 leaves its word soon after the front has passed the near end, which the preparation says; on the surface (0) there is no square root at all. \
            If the screen moves along (its distance equal to that of the surface, all lengths of the camera to scale) the same sphere only becomes larger on the screen.",
    axis: Axis::falling("distance of the eye from the surface (scene units)"),
    series: &[
        "solid from outside",
        "patch from outside",
        "patch from inside",
        "solid, the screen moves along",
    ],
    has_own_formats: false,
    steps: all,
};

fn all(format: Format) -> Vec<Step> {
    let mut values = vec!["100".to_owned()];
    values.extend(decades(&[7, 5, 4, 3, 2, 1], (0..=1).rev()));
    values.extend(decades(&[3, 1], (-6..=-1).rev()));
    values.push("0".into());
    let mut steps = steps(4, &values, format, ball);
    // From inside the eye cannot be farther from the surface than the middle; on the surface the screen has no
    // distance left.
    steps.retain(|step| {
        let value: f64 = step.parameter.parse().expect("a decimal");
        match step.series {
            2 => value < RADIUS as f64,
            3 => value > 0.0,
            _ => true,
        }
    });
    steps
}

fn ball(series: usize, distance: &BigRational) -> SceneFile {
    let from_middle = match series {
        2 => integer(RADIUS) - distance,
        _ => integer(RADIUS) + distance,
    };
    let screen = match series {
        3 if !distance.is_zero() => distance.clone(),
        _ => integer(10),
    };
    let camera = Camera::Perspective {
        eye: [0.0, 0.0, decimal(&from_middle)],
        target: [0.0, 0.0, -f64::from(RADIUS as i32)],
        up: [0.0, 1.0, 0.0],
        viewer_distance: decimal(&screen),
        view_height: decimal(&(&screen * fraction(3, 4))),
        near: Some(decimal(&(screen / integer(2)))),
        sample_at: [0.0; 2],
        node: Node::default(),
    };
    let shape = Shape::Sphere {
        radius: RADIUS as f64,
    };
    let mut ball = solid("ball", shape, vec![]);
    if matches!(series, 1 | 2) {
        ball.mode = Surface::Patch;
    }
    scene("ball", camera, vec![ball])
}
