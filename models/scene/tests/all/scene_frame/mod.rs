//! The change from scene to camera frame is exact.

mod collection;
mod transforms;

use imogene_algebra::rational::{fraction, from_decimal, integer};
use imogene_prepare::Framing;
use imogene_scene::*;
use imogene_testkit::{parallel, perspective, plane, whole_quadric};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

type Point = [BigRational; 3];

fn point(x: f64, y: f64, z: f64) -> Point {
    [x, y, z].map(from_decimal)
}

fn value(quadric: &Quadric, [x, y, z]: &Point) -> BigRational {
    quadric.value_at(x, y, z)
}

fn side(plane: &Plane, [x, y, z]: &Point) -> BigRational {
    plane.value_at(x, y, z)
}

fn only(scene: &FramedScene) -> &FramedQuadric {
    scene.objects[0].quadric().expect("a quadric")
}

/// A scene seen along -z, 100 pixels to the scene unit, D = 1000 pixels, with the given camera extras and object keys.
fn framed(object: &str) -> FramedScene {
    framed_by(
        "kind = \"perspective\"\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nviewer_distance = 10\nview_height = 4\nnear = 5",
        object,
    )
}

fn framed_by(camera: &str, object: &str) -> FramedScene {
    let text = format!(
        "format = 1\ntitle = \"t\"\nbackground = [1, 0.5, 0]\n[camera]\n{camera}\n\
         [[lights]]\nkind = \"point\"\nposition = [1, 2, 3]\nintensity = 0.5\n\
         [[lights]]\nkind = \"directional\"\nfrom = [0, 3, 4]\n\
         [[materials]]\nname = \"m\"\ncolour = [1, 1, 1]\n\
         [[objects]]\nname = \"o\"\nmaterial = \"m\"\n{object}\n"
    );
    SceneFile::parse(&text, "test")
        .and_then(|scene| scene.frame(800, 400))
        .unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn camera_axes_and_unit() {
    let scene = framed("kind = \"sphere\"\nradius = 1\nplace = [{ translate = [1, 0.5, 0.25] }]");
    // Centre (100, -50, -25), radius 100: x to the right, y down, z away from the observer.
    let expected = whole_quadric([1, 1, 1, 0, 0, 0, -100, 50, 25, 2_500 + 625]);
    assert_eq!(only(&scene).quadric, expected);
    assert_eq!(scene.projection, perspective(1000));
    assert_eq!(scene.background, [255, 128, 0]);
}

#[test]
fn decimals_stay_decimals() {
    let scene = framed("kind = \"sphere\"\nradius = 0.1\nplace = [{ translate = [0.3, 0, 0] }]");
    let expected = whole_quadric([1, 1, 1, 0, 0, 0, -30, 0, 0, 800]);
    assert_eq!(only(&scene).quadric, expected);
}

#[test]
fn cut_keeps_the_side_behind_its_normal() {
    for mirror in ["", ", { scale = [1, 1, -1] }"] {
        let scene = framed(&format!(
            "kind = \"sphere\"\nradius = 1\nplace = [{{ translate = [0, 0, 0]}}{mirror}]\n\
             cuts = [{{ point = [0.25, 0, 0], normal = [3, 0, 0] }}]"
        ));
        // The primitive form of x - 25 <= 0.
        assert_eq!(only(&scene).planes[0], plane([1, 0, 0, -25]), "{mirror}");
    }
}

#[test]
fn the_eye_stands_exactly_at_minus_d() {
    // A cone with its apex in the eye vanishes there, whatever the direction of view.
    let scene = framed_by(
        "kind = \"perspective\"\neye = [1.1, 2.3, 3.7]\ntarget = [-0.3, 0.1, 0.2]\nviewer_distance = 3.3\nview_height = 1.7",
        "kind = \"cone\"\nradii = [1, 2, 3]\nplace = [{ rotate = { axis = [1, 2, 3], degrees = 20 } }, { translate = [1.1, 2.3, 3.7] }]",
    );
    let distance = fraction(33 * 400, 17);
    let eye = [integer(0), integer(0), -distance.clone()];
    assert_eq!(scene.projection, Projection::Perspective { distance });
    assert!(value(&only(&scene).quadric, &eye).is_zero());
}

#[test]
fn orthographic_screen_plane_passes_through_the_target() {
    let scene = framed_by(
        "kind = \"orthographic\"\neye = [5, 1, 2]\ntarget = [1, 1, 2]\nview_height = 4\nhalf_depth = 2.5",
        "kind = \"sphere\"\nradius = 1\nplace = [{ translate = [0.5, 1, 2.25] }]",
    );
    // Seen along -x: z is to the left, so the centre is at (-25, 0, 50).
    let expected = whole_quadric([1, 1, 1, 0, 0, 0, 25, 0, -50, 625 + 2500 - 10_000]);
    assert_eq!(only(&scene).quadric, expected);
    assert_eq!(scene.projection, parallel(250));
}

#[test]
fn lights_follow_the_camera() {
    let scene = framed("kind = \"sphere\"\nradius = 1");
    let point = FramedLight {
        at: [100.0, -200.0, -300.0],
        is_at_a_point: true,
        colour: [0.5; 3],
    };
    let directional = FramedLight {
        at: [0.0, -0.6, -0.8],
        is_at_a_point: false,
        colour: [1.0; 3],
    };
    assert_eq!(scene.lights, [point, directional]);
}

/// One point inside, one on and one outside of each canonical quadric.
#[test]
fn canonical_quadrics() {
    let three = [2.0, 3.0, 5.0];
    let two = [2.0, 5.0];
    let coefficients = [0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, -6.0];
    #[rustfmt::skip]
    let cases: [(Shape, [[f64; 3]; 3]); 11] = [
        (Shape::Ellipsoid(three), [[0.0, 2.9, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 5.1]]),
        (Shape::Sphere { radius: 0.7 }, [[0.1, 0.0, 0.0], [0.0, 0.0, -0.7], [0.5, 0.5, 0.0]]),
        (Shape::EllipticCylinder(two), [[1.9, 99.0, 0.0], [0.0, -7.0, 5.0], [2.1, 0.0, 0.0]]),
        (Shape::HyperbolicCylinder(two), [[0.0, 9.0, 99.0], [2.0, 1.0, 0.0], [2.1, 0.0, 0.0]]),
        (Shape::ParabolicCylinder(two), [[0.0, 9.0, 1.0], [2.0, -9.0, 5.0], [0.0, 0.0, -1.0]]),
        (Shape::Cone(three), [[0.0, -3.0, 0.0], [2.0, 3.0, 0.0], [0.0, 2.9, 5.0]]),
        (Shape::HyperboloidOneSheet(three), [[0.0, 9.0, 0.0], [0.0, 0.0, 5.0], [2.1, 0.0, 0.0]]),
        (Shape::HyperboloidTwoSheets(three), [[0.0, -3.1, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 0.0]]),
        (Shape::EllipticParaboloid(three), [[0.0, 1.0, 0.0], [2.0, 3.0, 0.0], [0.0, -1.0, 0.0]]),
        (Shape::HyperbolicParaboloid(three), [[0.0, 1.0, 9.0], [0.0, -3.0, 5.0], [2.0, 2.9, 0.0]]),
        (Shape::Quadric { coefficients }, [[1.0, 2.0, 0.0], [2.0, 3.0, 0.0], [2.0, 3.1, 0.0]]),
    ];
    for (shape, [inside, on, outside]) in cases {
        let quadric = Quadric::from_shape(&shape).expect("a quadric");
        let at = |p: [f64; 3]| value(&quadric, &p.map(from_decimal));
        assert!(at(inside).is_negative(), "{shape:?} inside");
        assert!(at(on).is_zero(), "{shape:?} on the surface");
        assert!(at(outside).is_positive(), "{shape:?} outside");
    }
}

#[test]
fn framed_coefficients_are_whole_and_primitive() {
    let scene = framed(
        "kind = \"ellipsoid\"\nradii = [0.7, 0.3, 1.9]\ncuts = [{ point = [0.1, 0, 0], normal = [0.2, 0.4, 0.6] }]",
    );
    let object = only(&scene);
    let gcd = |values: &[&BigRational]| {
        let whole = |value: &&BigRational| value.to_integer();
        assert!(values.iter().all(|value| value.is_integer()), "{values:?}");
        let values = values.iter().map(whole);
        values.fold(BigInt::ZERO, |gcd, value| gcd.gcd(&value))
    };
    assert!(gcd(&object.quadric.coefficients()).is_one());
    assert!(gcd(&object.planes[0].coefficients()).is_one());
}
