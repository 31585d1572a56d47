use imogene_algebra::rational::{from_decimal, to_f64};
use imogene_prepare::perspective::ScreenQuadric;
use imogene_scene::Quadric;
use imogene_studies::evaluate::count::{Counted, number, numbers};
use imogene_studies::evaluate::work::quadric::{
    Kind, depth, greatest_f2, greatest_normal, normal, plane,
};

/// A sphere of radius 100 about (20, -10, 300), as the source's simulator would see it from 1000 away.
const SPHERE: [f64; 10] = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0, -20.0, 10.0, -300.0, 80500.0];

/// The same after perspective, and the exact preparation of it.
fn projected() -> ([Counted; 10], ScreenQuadric) {
    let exact = Quadric::from_array(SPHERE.map(from_decimal));
    let exact = ScreenQuadric::new(&exact, &from_decimal(0.001));
    let q = exact.q.coefficients().map(to_f64);
    (numbers(q), exact)
}

/// To the rounding of some ten operations.
fn assert_near(found: f64, expected: f64) {
    let most = 1e-12 * expected.abs().max(1.0);
    assert!((found - expected).abs() <= most, "{found} {expected}");
}

#[test]
fn depth_and_normal_are_those_of_the_exact_preparation() {
    let (q, exact) = projected();
    let depth = depth(q).expect("it has a depth");
    assert!(!depth.is_front_view);
    let f1 = exact.f1();
    for (found, expected) in depth.f1.iter().zip(&f1.factors()) {
        assert_near(found.value, to_f64(expected));
    }
    let f2 = exact.f2();
    for (found, expected) in depth.f2.iter().zip(&f2.factors()) {
        assert_near(found.value, to_f64(expected));
    }
    let normal = normal(q, &depth.f1, number(0.001));
    for (component, (linear, k)) in exact.normal().into_iter().enumerate() {
        assert_near(normal.k[component].value, to_f64(&k));
        let exact = linear.plus(&f1.scaled(&k)).factors();
        for (found, exact) in normal.g[component].iter().zip(&exact) {
            assert_near(found.value, to_f64(exact));
        }
    }
}

#[test]
fn the_greatest_f2_and_normal_are_not_exceeded_and_nearly_reached() {
    let (q, _) = projected();
    let depth = depth(q).expect("it has a depth");
    let normal = normal(q, &depth.f1, number(0.001));
    let most = greatest_f2(&depth.f2);
    let window = numbers([-70.0, -95.0, 180.0, 170.0]);
    let bound = greatest_normal(&normal, most.root(), window).value;
    let (mut f2_seen, mut normal_seen) = (0.0f64, 0.0f64);
    for x in -70..=110 {
        for y in -95..=75 {
            let [x, y] = [x, y].map(f64::from);
            let terms = [x * x, y * y, x * y, x, y, 1.0];
            let f2: f64 = depth.f2.iter().zip(terms).map(|(v, t)| v.value * t).sum();
            f2_seen = f2_seen.max(f2);
            for k in 0..3 {
                let terms = normal.g[k].iter().zip([x, y, 1.0]);
                let g: f64 = terms.map(|(v, t)| v.value * t).sum();
                let change = normal.k[k].value * f2.max(0.0).sqrt();
                normal_seen = normal_seen.max(g.abs() + change.abs());
            }
        }
    }
    assert!(f2_seen <= most.value && f2_seen > 0.999 * most.value);
    assert!(normal_seen <= bound && normal_seen > 0.5 * bound);
}

#[test]
fn planes_keep_their_side() {
    let [scale, steepest] = numbers([8388.607, 16e6]);
    let of = |p: [f64; 4]| plane(numbers(p), scale, steepest);
    let (kind, depth) = of([2.0, -4.0, -8.0, 16.0]);
    assert_eq!(kind, Kind::Front);
    assert_eq!(depth.map(|v| v.value), [0.25, -0.5, 2.0]);
    assert_eq!(of([2.0, -4.0, 8.0, 16.0]).0, Kind::Back);
    for p in [[2.0, -4.0, 0.0, 16.0], [2000.0, -4.0, 1.0, 16.0]] {
        let (kind, half) = of(p);
        assert_eq!(kind, Kind::Perpendicular);
        assert_eq!(half.map(|v| v.value), [-p[0], -p[1], -p[3]]);
    }
}
