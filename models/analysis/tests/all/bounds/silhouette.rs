use imogene_analysis::bounds::silhouette::{displacement_at, greatest_curvature};
use imogene_golden::unit::pe2::Quadratic;

fn quadratic(a: i128, b: i128, c: i128) -> Quadratic {
    Quadratic {
        a,
        b,
        c,
        ..Quadratic::default()
    }
}

#[test]
fn a_straight_slope_divides_the_error() {
    let t = displacement_at(&quadratic(0, 0, 0), [3.0, 4.0], 10.0).unwrap();
    assert!((2.0..2.0 + 1e-9).contains(&t));
}

#[test]
fn curvature_may_leave_nothing() {
    // q = x^2 - y^2 + ...: eigenvalues 2 and -2.
    assert!((greatest_curvature(&quadratic(1, -1, 0)) - 2.0).abs() < 1e-9);
    // q = 2 x y: eigenvalues 2 and -2 too.
    assert!((greatest_curvature(&quadratic(0, 0, 2)) - 2.0).abs() < 1e-9);
    // A circle of radius 5: q = x^2 + y^2 - 25, at (5, 0). f2 = q + 24 has the radius 1, f2 = q + 26 none.
    let circle = quadratic(1, 1, 0);
    let t = displacement_at(&circle, [10.0, 0.0], 24.0).unwrap();
    assert!((4.0..4.0 + 1e-6).contains(&t), "{t}");
    assert_eq!(displacement_at(&circle, [10.0, 0.0], 26.0), None);
    assert_eq!(displacement_at(&circle, [0.0, 0.0], 1.0), None);
}
