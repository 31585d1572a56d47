//! A model from its parts: who uses an edge, and how far everything reaches.

use super::build::hull;
use super::curve::Curve;
use super::model::{Edge, Face, Model, Solid, Up};
use super::surface::Surface;
use super::vector::{Vector, distance};
use imogene_scene::Material;

/// Least diagonal of the box around a part, scene units.
pub const SMALLEST_PART: f64 = 1e-6;

/// What a reader has found.
#[derive(Debug)]
pub struct Parts {
    /// Title.
    pub title: String,
    /// Which axis points up.
    pub up: Up,
    /// What the digits of the file leave open, scene units.
    pub precision: f64,
    /// What the file takes for the same place, scene units.
    pub uncertainty: f64,
    /// Materials.
    pub materials: Vec<Material>,
    /// Edges.
    pub edges: Vec<Edge>,
    /// Faces.
    pub faces: Vec<Face>,
    /// Solids.
    pub solids: Vec<Solid>,
}

/// For each edge, the faces that have it.
pub fn users(edges: usize, faces: &[Face]) -> Vec<Vec<usize>> {
    let mut users = vec![vec![]; edges];
    for (index, face) in faces.iter().enumerate() {
        for edge_use in face.loops.iter().flatten() {
            let own: &mut Vec<usize> = &mut users[edge_use.edge];
            if own.last() != Some(&index) {
                own.push(index);
            }
        }
    }
    users
}

/// The model; nothing if its faces have no size.
pub fn assemble(parts: Parts) -> Option<Model> {
    let Parts {
        title,
        up,
        precision,
        uncertainty,
        materials,
        edges,
        faces,
        solids,
    } = parts;
    let users = users(edges.len(), &faces);
    let bounds = bounds(&edges, &faces, &users);
    (distance(bounds[0], bounds[1]) >= SMALLEST_PART).then_some(Model {
        title,
        up,
        precision,
        uncertainty,
        materials,
        edges,
        faces,
        solids,
        users,
        bounds,
    })
}

fn bounds(edges: &[Edge], faces: &[Face], users: &[Vec<usize>]) -> [Vector; 2] {
    let mut points: Vec<Vector> = vec![];
    let used = edges
        .iter()
        .zip(users)
        .filter(|(_, users)| !users.is_empty());
    for (edge, _) in used {
        let steps = if matches!(edge.curve, Curve::Line { .. }) {
            1
        } else {
            32
        };
        points.extend(edge.curve.sampled(steps));
    }
    for face in faces.iter().filter(|face| face.loops.is_empty()) {
        let (middle, reach) = match face.surface {
            Surface::Sphere { centre, radius } => (centre, [radius; 3]),
            // A disc across the axis, and the tube around its rim.
            Surface::Torus {
                centre,
                axis,
                major,
                minor,
            } => (
                centre,
                axis.map(|a| major * (1.0 - a * a).max(0.0).sqrt() + minor),
            ),
            _ => continue,
        };
        points.push(std::array::from_fn(|k| middle[k] - reach[k]));
        points.push(std::array::from_fn(|k| middle[k] + reach[k]));
    }
    hull(points.into_iter()).unwrap_or([[0.0; 3]; 2])
}
