//! How quadrics and planes change their frame.

use super::*;

type Matrix = [[BigRational; 4]; 4];

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
