//! The change from scene to camera frame is exact.

use std::fs;
use std::path::Path;

use imogene_models::rational::{fraction, from_decimal, integer};
use imogene_models::scene::{
    Axis, Cut, FramedLight, FramedQuadric, FramedScene, Plane, Projection, Quadric, Rotation,
    Scale, SceneFile, Shape, Step, Transform,
};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

type Point = [BigRational; 3];
type Matrix = [[BigRational; 4]; 4];

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

fn coefficients(quadric: &Quadric) -> Vec<BigRational> {
    quadric.coefficients().into_iter().cloned().collect()
}

fn integers(values: &[i64]) -> Vec<BigRational> {
    values.iter().map(|value| integer(*value)).collect()
}

/// A scene seen along -z, 100 pixels to the scene unit, D = 1000 pixels, with the given camera extras and object keys.
fn framed(object: &str) -> FramedScene {
    framed_by(
        "kind = \"perspective\"\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nviewer_distance = 10\nview_height = 4",
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

/// Placements with mirrors, unequal scales and slanted rotations, and one of each alone.
fn placements() -> Vec<Vec<Step>> {
    let turn = |axis, degrees| Step::Rotate(Rotation { axis, degrees });
    vec![
        vec![],
        vec![Step::Translate([1.5, -0.1, 7.0])],
        vec![Step::Scale(Scale::PerAxis([-1.0, 1.0, 1.0]))],
        vec![Step::Scale(Scale::Uniform(-0.3))],
        vec![turn(Axis::Z, 33.0), Step::Translate([0.2, 0.3, -0.4])],
        vec![
            Step::Scale(Scale::PerAxis([1.0, -2.5, 0.01])),
            turn(Axis::Vector([1.0, 2.0, -0.5]), 71.3),
            Step::Translate([-3.1, 0.7, 12.0]),
            Step::Scale(Scale::PerAxis([3.0, 1.0, 0.5])),
        ],
    ]
}

fn sample_points() -> Vec<Point> {
    let ticks = [-2.1, -0.4, 0.0, 0.9, 3.3];
    let mut points = Vec::new();
    for x in ticks {
        for y in ticks {
            for z in ticks {
                points.push(point(x, y, z));
            }
        }
    }
    points
}

fn sample_quadric() -> Quadric {
    Quadric::from_shape(&Shape::Quadric {
        coefficients: [1.0, -0.7, 2.0, 0.3, -0.2, 0.1, 0.6, -1.1, 0.4, -0.9],
    })
    .expect("a quadric")
}

fn sample_plane() -> Plane {
    Plane::from_cut(&Cut {
        point: [0.3, -0.2, 0.1],
        normal: [0.7, 1.0, -0.4],
    })
}

fn inverse(transform: &Transform) -> Matrix {
    let cofactors = transform.cofactors();
    let determinant = transform.determinant();
    std::array::from_fn(|row| std::array::from_fn(|column| &cofactors[column][row] / &determinant))
}

fn product(left: &Matrix, right: &Matrix) -> Matrix {
    std::array::from_fn(|row| {
        std::array::from_fn(|column| (0..4).map(|k| &left[row][k] * &right[k][column]).sum())
    })
}

fn matrix_of(q: &Quadric) -> Matrix {
    [
        [&q.a, &q.d, &q.e, &q.g],
        [&q.d, &q.b, &q.f, &q.h],
        [&q.e, &q.f, &q.c, &q.i],
        [&q.g, &q.h, &q.i, &q.j],
    ]
    .map(|row| row.map(Clone::clone))
}

fn quadric_of(m: &Matrix) -> Quadric {
    Quadric {
        a: m[0][0].clone(),
        b: m[1][1].clone(),
        c: m[2][2].clone(),
        d: m[0][1].clone(),
        e: m[0][2].clone(),
        f: m[1][2].clone(),
        g: m[0][3].clone(),
        h: m[1][3].clone(),
        i: m[2][3].clone(),
        j: m[3][3].clone(),
    }
}

#[test]
fn cofactors_invert() {
    for steps in placements() {
        let transform = Transform::placement(&steps);
        let unit = product(&transform.rows, &inverse(&transform));
        for (row, entries) in unit.iter().enumerate() {
            for (column, entry) in entries.iter().enumerate() {
                let expected = if row == column {
                    BigRational::one()
                } else {
                    BigRational::zero()
                };
                assert_eq!(*entry, expected, "{steps:?}");
            }
        }
    }
}

#[test]
fn transformed_quadric_keeps_its_values_up_to_the_square_of_the_determinant() {
    let quadric = sample_quadric();
    for steps in placements() {
        let transform = Transform::placement(&steps);
        let image = quadric.transformed(&transform);
        let factor = transform.determinant().pow(2);
        for p in sample_points() {
            let expected = value(&quadric, &p) * &factor;
            assert_eq!(value(&image, &transform.point(&p)), expected, "{steps:?}");
        }
    }
}

/// The source prints `M^-1 Q M^-1t`, the form for row points; on column points it moves the quadric elsewhere.
#[test]
fn printed_rule_for_quadrics_fails() {
    let quadric = sample_quadric();
    let transform = Transform::placement(&placements()[4]);
    let inverse = inverse(&transform);
    let transposed =
        std::array::from_fn(|row| std::array::from_fn(|column| inverse[column][row].clone()));
    let printed = quadric_of(&product(
        &product(&inverse, &matrix_of(&quadric)),
        &transposed,
    ));
    let wrong = sample_points()
        .iter()
        .filter(|p| value(&printed, &transform.point(p)).signum() != value(&quadric, p).signum())
        .count();
    assert!(wrong > 0, "the printed rule would be right");
}

#[test]
fn transformed_plane_keeps_its_side_even_when_mirrored() {
    let plane = sample_plane();
    let mut mirrored = 0;
    for steps in placements() {
        let transform = Transform::placement(&steps);
        let image = plane.transformed(&transform);
        let factor = transform.determinant().abs();
        mirrored += usize::from(transform.determinant().is_negative());
        for p in sample_points() {
            let expected = side(&plane, &p) * &factor;
            assert_eq!(side(&image, &transform.point(&p)), expected, "{steps:?}");
        }
    }
    assert_eq!(mirrored, 3, "mirrors are what this test is about");
}

/// The source prints `M^-1 P` (a transpose is missing) and forgets the sign of the determinant.
#[test]
fn printed_rules_for_planes_fail() {
    let plane = sample_plane();
    let column = [&plane.a, &plane.b, &plane.c, &plane.d];
    let apply = |matrix: &Matrix| {
        let [a, b, c, d] =
            std::array::from_fn(|row| (0..4).map(|k| &matrix[row][k] * column[k]).sum());
        Plane { a, b, c, d }
    };
    let wrong = |printed: &Plane, transform: &Transform| {
        sample_points()
            .iter()
            .filter(|p| side(printed, &transform.point(p)).signum() != side(&plane, p).signum())
            .count()
    };
    let turned = Transform::placement(&placements()[4]);
    assert!(wrong(&apply(&inverse(&turned)), &turned) > 0);

    let mirror = Transform::placement(&placements()[2]);
    let unsigned = apply(&mirror.cofactors());
    assert_eq!(
        wrong(&unsigned, &mirror),
        sample_points().len(),
        "every side is exchanged"
    );
}

#[test]
fn camera_axes_and_unit() {
    let scene = framed("kind = \"sphere\"\nradius = 1\nplace = [{ translate = [1, 0.5, 0.25] }]");
    // Centre (100, -50, -25), radius 100: x to the right, y down, z away from the observer.
    let expected = integers(&[
        1,
        1,
        1,
        0,
        0,
        0,
        -100,
        50,
        25,
        10_000 + 2_500 + 625 - 10_000,
    ]);
    assert_eq!(coefficients(&only(&scene).quadric), expected);
    assert_eq!(
        scene.projection,
        Projection::Perspective {
            distance: integer(1000)
        }
    );
    assert_eq!(scene.background, [255, 128, 0]);
}

#[test]
fn decimals_stay_decimals() {
    let scene = framed("kind = \"sphere\"\nradius = 0.1\nplace = [{ translate = [0.3, 0, 0] }]");
    let expected = integers(&[1, 1, 1, 0, 0, 0, -30, 0, 0, 800]);
    assert_eq!(coefficients(&only(&scene).quadric), expected);
}

#[test]
fn quarter_turns_are_exact() {
    for (degrees, towards) in [
        (90, [-1, 0]),
        (180, [0, -1]),
        (270, [1, 0]),
        (-90, [1, 0]),
        (450, [-1, 0]),
        (0, [0, 1]),
    ] {
        let rotation = Step::Rotate(Rotation {
            axis: Axis::Z,
            degrees: f64::from(degrees),
        });
        let image = Transform::placement(&[rotation]).point(&point(0.0, 1.0, 0.0));
        assert_eq!(
            image,
            [integer(towards[0]), integer(towards[1]), integer(0)],
            "{degrees} degrees"
        );
    }
    let scene = framed(
        "kind = \"elliptic_cylinder\"\nradii = [1, 2]\nplace = [{ rotate = { axis = \"x\", degrees = 90 } }]",
    );
    // Rulings along z: no trace of z is left in the quadric.
    let expected = integers(&[4, 1, 0, 0, 0, 0, 0, 0, 0, -40_000]);
    assert_eq!(coefficients(&only(&scene).quadric), expected);
}

#[test]
fn rotations_turn_counter_clockwise() {
    let cases = [
        (Axis::X, [0.0, 1.0, 0.0], [0, 0, 1]),
        (Axis::Y, [0.0, 0.0, 1.0], [1, 0, 0]),
        (Axis::Z, [1.0, 0.0, 0.0], [0, 1, 0]),
        (Axis::Vector([0.0, 0.0, -2.0]), [1.0, 0.0, 0.0], [0, -1, 0]),
    ];
    for (axis, from, to) in cases {
        let rotation = Step::Rotate(Rotation {
            axis,
            degrees: 90.0,
        });
        let image = Transform::placement(&[rotation]).point(&from.map(from_decimal));
        assert_eq!(image, to.map(integer), "{axis:?}");
    }
}

#[test]
fn steps_apply_in_the_order_written() {
    let placed = Transform::placement(&[
        Step::Translate([1.0, 0.0, 0.0]),
        Step::Rotate(Rotation {
            axis: Axis::Z,
            degrees: 90.0,
        }),
        Step::Scale(Scale::PerAxis([1.0, 2.0, 1.0])),
    ]);
    assert_eq!(placed.point(&point(0.0, 0.0, 0.0)), point(0.0, 2.0, 0.0));
}

#[test]
fn cut_keeps_the_side_behind_its_normal() {
    for mirror in ["", ", { scale = [1, 1, -1] }"] {
        let scene = framed(&format!(
            "kind = \"sphere\"\nradius = 1\nplace = [{{ translate = [0, 0, 0]}}{mirror}]\n\
             cuts = [{{ point = [0.25, 0, 0], normal = [3, 0, 0] }}]"
        ));
        let plane = &only(&scene).planes[0];
        // The primitive form of x - 25 <= 0.
        let expected = integers(&[1, 0, 0, -25]);
        assert_eq!(
            plane.coefficients().map(Clone::clone).to_vec(),
            expected,
            "{mirror}"
        );
    }
}

#[test]
fn the_eye_stands_exactly_at_minus_d() {
    // A cone with its apex in the eye vanishes there, whatever the direction of view.
    let scene = framed_by(
        "kind = \"perspective\"\neye = [1.1, 2.3, 3.7]\ntarget = [-0.3, 0.1, 0.2]\nviewer_distance = 3.3\nview_height = 1.7",
        "kind = \"cone\"\nradii = [1, 2, 3]\nplace = [{ rotate = { axis = [1, 2, 3], degrees = 20 } }, { translate = [1.1, 2.3, 3.7] }]",
    );
    let Projection::Perspective { distance } = &scene.projection else {
        panic!("a perspective camera was asked for");
    };
    assert_eq!(*distance, fraction(33 * 400, 17));
    assert!(
        value(
            &only(&scene).quadric,
            &[integer(0), integer(0), -distance.clone()]
        )
        .is_zero()
    );
}

#[test]
fn orthographic_screen_plane_passes_through_the_target() {
    let scene = framed_by(
        "kind = \"orthographic\"\neye = [5, 1, 2]\ntarget = [1, 1, 2]\nview_height = 4\nhalf_depth = 2.5",
        "kind = \"sphere\"\nradius = 1\nplace = [{ translate = [0.5, 1, 2.25] }]",
    );
    // Seen along -x: z is to the left, so the centre is at (-25, 0, 50).
    let expected = integers(&[1, 1, 1, 0, 0, 0, 25, 0, -50, 625 + 2500 - 10_000]);
    assert_eq!(coefficients(&only(&scene).quadric), expected);
    assert_eq!(
        scene.projection,
        Projection::Orthographic {
            half_depth: integer(250)
        }
    );
}

#[test]
fn lights_follow_the_camera() {
    let scene = framed("kind = \"sphere\"\nradius = 1");
    assert_eq!(
        scene.lights,
        [
            FramedLight::Point {
                position: [100.0, -200.0, -300.0],
                colour: [0.5; 3]
            },
            FramedLight::Directional {
                towards: [0.0, -0.6, -0.8],
                colour: [1.0; 3]
            },
        ]
    );
}

/// One point inside, one on and one outside of each canonical quadric.
#[test]
fn canonical_quadrics() {
    let three = [2.0, 3.0, 5.0];
    let two = [2.0, 5.0];
    let cases: [(Shape, [[f64; 3]; 3]); 11] = [
        (
            Shape::Ellipsoid { radii: three },
            [[0.0, 2.9, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 5.1]],
        ),
        (
            Shape::Sphere { radius: 0.7 },
            [[0.1, 0.0, 0.0], [0.0, 0.0, -0.7], [0.5, 0.5, 0.0]],
        ),
        (
            Shape::EllipticCylinder { radii: two },
            [[1.9, 99.0, 0.0], [0.0, -7.0, 5.0], [2.1, 0.0, 0.0]],
        ),
        (
            Shape::HyperbolicCylinder { radii: two },
            [[0.0, 9.0, 99.0], [2.0, 1.0, 0.0], [2.1, 0.0, 0.0]],
        ),
        (
            Shape::ParabolicCylinder { radii: two },
            [[0.0, 9.0, 1.0], [2.0, -9.0, 5.0], [0.0, 0.0, -1.0]],
        ),
        (
            Shape::Cone { radii: three },
            [[0.0, -3.0, 0.0], [2.0, 3.0, 0.0], [0.0, 2.9, 5.0]],
        ),
        (
            Shape::HyperboloidOneSheet { radii: three },
            [[0.0, 9.0, 0.0], [0.0, 0.0, 5.0], [2.1, 0.0, 0.0]],
        ),
        (
            Shape::HyperboloidTwoSheets { radii: three },
            [[0.0, -3.1, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 0.0]],
        ),
        (
            Shape::EllipticParaboloid { radii: three },
            [[0.0, 1.0, 0.0], [2.0, 3.0, 0.0], [0.0, -1.0, 0.0]],
        ),
        (
            Shape::HyperbolicParaboloid { radii: three },
            [[0.0, 1.0, 9.0], [0.0, -3.0, 5.0], [2.0, 2.9, 0.0]],
        ),
        (
            Shape::Quadric {
                coefficients: [0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, -6.0],
            },
            [[1.0, 2.0, 0.0], [2.0, 3.0, 0.0], [2.0, 3.1, 0.0]],
        ),
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
        values
            .iter()
            .fold(BigRational::zero().to_integer(), |gcd, value| {
                assert!(value.is_integer(), "{value}");
                num_integer::Integer::gcd(&gcd, value.numer())
            })
    };
    assert!(gcd(&object.quadric.coefficients()).is_one());
    assert!(gcd(&object.planes[0].coefficients()).is_one());
}

#[test]
fn shipped_scenes_load_frame_and_survive_writing() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let mut count = 0;
    for entry in fs::read_dir(&folder).expect("the scenes folder") {
        let path = entry.expect("a folder entry").path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let scene = SceneFile::read(&path).unwrap_or_else(|error| panic!("{error}"));
        let framed = scene
            .frame(scene.image.width, scene.image.height)
            .expect("a checked scene");
        assert_eq!(framed.objects.len(), scene.objects.len());
        let written = scene.to_toml().expect("a checked scene");
        let again = SceneFile::parse(&written, "written")
            .unwrap_or_else(|error| panic!("{error}\n{written}"));
        assert_eq!(again, scene, "{}", path.display());
        count += 1;
    }
    assert!(count >= 15, "only {count} scenes found");
}

#[test]
fn teapot_is_made_of_the_source_s_quadrics() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/teapot.toml");
    let scene = SceneFile::read(&path).unwrap_or_else(|error| panic!("{error}"));
    let count = |test: fn(&Shape) -> bool| {
        scene
            .objects
            .iter()
            .filter(|object| {
                object.mode == imogene_models::scene::Surface::Patch && test(&object.shape)
            })
            .count()
    };
    assert_eq!(scene.objects.len(), 10);
    assert_eq!(count(|shape| matches!(shape, Shape::Ellipsoid { .. })), 4);
    assert_eq!(count(|shape| matches!(shape, Shape::Cone { .. })), 2);
    assert_eq!(
        count(|shape| matches!(shape, Shape::HyperboloidOneSheet { .. })),
        3
    );
    assert!(scene.objects.iter().all(|object| object.cuts.len() <= 3));
}

/// The page of the format must not promise what the reader refuses.
#[test]
fn documented_example_is_a_scene() {
    let page = include_str!("../../docs/scene-format.md");
    let example = page
        .split("```")
        .find_map(|block| block.strip_prefix("toml\n"))
        .expect("the page opens with an example");
    let scene =
        SceneFile::parse(example, "scene-format.md").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(scene.objects.len(), 2);
    assert_eq!((scene.image.width, scene.image.height), (720, 540));
}
