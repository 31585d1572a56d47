//! Solids that become thinner than a depth word.

use crate::sweep::grid::{BESIDE, cut, decades, decimal, orthographic, scene, solid, steps};
use crate::sweep::{Axis, Step, Sweep};
use imogene_algebra::rational::fraction;
use imogene_golden::format::Format;
use imogene_scene::{Object, SceneFile, Shape, Step as Place};
use num_rational::BigRational;

/// Direction of the thickness, a unit vector in decimals.
const ACROSS: [(i64, i64); 3] = [(3, 5), (0, 1), (4, 5)];

/// The sweep.
pub const SWEEP: Sweep = Sweep {
    name: "thin",
    title: "Solids thinner than a depth word",
    about: "The slab between two parallel planes, the lune that one of two equal balls shows beside the other, and a lens-shaped leaf, each down to a ten-millionth of a pixel; a depth word is \
            7.6 * 10^-6 pixels. Below the errors of the two depths that are compared, which face or object is seen is open, and every pixel of it is announced as undecided. The leaf has \
            f2 within its rounding error everywhere: its silhouette has no bound, and `imogene check` fails before a picture is drawn.",
    axis: Axis::falling("thickness (pixels)"),
    series: &["slab of two planes", "lune of two balls", "leaf"],
    has_own_formats: false,
    steps: all,
};

fn all(format: Format) -> Vec<Step> {
    let mut values = vec!["10".to_owned()];
    values.extend(decades(&[4, 1], (-7..=0).rev()));
    steps(3, &values, format, solid_of)
}

fn solid_of(series: usize, thickness: &BigRational) -> SceneFile {
    let mut objects = match series {
        0 => slab(thickness),
        1 => lune(thickness),
        _ => leaf(thickness),
    };
    for object in &mut objects {
        object.place.push(Place::Translate(BESIDE));
    }
    scene("thin", orthographic(64.0), objects)
}

/// The point at so much of the thickness from the middle.
fn across(thickness: &BigRational, share: BigRational) -> [f64; 3] {
    ACROSS.map(|(n, d)| decimal(&(fraction(n, d) * thickness * &share)))
}

fn slab(thickness: &BigRational) -> Vec<Object> {
    let normal = [0.6, 0.0, 0.8];
    let cuts = vec![
        cut(across(thickness, fraction(1, 2)), normal),
        cut(
            across(thickness, fraction(-1, 2)),
            normal.map(|v: f64| if v == 0.0 { v } else { -v }),
        ),
    ];
    vec![solid("slab", Shape::Sphere { radius: 30.0 }, cuts)]
}

fn lune(thickness: &BigRational) -> Vec<Object> {
    let ball = |name, share| {
        let mut ball = solid(name, Shape::Sphere { radius: 30.0 }, vec![]);
        ball.place = vec![Place::Translate(across(thickness, share))];
        ball
    };
    vec![ball("back", fraction(-1, 2)), ball("front", fraction(1, 2))]
}

fn leaf(thickness: &BigRational) -> Vec<Object> {
    let half = decimal(&(thickness * fraction(1, 2)));
    let shape = Shape::Ellipsoid {
        radii: [30.0, 30.0, half],
    };
    vec![solid("leaf", shape, vec![])]
}
