use imogene_import::faces::chart::Chart;
use imogene_import::faces::vector::{Vector, dot, length, minus, unit};
use imogene_import::faces::{Form, Separator, Surface};

fn charts() -> [Chart; 4] {
    let axis = unit([1.0, 2.0, -2.0]);
    [
        Surface::new([1.0, 2.0, 3.0], axis, Form::Plane),
        Surface::new([3.0, 1.0, 2.0], axis, Form::Cylinder(1.5)),
        Surface::new([0.5, -1.0, 2.0], axis, Form::Cone(0.6)),
        Surface::new([1.0, 1.0, -4.0], axis, Form::Sphere(2.0)),
    ]
    .map(|surface| Chart::free(&surface, &[]))
}

fn through(chart: &Chart, more: f64) -> (Vector, f64) {
    let normal = unit([0.3, 0.9, 0.2]);
    (normal, dot(normal, chart.point(1.0, 0.3)) + more)
}

#[test]
fn points_of_a_chart_lie_on_the_surface_at_their_u() {
    for chart in charts() {
        for k in 0..60 {
            let (u, w) = (0.1 * f64::from(k), 0.02 * f64::from(k) + 0.05);
            let p = chart.point(u, w);
            let q = chart.surface.nearest(p).unwrap();
            assert!(length(minus(p, q)) < 1e-12, "{chart:?}");
            assert!((chart.u_of(p) - u).abs() < 1e-12, "{chart:?}");
        }
    }
}

#[test]
fn crossings_lie_on_the_separator() {
    for chart in charts() {
        let plane = through(&chart, 0.0);
        let mut found = 0;
        for k in 0..60 {
            let u = 0.1 * f64::from(k);
            for w in chart.crossings(u, &Separator::Plane(plane)) {
                let off = dot(plane.0, chart.point(u, w)) - plane.1;
                assert!(off.abs() < 1e-9, "{chart:?}");
                found += 1;
            }
        }
        assert!(found > 20, "{chart:?}");
    }
}

#[test]
fn numbers_of_crossings_change_at_turns_alone() {
    for chart in charts() {
        let separator = Separator::Plane(through(&chart, 0.4));
        let turns = chart.turns(&separator);
        let count = |u: f64| chart.crossings(u, &separator).len();
        for k in 0..2000 {
            let (u, v) = (f64::from(k) * 0.003, f64::from(k + 1) * 0.003);
            if !turns.iter().any(|t| (u - 1e-9..=v + 1e-9).contains(t)) {
                assert_eq!(count(u), count(v), "{chart:?} at {u}");
            }
        }
    }
}

#[test]
fn conics_on_a_plane_meet_where_both_are_zero() {
    let axis = [0.0, 0.0, 1.0];
    let chart = Chart::free(&Surface::new([0.0; 3], axis, Form::Plane), &[]);
    let circle = |x: f64| {
        let surface = Surface::new([x, 0.0, 0.0], axis, Form::Cylinder(1.0));
        Separator::Quadric(surface.implicit().unwrap())
    };
    // x = 1/2, y = +-sqrt(3)/2
    let meetings = chart.meetings(&circle(0.0), &circle(1.0));
    for y in [-0.75_f64.sqrt(), 0.75_f64.sqrt()] {
        let u = chart.u_of([0.5, y, 0.0]);
        let near = |m: &f64| (m - u).abs() < 1e-7;
        assert!(meetings.iter().any(near), "{meetings:?}");
    }
}
