//! Sweeps of the shape: radius, planes, thickness, and the words that it is drawn in.

use super::family::{Rule, Sweep};
use super::grid::{BESIDE, cut, decades, decimal, moved, orthographic, perspective, scene, solid};
use super::record::Axis;
use crate::kit::words::widest;
use imogene_algebra::rational::{fraction, from_decimal, integer, power_of_two, to_f64};
use imogene_golden::format::Format;
use imogene_scene::{Axis as Turn, Cut, Rotation, Scale, SceneFile, Shape, Step as Place};
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

/// A cut plane that turns until it holds the eye.
pub const STEEP_PLANE: Sweep = Sweep {
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
    values: || [decades(&[1], (-9..=0).rev()), vec!["0".into()]].concat(),
    scene: cut_ball,
    rule: Rule::Plain,
};

fn cut_ball(series: usize, inclination: &BigRational) -> SceneFile {
    let edge = fraction([20, 21][series % 2], 4);
    // Seen from (0, 0, 100) a plane through (e, 0, 0) with the normal (100, 0, s) holds the eye at s = e.
    let (camera, radius, slope) = match series {
        0 | 1 => (perspective(100.0), 30.0, inclination * integer(100) + &edge),
        _ => (orthographic(3000.0), 2000.0, inclination * integer(100)),
    };
    // The limb of the large ball crosses the screen.
    let middle = [f64::min(0.3, 30.3 - radius), 0.2, 0.0];
    let through = decimal(&(edge - from_decimal(middle[0])));
    let cuts = vec![cut([through, 0.0, 0.0], [100.0, 0.0, decimal(&slope)])];
    let ball = moved("ball", Shape::Sphere { radius }, cuts, middle);
    scene("cut ball", camera, vec![ball])
}

/// A sphere from a tenth of a pixel to ten thousand pixels.
pub const SPHERE_RADIUS: Sweep = Sweep {
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
    values: || [decades(&[1, 2, 5], -1..=3), vec!["10000".into()]].concat(),
    scene: large_ball,
    rule: Rule::Plain,
};

fn large_ball(series: usize, radius: &BigRational) -> SceneFile {
    let camera = match series {
        0 => orthographic(1500.0),
        _ => perspective(3000.0),
    };
    let middle = (integer(20) - radius).min(BigRational::zero()) + fraction(1, 20);
    let radius = to_f64(radius);
    let by = [decimal(&middle), 0.03, 0.0];
    let ball = moved("ball", Shape::Sphere { radius }, vec![], by);
    scene("ball", camera, vec![ball])
}

const RADIUS: i64 = 2048;
/// The root of f2, up to R, stays below 2^23.5 depth words.
const HALF_DEPTH: f64 = 1500.0;
/// Local units to the pixel, as a power of two.
const UNIT: u32 = 20;
/// Last exponent: the plane is 2^-29 pixels from being tangent.
const LAST: u32 = 40;

/// A cut plane that becomes tangent to a sphere. The sphere's local origin is the point of contact and its unit 2^-20
/// pixels, so that the plane's distance from it is a short decimal.
pub const TANGENT_PLANE: Sweep = Sweep {
    name: "tangent-plane",
    title: "A cut plane becomes tangent to a sphere",
    about: "A plane cuts a ball of radius R = 2048 pixels at a distance of R (1 - 2^-k) from its centre; the point of contact is on a pixel centre and a depth word is 2^-12.5 pixels. The flat face shrinks with the root of 2^-k: \
            it is two pixels wide and about a depth word high at k = 23, so that the two limits are met together. As the depths of plane and ball come closer, which of the two is seen is announced as undecided at more pixels, \
            and in the end at the one that is left; the depth stays right, because both faces are. Seen edge-on the cap is a sliver at the limb, a pixel wide at k = 11.",
    axis: Axis::linear("k; the plane is at R (1 - 2^-k) from the centre"),
    series: &[
        "cap removed, seen at an angle",
        "cap kept, seen at an angle",
        "cap kept, seen edge-on",
    ],
    values: || (0..=LAST).step_by(2).map(|k| k.to_string()).collect(),
    scene: cap,
    rule: Rule::Plain,
};

fn cap(series: usize, k: &BigRational) -> SceneFile {
    let out = match series {
        2 => [fraction(3, 5), fraction(4, 5), integer(0)],
        _ => [fraction(3, 5), integer(0), fraction(4, 5)],
    };
    let local_radius = integer(RADIUS) * power_of_two(UNIT);
    let [g, h, i] = out.each_ref().map(|v| decimal(&(v * &local_radius)));
    let coefficients = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0, g, h, i, 0.0];
    let shape = Shape::Quadric { coefficients };
    // Towards the centre by R 2^-k.
    let depth = &local_radius / power_of_two(k.to_u32().expect("an exponent"));
    let sign = integer(if series == 0 { 1 } else { -1 });
    let cuts = vec![Cut {
        point: out.each_ref().map(|v| decimal(&(-v * &depth))),
        normal: out.each_ref().map(|v| decimal(&(v * &sign))),
    }];
    let mut ball = solid("ball", shape, cuts);
    let unit = power_of_two(UNIT).recip().to_f64();
    ball.place = vec![Place::Scale(Scale::Uniform(unit.expect("a power of two")))];
    scene("cut ball", orthographic(HALF_DEPTH), vec![ball])
}

