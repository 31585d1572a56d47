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
