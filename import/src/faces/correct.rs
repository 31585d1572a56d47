//! What a file says in a wrong or a long way: which side of its border a face of a sphere or a torus is on, where its
//! words contradict themselves, and splines that are lines, lie in a plane or are circles but for its digits.
//!
//! Both sides of such a border are bounded: the direction of the loops alone says which is the face. Some systems
//! write left-handed surfaces, which a file cannot express, with loops that run the wrong way round. Two things tell: a
//! seam lies within its face, and the two faces of an edge pass it in opposite directions.

use super::curve::{arc_through, common_plane};
use super::model::reversed;
use super::vector::*;
use super::{Curve, EdgeUse, Face, Model, PlaneOf, Polyline};

/// Turns round the loops of faces that are on the other side of their borders.
pub fn orient(model: &mut Model) {
    for index in 0..model.faces.len() {
        let face = &model.faces[index];
        if !is_oriented(face) {
            continue;
        }
        let seams = seam_votes(model, face);
        if seams < 0 || (seams == 0 && neighbour_votes(model, index) < 0) {
            for own in &mut model.faces[index].loops {
                *own = reversed(own);
            }
        }
    }
}

fn is_oriented(face: &Face) -> bool {
    face.surface.is_sphere() || face.surface.is_torus()
}

/// Ends of an edge, each with the direction away from it along the curve.
fn ends(model: &Model, edge: usize) -> [(Vector, Vector); 2] {
    let points = model.edges[edge].curve.sampled(64);
    let last = points.len() - 1;
    [
        (points[0], unit(minus(points[1], points[0]))),
        (points[last], unit(minus(points[last - 1], points[last]))),
    ]
}

/// How many ends of seams are on the left of the border that they end at, less those on its right.
fn seam_votes(model: &Model, face: &Face) -> i32 {
    let border = face.border();
    let is_seam = |edge_use: &&EdgeUse| border.iter().all(|b| b.edge != edge_use.edge);
    let near = model.rounding().max(1e-7 * model.size());
    let mut votes = 0;
    for seam in face.loops.iter().flatten().filter(is_seam) {
        for (place, inwards) in ends(model, seam.edge) {
            let Some(normal) = face.surface.normal_at(place) else {
                continue;
            };
            for own in &border {
                for (end, (p, away)) in ends(model, own.edge).into_iter().enumerate() {
                    if distance(p, place) > near {
                        continue;
                    }
                    // The direction in which the loop passes the vertex.
                    let forward = own.forward == (end == 0);
                    let left = dot(cross(normal, away), inwards);
                    let left = if forward { left } else { -left };
                    // A seam that leaves along the border says nothing.
                    votes += i32::from(left > 1e-3) - i32::from(left < -1e-3);
                }
            }
        }
    }
    votes
}

/// How many edges the other faces pass in the opposite direction, less those that they pass in the same.
fn neighbour_votes(model: &Model, index: usize) -> i32 {
    // As seen from outside of the solid.
    let passed = |face: &Face, edge: usize| {
        let mut uses = face.loops.iter().flatten().filter(|u| u.edge == edge);
        let (first, second) = (uses.next()?, uses.next());
        second.is_none().then_some(first.forward != face.reversed)
    };
    let own = &model.faces[index];
    let mut votes = 0;
    for edge_use in own.border() {
        let Some(mine) = passed(own, edge_use.edge) else {
            continue;
        };
        for other in model.neighbours(index, edge_use.edge) {
            let other = &model.faces[other];
            if let Some(theirs) = passed(other, edge_use.edge).filter(|_| !is_oriented(other)) {
                votes += if mine == theirs { -1 } else { 1 };
            }
        }
    }
    votes
}

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
    let off = off_line(&own.points, from, unit(minus(to, from)));
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
    let count = points.len();
    let last = if own.closed { count * 2 / 3 } else { count - 1 };
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
