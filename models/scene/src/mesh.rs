//! Meshes: flat facets with common corners, in the camera frame.

use super::shape::Mesh;
use super::transform::Transform;
use imogene_algebra::matrix::{cofactors3, image, transposed};
use imogene_algebra::rational::from_decimal;
use imogene_algebra::vector::{cross, dot, minus, normalised};
use imogene_algebra::whole::scaled;
use imogene_contract::words::NORMAL_LENGTH;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

type Point = [BigRational; 3];

/// A mesh in the camera frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FramedMesh {
    /// Unique name.
    pub name: String,
    /// Index of the material.
    pub material: usize,
    /// Corners.
    pub vertices: Vec<Point>,
    /// A normal for each corner, if they are interpolated.
    pub normals: Option<Vec<[i16; 3]>>,
    /// Facets in the order of the file; a face that is not plane, or not convex, is two of them.
    pub facets: Vec<FramedFacet>,
    /// Whether it keeps the light of sources with shadows off others.
    pub casts_shadow: bool,
}

/// One flat facet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FramedFacet {
    /// Index of the face in the file.
    pub face: usize,
    /// Three corners, or the four corners of a plane convex quadrangle, as indices of vertices.
    ///
    /// A quadrangle that has to be split is split from the first corner to the third.
    pub corners: Vec<usize>,
    /// Its normal.
    pub normal: [i16; 3],
}

pub(super) enum Face {
    /// A triangle, or a quadrangle that is plane and convex, from this corner on.
    Flat(usize),
    /// A quadrangle of two triangles that meet in the diagonal from this corner.
    Folded(usize),
}

impl FramedMesh {
    /// A mesh whose faces are checked.
    pub(super) fn new(
        (name, material): (&str, usize),
        mesh: &Mesh,
        to_camera: &Transform,
        casts_shadow: bool,
    ) -> FramedMesh {
        let local: Vec<Point> = mesh.vertices.iter().map(|v| v.map(from_decimal)).collect();
        let vertices: Vec<Point> = local.iter().map(|v| to_camera.point(v)).collect();
        let mut facets = vec![];
        for (face, indices) in mesh.faces.iter().enumerate() {
            for corners in parts(&local, indices) {
                let p = |k: usize| &vertices[corners[k]];
                facets.push(FramedFacet {
                    face,
                    normal: full_length(&cross(minus(p(1), p(0)), minus(p(2), p(0)))),
                    corners,
                });
            }
        }
        let turned = |n: &[f64; 3]| full_length(&turned_normal(n, to_camera));
        FramedMesh {
            name: name.to_owned(),
            material,
            vertices,
            normals: (!mesh.normals.is_empty()).then(|| mesh.normals.iter().map(turned).collect()),
            facets,
            casts_shadow,
        }
    }
}

/// The facets of a face, as indices of vertices.
fn parts(vertices: &[Point], corners: &[usize]) -> Vec<Vec<usize>> {
    let from = |first: usize, which: &[usize]| -> Vec<usize> {
        let corner = |k: &usize| corners[(first + k) % corners.len()];
        which.iter().map(corner).collect()
    };
    match face(vertices, corners) {
        Some(Face::Folded(first)) => vec![from(first, &[0, 1, 2]), from(first, &[0, 2, 3])],
        Some(Face::Flat(first)) if corners.len() == 4 => vec![from(first, &[0, 1, 2, 3])],
        _ => vec![corners.to_vec()],
    }
}

/// What the face of these corners is; `None` if it has no area, or is a quadrangle whose sides cross.
pub(super) fn face(vertices: &[Point], corners: &[usize]) -> Option<Face> {
    let p = |k: usize| &vertices[corners[k % corners.len()]];
    let turn = |k: usize, l: usize, m: usize| cross(minus(p(l), p(k)), minus(p(m), p(k)));
    if corners.len() == 3 {
        return (!turn(0, 1, 2).iter().all(Zero::is_zero)).then_some(Face::Flat(0));
    }
    // Twice the area of the quadrangle as a vector: what its triangles must turn with.
    let area = cross(minus(p(2), p(0)), minus(p(3), p(1)));
    let ahead = |k: usize, l: usize, m: usize| dot(turn(k, l, m), &area).is_positive();
    let halves = |k: usize| ahead(k, k + 1, k + 2) && ahead(k, k + 2, k + 3);
    let plane = dot(turn(0, 1, 2), minus(p(3), p(0))).is_zero();
    match (halves(0), halves(1)) {
        (true, true) if plane => Some(Face::Flat(0)),
        (true, _) => Some(Face::Folded(0)),
        (false, true) => Some(Face::Folded(1)),
        (false, false) => None,
    }
}

/// A normal is turned as a plane is: by the cofactors, whose sign a mirror changes.
fn turned_normal(normal: &[f64; 3], transform: &Transform) -> Point {
    let columns = transform.columns();
    let cofactors = cofactors3(&columns);
    let sign = dot(&cofactors[0], &columns[0]).signum();
    image(&transposed(&cofactors), &normal.map(from_decimal)).map(|sum| sum * &sign)
}

/// The direction in 16-bit components, of the length that facets have.
fn full_length(vector: &Point) -> [i16; 3] {
    let unit = normalised(scaled(vector.each_ref()));
    unit.map(|v| (v * NORMAL_LENGTH as f64).round() as i16)
}
