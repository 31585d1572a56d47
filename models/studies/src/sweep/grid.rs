//! Values of parameters, and the parts that the scenes of all sweeps are made of.
//!
//! A scene file holds decimals of up to 15 significant digits; whatever a scene derives from its parameter is computed
//! in rationals and must be such a decimal again, so that every scene is exactly what its parameter says.

use imogene_algebra::rational::{from_decimal, to_f64};
use imogene_scene::{
    Camera, Cut, ImageSize, Lens, Material, Object, SceneFile, Shape, Step, Surface,
};
use num_rational::BigRational;

/// The screen of a sweep unless it needs another. The picture is as high as it has lines, so that a scene unit is a
/// pixel in the screen plane.
pub const SCREEN: (u32, u32) = (96, 72);

/// Where objects stand that are not to be symmetric to the pixel centres, which lie at whole numbers.
pub const BESIDE: [f64; 3] = [0.3, 0.2, 0.0];

/// The number that a decimal writes.
pub fn number(text: &str) -> BigRational {
    from_decimal(text.parse().expect("grids hold decimals"))
}

/// A rational as a number of a scene.
///
/// # Panics
///
/// If it is no decimal of up to 15 significant digits: the grid of the sweep is then wrong.
pub fn decimal(value: &BigRational) -> f64 {
    let nearest = to_f64(value);
    assert_eq!(from_decimal(nearest), *value, "no decimal of 15 digits");
    nearest
}

/// Decades `first`, `first / 10`, ... down to `last` as decimals, each times every mantissa.
pub fn decades(mantissas: &[u32], exponents: impl Iterator<Item = i32>) -> Vec<String> {
    let numbers = exponents.flat_map(|e| mantissas.iter().map(move |m| format!("{m}e{e}")));
    // Without the exponent.
    let plain = |text: String| text.parse::<f64>().expect("a decimal").to_string();
    numbers.map(plain).collect()
}

/// Parallel projection along z, `half_depth` pixels to both sides of the origin.
pub fn orthographic(half_depth: f64) -> Camera {
    Camera {
        lens: Lens::Orthographic {
            half_depth: None,
            ends: Some([-half_depth, half_depth]),
        },
        ..perspective(1.0)
    }
}

/// Central projection from (0, 0, distance) on the plane z = 0.
pub fn perspective(distance: f64) -> Camera {
    let [eye, target] = [[0.0, 0.0, distance], [0.0; 3]];
    looking(eye, target, distance, f64::from(SCREEN.1), 0.5 * distance)
}

/// Central projection with the y axis upwards.
pub fn looking(
    eye: [f64; 3],
    target: [f64; 3],
    viewer_distance: f64,
    view_height: f64,
    near: f64,
) -> Camera {
    Camera {
        lens: Lens::Perspective {
            viewer_distance,
            near: Some(near),
        },
        ..Camera::perspective([eye, target, [0.0, 1.0, 0.0]], viewer_distance, view_height)
    }
}

/// A scene without lights on the usual screen.
pub fn scene(title: &str, camera: Camera, objects: Vec<Object>) -> SceneFile {
    let (width, height) = SCREEN;
    SceneFile {
        image: ImageSize { width, height },
        materials: vec![Material {
            name: "plain".into(),
            colour: [0.5; 3],
            ambient: 0.3,
            diffuse: 0.7,
            specular: 0.0,
            exponent: 1,
            opacity: 1.0,
        }],
        objects,
        ..SceneFile::new(title, camera)
    }
}

/// A solid where its local coordinates are.
pub fn solid(name: &str, shape: Shape, cuts: Vec<Cut>) -> Object {
    Object {
        name: name.into(),
        shape,
        processor: None,
        mode: Surface::Solid,
        material: "plain".into(),
        place: vec![],
        cuts,
        casts_shadow: true,
        group: None,
        visible: true,
    }
}

/// A solid of that name that is moved.
pub fn moved(name: &str, shape: Shape, cuts: Vec<Cut>, by: [f64; 3]) -> Object {
    Object {
        place: vec![Step::Translate(by)],
        ..solid(name, shape, cuts)
    }
}

/// The plane through a point that removes the side of the normal.
pub fn cut(point: [f64; 3], normal: [f64; 3]) -> Cut {
    Cut { point, normal }
}
