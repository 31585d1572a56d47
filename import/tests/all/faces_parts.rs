//! Surfaces, curves and planes of faces, and edges that are simpler than their list says.

use imogene_import::faces::vector::*;
use imogene_import::faces::{
    Arc, Curve, Ellipse, FaceOptions, Form, Part, Planes, Surface, compile,
};
use std::f64::consts::TAU;

fn surfaces() -> [Surface; 3] {
    let axis = unit([1.0, 2.0, -2.0]);
    [
        Surface::new([3.0, 1.0, 2.0], axis, Form::Cylinder(1.5)),
        Surface::new([0.5, -1.0, 2.0], axis, Form::Cone(0.6)),
        Surface::new([1.0, 1.0, -4.0], axis, Form::Sphere(2.0)),
    ]
}

#[test]
fn nearest_points_lie_on_the_quadric_along_its_normal() {
    for surface in surfaces() {
        let implicit = surface.implicit().unwrap();
        for k in 0..50 {
            let t = f64::from(k);
            let (x, y) = (t.sin() * 3.0 + 4.0, t.cos() * 2.0 - 3.0);
            let p = [x, y, (0.7 * t).sin() * 4.0];
            let q = surface.nearest(p).unwrap();
            assert!(implicit.value(q).abs() < 1e-12, "{surface:?}");
            let Some(normal) = surface.normal_at(q) else {
                continue;
            };
            let is_apex = surface.is_cone() && distance(q, surface.origin) < 1e-12;
            let off = cross(minus(p, q), normal);
            assert!(is_apex || length(off) < 1e-9, "{surface:?}");
        }
    }
}

#[test]
fn a_point_on_the_axis_is_inside() {
    for surface in surfaces() {
        let up = if surface.is_cone() { 2.0 } else { 0.0 };
        let inside = along(surface.origin, up, surface.axis);
        let implicit = surface.implicit().unwrap();
        assert!(implicit.value(inside) < 0.0);
        assert!(implicit.kept(true).value(inside) > 0.0);
    }
}

#[test]
fn cones_of_forty_five_degrees_have_whole_coefficients() {
    let form = Form::Cone(45.0_f64.to_radians());
    let cone = Surface::new([0.0; 3], [0.0, 1.0, 0.0], form);
    assert_eq!(cone.implicit().unwrap().0[..3], [1.0, -1.0, 1.0]);
}

#[test]
fn frames_are_right_handed() {
    let axis = unit([0.3, -0.2, 0.9]);
    let [e1, e2] = frame(axis, 0.4);
    assert!(distance(cross(e1, e2), axis) < 1e-14);
}

fn half_circle() -> Curve {
    let x = [1.0, 0.0, 0.0];
    let ellipse = Ellipse::new(x, [0.0, 0.0, 1.0], x, [2.0, 2.0]);
    Curve::Arc(Arc {
        ellipse,
        start: 0.0,
        sweep: 0.5 * TAU,
    })
}

#[test]
fn arcs_pass_their_own_half_alone() {
    let arc = half_circle();
    let direction = arc.direction_at([1.0, 2.0, 0.0], 1e-9).unwrap();
    assert!(distance(unit(direction), [-1.0, 0.0, 0.0]) < 1e-12);
    assert!(arc.direction_at([1.0, -2.0, 0.0], 1e-9).is_none());
    assert!(arc.direction_at([1.0, 1.0, 0.0], 1e-9).is_none());
}

#[test]
fn points_in_a_plane_have_it() {
    let arc = half_circle().sampled(20);
    let plane =
        |points: &[Vector], tolerance| Curve::through(points.to_vec(), false, tolerance).plane();
    let (_, normal) = plane(&arc, 1e-12).unwrap();
    assert!((normal[2].abs() - 1.0).abs() < 1e-12);
    let mut twisted = arc;
    twisted[7][2] = 0.1;
    assert!(plane(&twisted, 1e-3).is_none());
    assert!(plane(&[[0.0; 3], [1.0; 3], [2.0; 3]], 1e-9).is_none());
}

#[test]
fn polylines_pass_between_their_ends() {
    let curve = Curve::through(half_circle().sampled(20), false, 1e-12);
    let direction = curve.direction_at([1.0, 2.0, 0.0], 1e-9).unwrap();
    assert!(direction[0] < 0.0 && direction[1].abs() < 0.2);
    assert!(curve.direction_at([3.0, -0.5, 0.0], 1e-9).is_none());
}