const ACROSS: [(i64, i64); 3] = [(3, 5), (0, 1), (4, 5)];

/// Solids that become thinner than a depth word.
pub const THIN: Sweep = Sweep {
    name: "thin",
    title: "Solids thinner than a depth word",
    about: "The slab between two parallel planes, the lune that one of two equal balls shows beside the other, and a lens-shaped leaf, each down to a ten-millionth of a pixel; a depth word is \
            7.6 * 10^-6 pixels. Below the errors of the two depths that are compared, which face or object is seen is open, and every pixel of it is announced as undecided. The leaf has \
            f2 within its rounding error everywhere: its silhouette has no bound, and `imogene check` fails before a picture is drawn.",
    axis: Axis::falling("thickness (pixels)"),
    series: &["slab of two planes", "lune of two balls", "leaf"],
    values: || [vec!["10".into()], decades(&[4, 1], (-7..=0).rev())].concat(),
    scene: thin_solid,
    rule: Rule::Plain,
};

fn thin_solid(series: usize, thickness: &BigRational) -> SceneFile {
    // The points at half the thickness to both sides of the middle.
    let [front, back] =
        [1, -1].map(|half| ACROSS.map(|(n, d)| decimal(&(fraction(half * n, 2 * d) * thickness))));
    let ball = Shape::Sphere { radius: 30.0 };
    let mut objects = match series {
        0 => {
            let cuts = vec![cut(front, [0.6, 0.0, 0.8]), cut(back, [-0.6, 0.0, -0.8])];
            vec![solid("slab", ball, cuts)]
        }
        1 => vec![
            moved("back", ball.clone(), vec![], back),
            moved("front", ball, vec![], front),
        ],
        _ => {
            let half = decimal(&(thickness * fraction(1, 2)));
            vec![solid("leaf", Shape::Ellipsoid([30.0, 30.0, half]), vec![])]
        }
    };
    for object in &mut objects {
        object.place.push(Place::Translate(BESIDE));
    }
    scene("thin", orthographic(64.0), objects)
}

const GUARDS: [(u32, u32); 4] = [(0, 0), (2, 4), (4, 8), (8, 16)];

/// One scene in every depth word and with guard bits.
pub const WORD_LENGTH: Sweep = Sweep {
    name: "word-length",
    title: "Depth word and guard bits",
    about: "A cut ball pierced by a rod, in every depth word from 12 to 32 bits and with four choices of guard bits. Errors in words do not depend on the word, so that each bit halves the depth \
            error in pixels and quarters the displacement of the silhouette; guard bits take away what the coefficients lose, down to the floors of root and depth, and then the cut planes, which have none, are the \
            worst faces. Normals have words of their own and stop improving at their 16 bits. Formats whose accumulators would be wider than 64 bits are refused.",
    axis: Axis::linear("depth word (bits)"),
    series: &[
        "no guard bits",
        "guard bits 2:4",
        "guard bits 4:8",
        "guard bits 8:16",
    ],
    values: || (12..=32).map(|depth| depth.to_string()).collect(),
    scene: pierced_ball,
    rule: Rule::Formats(guarded),
};

fn guarded(series: usize, depth: u32) -> Result<Format, String> {
    let widths = widest(depth, 16, GUARDS[series], 0);
    Format::fitted(&widths).map_err(|error| error.to_string())
}

fn pierced_ball(_series: usize, _depth: &BigRational) -> SceneFile {
    let cuts = vec![cut([6.0, 0.0, 12.0], [0.5, 0.25, 1.0])];
    let ball = moved("ball", Shape::Sphere { radius: 24.0 }, cuts, BESIDE);
    let ends = [(-40.0, -1.0), (0.0, 1.0)].map(|(y, out)| cut([0.0, y, 0.0], [0.0, out, 0.0]));
    let shape = Shape::EllipticCylinder([7.0, 5.0]);
    let mut rod = solid("rod", shape, ends.to_vec());
    let (axis, degrees) = (Turn::Z, 60.0);
    let turn = Place::Rotate(Rotation { axis, degrees });
    rod.place = vec![turn, Place::Translate([-30.0, 20.0, 8.0])];
    scene("pierced ball", perspective(200.0), vec![ball, rod])
}
