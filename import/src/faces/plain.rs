//! Edges that are simpler than their file says: splines that are lines, lie in a plane or are circles but for the
//! digits of the file.

use super::curve::{Curve, common_plane};
use super::model::Model;
use super::surface::Surface;
use super::vector::{
    Vector, across, cross, distance, dot, length, minus, onto_plane, positive_angle, unit,
};
use std::f64::consts::TAU;

/// Takes every edge that is given by points for the simplest that it is within a share of the part's size.
pub fn plain(model: &mut Model) {
    let tolerance = model.canonical();
    for index in 0..model.edges.len() {
        let Curve::Points {
            points,
            closed,
            plane,
            slack,
        } = &model.edges[index].curve
        else {
            continue;
        };
        let found = line(points, *closed, tolerance).or_else(|| {
            let plane = plane_of_face(model, index, points, tolerance)
                .or(*plane)
                .or_else(|| common_plane(points, tolerance))?;
            let (origin, normal) = plane;
            let off = points
                .iter()
                .map(|p| dot(minus(*p, origin), normal).abs())
                .fold(0.0, f64::max);
            circle(points, *closed, plane, tolerance).or_else(|| {
                let points = points.iter().map(|p| onto_plane(*p, origin, normal));
                let curve = Curve::Points {
                    points: points.collect(),
                    closed: *closed,
                    plane: Some(plane),
                    slack: *slack,
                };
                Some((curve, off))
            })
        });
        if let Some((curve, off)) = found {
            model.edges[index].curve = curve;
            model.edges[index].off = off;
        }
    }
}

fn line(points: &[Vector], closed: bool, tolerance: f64) -> Option<(Curve, f64)> {
    let (from, to) = (points[0], points[points.len() - 1]);
    if closed || distance(from, to) <= 10.0 * tolerance {
        return None;
    }
    let course = unit(minus(to, from));
    let off = points
        .iter()
        .map(|p| length(across(minus(*p, from), course)))
        .fold(0.0, f64::max);
    (off <= tolerance).then_some((Curve::Line { from, to }, off))
}

/// The plane of a plane face that has the edge: what borders it is in it.
fn plane_of_face(
    model: &Model,
    edge: usize,
    points: &[Vector],
    tolerance: f64,
) -> Option<(Vector, Vector)> {
    model.users[edge]
        .iter()
        .find_map(|face| match model.faces[*face].surface {
            Surface::Plane { origin, normal } => points
                .iter()
                .all(|p| dot(minus(*p, origin), normal).abs() <= tolerance)
                .then_some((origin, normal)),
            _ => None,
        })
}

/// The circle through three places of a curve in a plane, if all others are on it.
fn circle(
    points: &[Vector],
    closed: bool,
    (origin, normal): (Vector, Vector),
    tolerance: f64,
) -> Option<(Curve, f64)> {
    if points.len() < 5 {
        return None;
    }
    let last = if closed {
        points.len() * 2 / 3
    } else {
        points.len() - 1
    };
    let [a, b, c] = [0, last / 2, last].map(|k| onto_plane(points[k], origin, normal));
    let (u, v) = (minus(b, a), minus(c, a));
    let twice = cross(u, v);
    let square = dot(twice, twice);
    if square <= 1e-16 * dot(u, u) * dot(v, v) {
        return None;
    }
    let to_centre: Vector = std::array::from_fn(|k| {
        let (first, second) = (cross(v, twice), cross(twice, u));
        (dot(u, u) * first[k] + dot(v, v) * second[k]) / (2.0 * square)
    });
    let centre: Vector = std::array::from_fn(|k| a[k] + to_centre[k]);
    let radius = length(to_centre);
    let off = points
        .iter()
        .map(|p| {
            let flat = onto_plane(*p, origin, normal);
            distance(*p, flat).hypot(distance(flat, centre) - radius)
        })
        .fold(0.0, f64::max);
    // A circle that large is a line of too few digits.
    let size = distance(a, b).max(distance(b, c));
    if off > tolerance || radius > 1e4 * size {
        return None;
    }
    let x = unit(minus(a, centre));
    let angle = |p: Vector, normal: Vector| {
        let from = minus(p, centre);
        positive_angle(dot(from, cross(normal, x)).atan2(dot(from, x)))
    };
    let normal = if angle(points[1], normal) < angle(c, normal) {
        normal
    } else {
        normal.map(|v| 0.0 - v)
    };
    let sweep = if closed { TAU } else { angle(c, normal) };
    let curve = Curve::Arc {
        centre,
        normal,
        x,
        radii: [radius; 2],
        start: 0.0,
        sweep,
    };
    Some((curve, off))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::faces::assemble::{Parts, assemble};
    use crate::faces::model::{Edge, EdgeUse, Face, Up};
    use crate::faces::vector::plus;

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
            name: "#2".into(),
            surface,
            loops: vec![vec![edge_use]],
            reversed: false,
            material: None,
            off: 0.0,
            refused: None,
        };
        let parts = Parts {
            title: String::new(),
            up: Up::Z,
            precision: 0.0,
            uncertainty: 0.0,
            materials: vec![],
            edges: vec![edge],
            faces: vec![face],
            solids: vec![],
        };
        let mut model = assemble(parts).unwrap();
        plain(&mut model);
        model
    }

    /// A wave in the plane z = 2, off by so much, as the border of a face in that plane; the part has a size of
    /// about 3.
    #[test]
    fn what_is_in_a_plane_but_for_digits_is_in_the_plane() {
        let plane = Surface::Plane {
            origin: [0.0, 0.0, 2.0],
            normal: [0.0, 0.0, -1.0],
        };
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
        let ball = Surface::Sphere {
            centre: [0.0; 3],
            radius: 2.0,
        };
        let row = (0..9)
            .map(|k| [f64::from(k), 2.0 * f64::from(k), 1.0])
            .collect();
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
            let Curve::Arc {
                centre,
                radii,
                sweep,
                ..
            } = curve
            else {
                panic!("an arc")
            };
            assert!(distance(*centre, [3.0, 1.0, 0.0]) < 1e-12 && (radii[0] - 2.0).abs() < 1e-12);
            assert!((sweep - 4.0).abs() < 1e-12);
            for (p, k) in curve.sampled(4).into_iter().zip(0..) {
                assert!(distance(p, at(f64::from(k))) < 1e-12);
            }
        }
    }
}
