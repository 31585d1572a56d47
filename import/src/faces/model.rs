//! A face list that has been checked: faces on surfaces, bounded by edges that they share.

use super::curve::Curve;
use super::surface::{Form, Surface};
use super::vector::{Vector, distance, hull, plus, times};
use imogene_scene::Material;

/// Share of a part's size within which two things coincide: ten times the last digits of a number of 15.
pub const COINCIDENT: f64 = 1e-9;

/// Share of the size of a part by which a surface may be off the quadric that it is taken for.
pub const MOST_CANONICAL: f64 = 1e-5;

/// Least diagonal of the box around a part, scene units.
const SMALLEST_PART: f64 = 1e-6;

/// A face list.
#[derive(Clone, Debug, Default)]
pub struct Model {
    /// Title.
    pub title: String,
    /// z points up in a picture, as in CAD systems, and not y, as in scenes.
    pub z_up: bool,
    /// What the digits of the file leave open, scene units; 0 if they are those of double precision.
    pub precision: f64,
    /// What the file takes for the same place, scene units; 0 if it does not say.
    pub uncertainty: f64,
    /// Materials.
    pub materials: Vec<Material>,
    /// Edges.
    pub edges: Vec<Edge>,
    /// Faces, each of exactly one solid.
    pub faces: Vec<Face>,
    /// Solids.
    pub solids: Vec<Solid>,
    /// For each edge, the faces that have it.
    pub users: Vec<Vec<usize>>,
    /// Least and greatest coordinates of vertices, edges and spheres.
    pub bounds: [Vector; 2],
}

/// One description of a common edge.
#[derive(Clone, Debug)]
pub struct Edge {
    /// Name.
    pub name: String,
    /// Its course.
    pub curve: Curve,
    /// How far the curve of the file is off its course at most, scene units; 0 if it is the same.
    pub off: f64,
    /// Indices of the vertices at its ends, twice the same if it is closed at a vertex; nothing without vertices.
    pub vertices: Option<[usize; 2]>,
}

/// An edge in a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EdgeUse {
    /// Index of the edge.
    pub edge: usize,
    /// From its start to its end.
    pub forward: bool,
}

/// A face.
#[derive(Clone, Debug, Default)]
pub struct Face {
    /// Name.
    pub name: String,
    /// What it lies on.
    pub surface: Surface,
    /// Its borders; the face is on their left for an observer on the side of the surface's own normal.
    pub loops: Vec<Vec<EdgeUse>>,
    /// The material is on the side of the surface's own normal.
    pub reversed: bool,
    /// Name of its material, if it is not that of its solid.
    pub material: Option<String>,
    /// How far the surface of the file is off this one at most, scene units; 0 if it is the same.
    pub off: f64,
    /// Why its file's words make no face that could be drawn; its surface is then one that is named only.
    pub refused: Option<String>,
}

/// Faces of one material.
#[derive(Clone, Debug)]
pub struct Solid {
    /// Name.
    pub name: String,
    /// Name of the material.
    pub material: String,
    /// Indices of its faces.
    pub faces: Vec<usize>,
}

/// A loop the other way round.
pub fn reversed(uses: &[EdgeUse]) -> Vec<EdgeUse> {
    let turned = |own: &EdgeUse| EdgeUse {
        forward: !own.forward,
        ..*own
    };
    uses.iter().rev().map(turned).collect()
}

impl Face {
    /// The edges that bound it: an edge that the face has on both sides, a seam, bounds nothing.
    pub fn border(&self) -> Vec<EdgeUse> {
        border(self.loops.iter().flatten().copied())
    }
}

/// Edges that occur an odd number of times.
pub fn border(uses: impl Iterator<Item = EdgeUse>) -> Vec<EdgeUse> {
    let mut single: Vec<EdgeUse> = vec![];
    for edge_use in uses {
        match single.iter().position(|s| s.edge == edge_use.edge) {
            Some(index) => {
                single.remove(index);
            }
            None => single.push(edge_use),
        }
    }
    single
}

impl Model {
    /// With its users and bounds, from all else; `None` if its faces have no size.
    pub fn assembled(mut self) -> Option<Model> {
        self.users = vec![vec![]; self.edges.len()];
        for (index, face) in self.faces.iter().enumerate() {
            for edge_use in face.loops.iter().flatten() {
                let own = &mut self.users[edge_use.edge];
                if own.last() != Some(&index) {
                    own.push(index);
                }
            }
        }
        self.bounds = hull(&self.outline()).unwrap_or_default();
        (self.size() >= SMALLEST_PART).then_some(self)
    }

    /// Points of all edges, and the corners of boxes around whole spheres and tori.
    fn outline(&self) -> Vec<Vector> {
        let used = self.edges.iter().zip(&self.users);
        let used = used.filter(|(_, users)| !users.is_empty());
        let sampled = |edge: &Edge| match edge.curve {
            Curve::Line { .. } => edge.curve.sampled(1),
            _ => edge.curve.sampled(32),
        };
        let mut points: Vec<Vector> = used.flat_map(|(edge, _)| sampled(edge)).collect();
        for face in self.faces.iter().filter(|face| face.loops.is_empty()) {
            let Surface { origin, axis, .. } = face.surface;
            let reach = match face.surface.form {
                Form::Sphere(radius) => [radius; 3],
                // A disc across the axis, and the tube around its rim.
                Form::Torus(major, minor) => {
                    axis.map(|a| major * (1.0 - a * a).max(0.0).sqrt() + minor)
                }
                _ => continue,
            };
            points.push(std::array::from_fn(|k| origin[k] - reach[k]));
            points.push(plus(origin, reach));
        }
        points
    }

    /// Points of edges.
    pub fn places<'a>(
        &self,
        edges: impl IntoIterator<Item = &'a EdgeUse>,
        steps: usize,
    ) -> Vec<Vector> {
        let curves = edges.into_iter().map(|own| &self.edges[own.edge].curve);
        curves.flat_map(|curve| curve.sampled(steps)).collect()
    }

    /// Length of the diagonal of the box around everything, scene units, above 0.
    pub fn size(&self) -> f64 {
        distance(self.bounds[0], self.bounds[1])
    }

    /// What is off by no more than this is off by the rounding of the file's numbers, scene units.
    pub fn rounding(&self) -> f64 {
        (COINCIDENT * self.size()).max(self.precision)
    }

    /// Most that a surface or an edge may be off the one it is taken for, scene units.
    pub fn canonical(&self) -> f64 {
        MOST_CANONICAL * self.size()
    }

    /// The material of a face.
    pub fn material(&self, solid: usize, face: usize) -> &str {
        let own = self.faces[face].material.as_ref();
        own.unwrap_or(&self.solids[solid].material)
    }

    /// Middle of that box.
    pub fn middle(&self) -> Vector {
        times(0.5, plus(self.bounds[0], self.bounds[1]))
    }

    /// Faces other than `face` that have an edge.
    pub fn neighbours(&self, face: usize, edge: usize) -> impl Iterator<Item = usize> + '_ {
        let all = self.users[edge].iter().copied();
        all.filter(move |other| *other != face)
    }
}
