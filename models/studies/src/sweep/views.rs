//! Sweeps of the view: what is seen stays, and viewer, axis or place change.

use super::family::{Rule, Sweep};
use super::grid::{
    BESIDE, SCREEN, cut, decades, decimal, looking, moved, orthographic, perspective, scene, solid,
};
use super::record::Axis;
use imogene_algebra::rational::{fraction, integer, to_f64};
use imogene_scene::{SceneFile, Shape, Surface};
use num_rational::BigRational;
use num_traits::Zero;

/// With t the tangent of the angle between axis and line of sight, the cylinder of radius R about the axis (t, 0, 1) is
/// `x^2 + (1 + t^2) y^2 + t^2 z^2 - 2 t x z - R^2 (1 + t^2)`: its factor of z^2 falls as t^2, the slope of f1 grows as
/// 1 / t.
pub const CYLINDER_AXIS: Sweep = Sweep {
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
    values: || {
        let grid = decades(&[7, 5, 3, 2, 1], (-6..=-1).rev());
        [vec!["1".into()], grid, vec!["0".into()]].concat()
    },
    scene: rod,
    rule: Rule::Plain,
};

fn rod(series: usize, tangent: &BigRational) -> SceneFile {
    let square = tangent * tangent;
    let length = &square + integer(1);
    let radius = -integer(144) * &length;
    let [a, b, c, e, j] = [&integer(1), &length, &square, &-tangent, &radius].map(decimal);
    let coefficients = [a, b, c, 0.0, e, 0.0, 0.0, 0.0, 0.0, j];
    let shape = Shape::Quadric { coefficients };
    let cuts = [20.0, -20.0].map(|z: f64| cut([0.0, 0.0, z], [0.0, 0.0, z.signum()]));
    let camera = match series {
        0 => orthographic(1e3),
        1 => orthographic(1e5),
        _ => perspective(200.0),
    };
    let rod = moved("rod", shape, cuts.to_vec(), BESIDE);
    scene("rod", camera, vec![rod])
}

const RADIUS: i64 = 50;

/// The factor of z^2 is the quadric's value at the eye, over the square of the viewer distance. It vanishes on the
/// surface, and f1 and f2 with its inverse and the square of its inverse go out of every word.
///
/// From inside the eye cannot be farther from the surface than the middle; on the surface the screen has no distance
/// left.
pub const EYE_DISTANCE: Sweep = Sweep {
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
    values: || {
        let near = decades(&[7, 5, 4, 3, 2, 1], (0..=1).rev());
        let nearest = decades(&[3, 1], (-6..=-1).rev());
        [vec!["100".into()], near, nearest, vec!["0".into()]].concat()
    },
    scene: near_ball,
    rule: Rule::Only(|series, distance| match series {
        2 => distance < RADIUS as f64,
        3 => distance > 0.0,
        _ => true,
    }),
};

fn near_ball(series: usize, distance: &BigRational) -> SceneFile {
    let from_middle = match series {
        2 => integer(RADIUS) - distance,
        _ => integer(RADIUS) + distance,
    };
    let screen = match series {
        3 if !distance.is_zero() => distance.clone(),
        _ => integer(10),
    };
    let parts = [integer(1), fraction(3, 4), fraction(1, 2)];
    let [distance, height, near] = parts.map(|part| decimal(&(&screen * part)));
    let [eye, target] = [decimal(&from_middle), -(RADIUS as f64)].map(|z| [0.0, 0.0, z]);
    let camera = looking(eye, target, distance, height, near);
    let radius = RADIUS as f64;
    let mut ball = solid("ball", Shape::Sphere { radius }, vec![]);
    if matches!(series, 1 | 2) {
        ball.mode = Surface::Patch;
    }
    scene("ball", camera, vec![ball])
}

