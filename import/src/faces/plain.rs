//! Edges that are simpler than their file says: splines that are lines, lie in a plane or are circles but for the
//! digits of the file.

use super::curve::{Curve, PlaneOf, Polyline, arc_through, common_plane};
use super::model::Model;
use super::vector::*;

/// Takes every edge that is given by points for the simplest that it is within a share of the part's size.
pub fn plain(model: &mut Model) {
    let tolerance = model.canonical();
    for index in 0..model.edges.len() {
        let Curve::Points(own) = &model.edges[index].curve else {
            continue;
        };
        let points = &own.points;
        let found = line(own, tolerance).or_else(|| {
            let plane = plane_of_face(model, index, points, tolerance)
                .or(own.plane)
                .or_else(|| common_plane(points, tolerance))?;
            let off = points.iter().map(|p| off_plane(*p, plane));
            let off = off.fold(0.0, f64::max);
            circle(own, plane, tolerance).or_else(|| {
                let points = points.iter().map(|p| onto_plane(*p, plane.0, plane.1));
                let line = Polyline {
                    points: points.collect(),
                    plane: Some(plane),
                    ..own.clone()
                };
                Some((Curve::Points(line), off))
            })
        });
        if let Some((curve, off)) = found {
            model.edges[index].curve = curve;
            model.edges[index].off = off;
        }
    }
}

fn off_plane(p: Vector, (origin, normal): PlaneOf) -> f64 {
    dot(minus(p, origin), normal).abs()
}

fn line(own: &Polyline, tolerance: f64) -> Option<(Curve, f64)> {
    let (from, to) = (own.points[0], own.points[own.points.len() - 1]);
    if own.closed || distance(from, to) <= 10.0 * tolerance {
        return None;
    }
    let course = unit(minus(to, from));
    let off = off_line(&own.points, from, course);
    (off <= tolerance).then_some((Curve::Line { from, to }, off))
}

/// The plane of a plane face that has the edge: what borders it is in it.
fn plane_of_face(model: &Model, edge: usize, points: &[Vector], tolerance: f64) -> Option<PlaneOf> {
    let faces = model.users[edge].iter();
    let mut planes = faces.filter_map(|face| model.faces[*face].surface.plane());
    planes.find(|plane| points.iter().all(|p| off_plane(*p, *plane) <= tolerance))
}

/// The circle through three places of a curve in a plane, if all others are on it.
fn circle(own: &Polyline, (origin, normal): PlaneOf, tolerance: f64) -> Option<(Curve, f64)> {
    let points = &own.points;
    if points.len() < 5 {
        return None;
    }
    let last = match own.closed {
        true => points.len() * 2 / 3,
        false => points.len() - 1,
    };
    let [a, b, c] = [0, last / 2, last].map(|k| onto_plane(points[k], origin, normal));
    let (u, v) = (minus(b, a), minus(c, a));
    let twice = cross(u, v);
    let square = dot(twice, twice);
    if square <= 1e-16 * dot(u, u) * dot(v, v) {
        return None;
    }
    let (first, second) = (cross(v, twice), cross(twice, u));
    let to_centre: Vector =
        std::array::from_fn(|k| (dot(u, u) * first[k] + dot(v, v) * second[k]) / (2.0 * square));
    let centre = plus(a, to_centre);
    let radius = length(to_centre);
    let off = points.iter().map(|p| {
        let flat = onto_plane(*p, origin, normal);
        distance(*p, flat).hypot(distance(flat, centre) - radius)
    });
    let off = off.fold(0.0, f64::max);
    // A circle that large is a line of too few digits.
    let size = distance(a, b).max(distance(b, c));
    let circle = (centre, normal);
    let arc = || arc_through(circle, radius, [a, points[1], c], Some(c), own.closed);
    (off <= tolerance && radius <= 1e4 * size).then(|| (arc(), off))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::faces::model::{Edge, EdgeUse, Face};
    use crate::faces::surface::{Form, Surface};

    /// One edge as the border of one face.
    fn part(points: Vec<Vector>, surface: Surface) -> Model {
        let edge = Edge {
            name: "#1".into(),
            kind: "points",
            curve: Curve::through(points, false, 1e-9),
            vertices: Some([0, 1]),
            off: 0.0,
        };
        let edge_use = EdgeUse {
            edge: 0,
            forward: true,
        };
        let face = Face {
            surface,
            loops: vec![vec![edge_use]],
            ..Face::default()
        };
        let model = Model {
            edges: vec![edge],
            faces: vec![face],
            ..Model::default()
        };
        let mut model = model.assembled().unwrap();
        plain(&mut model);
        model
    }

    /// A wave in the plane z = 2, off by so much, as the border of a face in that plane; the part has a size of
    /// about 3.
    #[test]
    fn what_is_in_a_plane_but_for_digits_is_in_the_plane() {
        let plane = Surface::new([0.0, 0.0, 2.0], [0.0, 0.0, -1.0], Form::Plane);
        for (off, flat) in [(1e-5, true), (1e-3, false)] {
            let point = |k: i32| {
                let x = f64::from(k) / 10.0;
                [x, x.sin(), 2.0 + off * (7.0 * x).cos()]
            };
            let model = part((0..=30).map(point).collect(), plane.clone());
            assert_eq!(model.edges[0].curve.plane().is_some(), flat);
            let heights = model.edges[0].curve.sampled(1).into_iter().map(|p| p[2]);
            assert_eq!(heights.into_iter().all(|z| z == 2.0), flat);
            assert_eq!(model.edges[0].off > 0.99e-5, flat);
        }
    }

    #[test]
    fn points_on_a_line_or_a_circle_are_one() {
        let ball = Surface::new([0.0; 3], [0.0, 0.0, 1.0], Form::Sphere(2.0));
        let row = (0..9).map(|k| [f64::from(k), 2.0 * f64::from(k), 1.0]);
        let row = row.collect();
        assert!(matches!(
            part(row, ball.clone()).edges[0].curve,
            Curve::Line {
                from: [0.0, 0.0, 1.0],
                to: [8.0, 16.0, 1.0]
            }
        ));
        for sign in [1.0, -1.0] {
            let at = |t: f64| plus([3.0, 1.0, 0.0], [2.0 * t.cos(), 0.0, sign * 2.0 * t.sin()]);
            let points = (0..=40).map(|k| at(f64::from(k) * 0.1)).collect();
            let model = part(points, ball.clone());
            let curve = &model.edges[0].curve;
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
}
