use imogene_import::faces::polynomial::{harmonic, quadratic, roots_between};

#[test]
fn quadratics_lose_no_root_to_cancellation() {
    // (x - 1e-8)(x - 1e8)
    let roots = quadratic(1.0, -(1e8 + 1e-8), 1.0);
    assert!((roots[0] - 1e-8).abs() < 1e-22 && (roots[1] - 1e8).abs() < 1e-7);
    assert_eq!(quadratic(1.0, 0.0, 1.0), Vec::<f64>::new());
    assert_eq!(quadratic(0.0, 2.0, -4.0), [2.0]);
    assert_eq!(quadratic(0.0, 0.0, 0.0), Vec::<f64>::new());
}

#[test]
fn quartics_give_simple_and_double_roots() {
    // (x^2 - 1)(x - 2)^2 = x^4 - 4x^3 + 3x^2 + 4x - 4
    let roots = roots_between(&[-4.0, 4.0, 3.0, -4.0, 1.0], -9.0, 9.0);
    for expected in [-1.0_f64, 1.0, 2.0] {
        let near = |root: &f64| (root - expected).abs() < 1e-6;
        assert!(roots.iter().any(near), "{roots:?}");
    }
}

#[test]
fn angles_solve_the_harmonic_equation() {
    for k in 0..40 {
        let (a, b, c) = (3.0 - 0.2 * f64::from(k), 0.7, 0.5);
        for u in harmonic(a, b, c) {
            assert!((a * u.cos() + b * u.sin() - c).abs() < 1e-12);
        }
    }
}