/// The whole world, viewer and object, moved away from the origin; by tenths too, which binary numbers do not hold.
pub const WORLD_OFFSET: Sweep = Sweep {
    name: "world-offset",
    title: "The whole world moves away from the origin",
    about: "Viewer and ellipsoid are moved together by the same decimal along x, -y and z. A pipeline in floating point that solves the quadric in scene coordinates \
            loses the picture (32 bits from an offset of a few thousand, 64 bits later), because the constant of the quadric grows with the square of the offset; \
            here the scene is moved to the viewer in exact fractions before a factor is rounded, and every word of the machine stays the same.",
    axis: Axis::growing("offset of viewer and object (pixels)"),
    series: &["perspective, viewer at 200 px"],
    values: || {
        let tenths = ["0", "0.1", "1.1"].map(String::from).to_vec();
        let more = (1..=9).map(|e| format!("{}.1", 10u64.pow(e))).collect();
        [tenths, more, decades(&[1], 10..=11)].concat()
    },
    scene: ellipsoid,
    rule: Rule::Naive,
};

fn ellipsoid(_series: usize, offset: &BigRational) -> SceneFile {
    let [x, y, z] = [offset, &-offset, offset].map(decimal);
    let eye = [x, y, decimal(&(offset + integer(200)))];
    let camera = looking(eye, [x, y, z], 200.0, f64::from(SCREEN.1), 100.0);
    let shape = Shape::Ellipsoid([30.0, 20.0, 25.0]);
    let aside = decimal(&(offset + fraction(5, 2)));
    let object = moved("ellipsoid", shape, vec![], [aside, y, z]);
    scene("ellipsoid", camera, vec![object])
}

/// Columns: at 48 pixels from the viewer the last one is 76 degrees off the axis.
const WIDTH: u32 = 384;

/// A sphere moves off the optical axis until it leaves the screen.
pub const SIDE_OFFSET: Sweep = Sweep {
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
    values: || {
        let values = [
            0, 40, 80, 120, 160, 180, 190, 200, 205, 210, 220, 230, 240, 260,
        ];
        values.map(|value| value.to_string()).to_vec()
    },
    scene: ball_aside,
    rule: Rule::Plain,
};

fn ball_aside(series: usize, offset: &BigRational) -> SceneFile {
    let camera = match series {
        0 => perspective(48.0),
        1 => perspective(400.0),
        _ => orthographic(64.0),
    };
    let cuts = vec![cut([0.0, 8.0, 0.0], [0.2, 1.0, 0.3])];
    let aside = decimal(&(offset + fraction(3, 10)));
    let by = [aside, 0.2, 0.0];
    let ball = moved("ball", Shape::Sphere { radius: 16.0 }, cuts, by);
    let mut scene = scene("ball", camera, vec![ball]);
    scene.image.width = WIDTH;
    scene
}

/// The viewer from as near as it may stand to so far that the view is parallel.
pub const VIEWER_DISTANCE: Sweep = Sweep {
    name: "viewer-distance",
    title: "The distance of the viewer",
    about: "A cut ball of radius 20 pixels in the screen plane, seen from its surface (20) to 10^11 pixels away. Nearer than 29 pixels f2 leaves its word. The depth word reaches to infinity whatever the distance, so a word is worth \
            D / 2^(W-1) pixels: errors in words stay, errors in pixels grow with the distance. Once a word is worth more than the ball is deep, f2 is a few last bits and the silhouette has no bound: \
            `imogene check` fails and says so, and the pixels are announced as undecided. A parallel view has no such limit and is the remedy.",
    axis: Axis::growing("distance of the viewer (pixels)"),
    series: &["whole ball", "cut ball"],
    values: || {
        let near = [
            "20", "20.0001", "20.01", "21", "25", "26", "27", "28", "29", "30", "40", "50",
        ];
        [near.map(String::from).to_vec(), decades(&[1], 2..=11)].concat()
    },
    scene: far_ball,
    rule: Rule::Plain,
};

fn far_ball(series: usize, distance: &BigRational) -> SceneFile {
    let cuts = match series {
        0 => vec![],
        _ => vec![cut([5.0, 0.0, 10.0], [0.5, 0.25, 1.0])],
    };
    let ball = moved("ball", Shape::Sphere { radius: 20.0 }, cuts, BESIDE);
    scene("ball", perspective(to_f64(distance)), vec![ball])
}