#[test]
fn one_plane_has_one_description_whichever_way_it_faces() {
    let planes = Planes::new(1e-9);
    let first = planes.find_or_add([0.0, 1.0, 0.0], [0.0, 1.0, 0.0]);
    let again = planes.find_or_add([5.0, 1.0, -3.0], [0.0, -1.0, 0.0]);
    assert_eq!(again, first);
    assert_ne!(planes.find_or_add([0.0, 1.1, 0.0], [0.0, 1.0, 0.0]), first);
    assert_eq!(planes.get(first).1, [0.0, 1.0, 0.0]);
    // Without the dust that sines leave, and without the sign of a zero.
    let clean = planes.find_or_add([7.0, 0.0, 0.0], [1.0, 6e-17, -0.0]);
    let bits = planes.get(clean).1.map(f64::to_bits);
    assert_eq!(bits, [1.0, 0.0, 0.0].map(f64::to_bits));
}

/// A part of one face that lies on a surface, bordered by points and the straight way back.
fn bordered(points: &[Vector], surface: &str) -> Part {
    let [first, .., last] = points else {
        panic!("two points")
    };
    let inner = &points[1..points.len() - 1];
    let text = format!(
        "format = 1
title = 'part'
materials = [{{ name = 'm', colour = [1, 1, 1] }}]
vertices = {{ a = {first:?}, b = {last:?} }}
edges = [
    {{ name = 'own', kind = 'points', points = {inner:?}, start = 'a', end = 'b' }},
    {{ name = 'back', kind = 'line', start = 'b', end = 'a' }},
]
faces = [{{ name = 'f', surface = {{ {surface} }}, loops = [['own', 'back']] }}]
solids = [{{ name = 's', material = 'm', faces = ['f'] }}]
"
    );
    compile(text.as_bytes(), "part", &FaceOptions::default()).unwrap_or_else(|e| panic!("{e}"))
}

/// A wave in the plane z = 2, off by so much, as the border of a face in that plane; the part has a size of about 3.
#[test]
fn what_is_in_a_plane_but_for_digits_is_in_the_plane() {
    for (off, flat) in [(1e-5, true), (1e-3, false)] {
        let point = |k: i32| {
            let x = f64::from(k) / 10.0;
            [x, x.sin(), 2.0 + off * (7.0 * x).cos()]
        };
        let points: Vec<Vector> = (0..=30).map(point).collect();
        let plane = "kind = 'plane', origin = [0, 0, 2], normal = [0, 0, -1]";
        let part = bordered(&points, plane);
        let edge = &part.model.edges[0];
        assert_eq!(edge.curve.plane().is_some(), flat);
        let heights = edge.curve.sampled(1).into_iter().map(|p| p[2]);
        assert_eq!(heights.into_iter().all(|z| z == 2.0), flat);
        assert_eq!(edge.off > 0.99e-5, flat);
    }
}

#[test]
fn points_on_a_line_or_a_circle_are_one() {
    let ball = "kind = 'sphere', centre = [0, 0, 0], radius = 2";
    let row = (0..9).map(|k| [f64::from(k), 2.0 * f64::from(k), 1.0]);
    let part = bordered(&row.collect::<Vec<_>>(), ball);
    let (from, to) = ([0.0, 0.0, 1.0], [8.0, 16.0, 1.0]);
    assert_eq!(part.model.edges[0].curve, Curve::Line { from, to });
    for sign in [1.0, -1.0] {
        let at = |t: f64| plus([3.0, 1.0, 0.0], [2.0 * t.cos(), 0.0, sign * 2.0 * t.sin()]);
        let points: Vec<Vector> = (0..=40).map(|k| at(f64::from(k) * 0.1)).collect();
        let part = bordered(&points, ball);
        let curve = &part.model.edges[0].curve;
        let Curve::Arc(arc) = curve else {
            panic!("an arc")
        };
        let (centre, radius) = (arc.ellipse.centre, arc.ellipse.radii[0]);
        assert!(distance(centre, [3.0, 1.0, 0.0]) < 1e-12 && (radius - 2.0).abs() < 1e-12);
        assert!((arc.sweep - 4.0).abs() < 1e-12);
        for (p, k) in curve.sampled(4).into_iter().zip(0..) {
            assert!(distance(p, at(f64::from(k))) < 1e-12);
        }
    }
}
