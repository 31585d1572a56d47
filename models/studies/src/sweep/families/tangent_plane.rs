//! A cut plane that becomes tangent to a sphere.
//!
//! The sphere's local origin is the point of contact and its unit 2^-20 pixels, so that the plane's distance from it is a short decimal.

use crate::sweep::grid::{decimal, orthographic, scene, solid};
use crate::sweep::{Axis, Step, Sweep};
use imogene_algebra::rational::{fraction, integer, power_of_two};
use imogene_golden::format::Format;
use imogene_scene::{Cut, Scale, SceneFile, Shape, Step as Place};
use num_traits::ToPrimitive;

/// Radius in pixels.
const RADIUS: i64 = 2048;
/// The root of f2, up to R, stays below 2^23.5 depth words.
const HALF_DEPTH: f64 = 1500.0;
/// Local units to the pixel, as a power of two.
const UNIT: u32 = 20;
/// Last exponent: the plane is 2^-29 pixels from being tangent.
const LAST: u32 = 40;

/// The sweep.
pub const SWEEP: Sweep = Sweep {
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
    has_own_formats: false,
    steps: all,
};

fn all(format: Format) -> Vec<Step> {
    let of = |series: usize| {
        (0..=LAST).step_by(2).map(move |k| Step {
            series,
            parameter: k.to_string(),
            scene: cut_ball(series, k),
            format: Ok(format),
            with_naive: false,
        })
    };
    (0..3).flat_map(of).collect()
}

fn cut_ball(series: usize, k: u32) -> SceneFile {
    let out = match series {
        2 => [fraction(3, 5), fraction(4, 5), integer(0)],
        _ => [fraction(3, 5), integer(0), fraction(4, 5)],
    };
    let local_radius = integer(RADIUS) * power_of_two(UNIT);
    let [g, h, i] = out.each_ref().map(|v| decimal(&(v * &local_radius)));
    let shape = Shape::Quadric {
        coefficients: [1.0, 1.0, 1.0, 0.0, 0.0, 0.0, g, h, i, 0.0],
    };
    // Towards the centre by R 2^-k.
    let depth = &local_radius / power_of_two(k);
    let normal = out
        .each_ref()
        .map(|v| if series == 0 { v.clone() } else { -v });
    let cuts = vec![Cut {
        point: out.each_ref().map(|v| decimal(&(-v * &depth))),
        normal: normal.each_ref().map(decimal),
    }];
    let mut ball = solid("ball", shape, cuts);
    let unit = power_of_two(UNIT).recip();
    ball.place = vec![Place::Scale(Scale::Uniform(
        unit.to_f64().expect("a power of two"),
    ))];
    scene("cut ball", orthographic(HALF_DEPTH), vec![ball])
}

#[cfg(test)]
mod tests {
    use super::*;
    use imogene_prepare::Framing;
    use imogene_scene::FramedObject;
    use num_rational::BigRational;

    /// The plane, in camera pixels, is where the sweep says it is.
    #[test]
    fn the_cap_is_as_thick_as_it_says() {
        for k in (0..=LAST).step_by(2) {
            let scene = cut_ball(0, k).frame(96, 72).expect("valid");
            let FramedObject::Quadric(ball) = &scene.objects[0] else {
                panic!("a quadric");
            };
            let plane = &ball.planes[0];
            // The point of contact is the origin.
            let beyond = plane.value_at(&integer(0), &integer(0), &integer(0));
            let square = [&plane.a, &plane.b, &plane.c].map(|v| v * v);
            let length = square.iter().sum::<BigRational>();
            let thickness = integer(RADIUS) / power_of_two(k);
            assert_eq!(
                &beyond * &beyond,
                &thickness * &thickness * length,
                "k = {k}"
            );
            assert!(beyond > integer(0));
        }
    }
}
