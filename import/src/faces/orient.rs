//! Which side of its border a face of a sphere or a torus is on, where the words of a file contradict themselves.
//!
//! Both sides of such a border are bounded, so that the direction of the loops alone says which is the face. Some
//! systems write surfaces with left-handed frames, which a file cannot express, and with them loops that run the wrong
//! way round. Two things tell: a seam lies within its face, and an edge is passed in opposite directions by the two
//! faces that have it.

use super::model::{EdgeUse, Face, Model, reversed};
use super::vector::{Vector, cross, distance, dot, minus, unit};

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
