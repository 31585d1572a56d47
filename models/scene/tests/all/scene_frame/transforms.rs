//! How quadrics and planes change their frame.

use super::*;
use imogene_algebra::matrix::{Matrix4, SYMMETRIC, image, product, transposed};

type Matrix = Matrix4<BigRational>;

fn turn(axis: Axis, degrees: f64) -> Step {
    Step::Rotate(Rotation { axis, degrees })
}

/// Placements with mirrors, unequal scales and slanted rotations, and one of each alone.
fn placements() -> Vec<Vec<Step>> {
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
    let pairs = move |x| ticks.into_iter().map(move |y| (x, y));
    let three = move |(x, y)| ticks.into_iter().map(move |z| point(x, y, z));
    ticks.into_iter().flat_map(pairs).flat_map(three).collect()
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
    let determinant = transform.determinant();
    transposed(&transform.cofactors()).map(|row| row.map(|entry| entry / &determinant))
}

#[test]
fn cofactors_invert() {
    for steps in placements() {
        let transform = Transform::placement(&steps);
        let unit = product(&transform.rows, &inverse(&transform));
        assert_eq!(unit, Transform::identity().rows, "{steps:?}");
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
    let printed = product(&inverse, &product(&quadric.matrix(), &transposed(&inverse)));
    let printed = Quadric::from_array(SYMMETRIC.map(|[i, j]| printed[i][j].clone()));
    let moved = |p: &Point| value(&printed, &transform.point(p)).signum();
    let mut points = sample_points().into_iter();
    let wrong = points.any(|p| moved(&p) != value(&quadric, &p).signum());
    assert!(wrong, "the printed rule would be right");
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
    let column = plane.coefficients().map(Clone::clone);
    let apply = |matrix: &Matrix| Plane::from_array(image(matrix, &column));
    let wrong = |printed: &Plane, transform: &Transform| {
        let moved = |p: &Point| side(printed, &transform.point(p)).signum();
        let points = sample_points().into_iter();
        let wrong = points.filter(|p| moved(p) != side(&plane, p).signum());
        wrong.count()
    };
    let turned = Transform::placement(&placements()[4]);
    assert!(wrong(&apply(&inverse(&turned)), &turned) > 0);

    let mirror = Transform::placement(&placements()[2]);
    let unsigned = apply(&mirror.cofactors());
    // Every side is exchanged.
    assert_eq!(wrong(&unsigned, &mirror), sample_points().len());
}

#[test]
fn quarter_turns_are_exact() {
    let turns = [
        (90, [-1, 0]),
        (180, [0, -1]),
        (270, [1, 0]),
        (-90, [1, 0]),
        (450, [-1, 0]),
        (0, [0, 1]),
    ];
    for (degrees, [x, y]) in turns {
        let rotation = turn(Axis::Z, f64::from(degrees));
        let image = Transform::placement(&[rotation]).point(&point(0.0, 1.0, 0.0));
        assert_eq!(image, [x, y, 0].map(integer), "{degrees} degrees");
    }
    let scene = framed(
        "kind = \"elliptic_cylinder\"\nradii = [1, 2]\nplace = [{ rotate = { axis = \"x\", degrees = 90 } }]",
    );
    // Rulings along z: no trace of z is left in the quadric.
    let expected = whole_quadric([4, 1, 0, 0, 0, 0, 0, 0, 0, -40_000]);
    assert_eq!(only(&scene).quadric, expected);
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
        let image = Transform::placement(&[turn(axis, 90.0)]).point(&from.map(from_decimal));
        assert_eq!(image, to.map(integer), "{axis:?}");
    }
}

#[test]
fn steps_apply_in_the_order_written() {
    let placed = Transform::placement(&[
        Step::Translate([1.0, 0.0, 0.0]),
        turn(Axis::Z, 90.0),
        Step::Scale(Scale::PerAxis([1.0, 2.0, 1.0])),
    ]);
    assert_eq!(placed.point(&point(0.0, 0.0, 0.0)), point(0.0, 2.0, 0.0));
}
