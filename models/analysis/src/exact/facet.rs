//! A mesh along one line of sight: flat facets with corners where they truly are, in exact integers.

use super::number::SurdReal;
use super::ray::{Hit, coprime, dot, first_degree, is_visible, ray_points};
use imogene_algebra::rational::{integer, to_f64};
use imogene_algebra::vector::{self, Vector, cross, minus};
use imogene_algebra::whole::common_denominator;
use imogene_golden::object::facet::FACE_FACET;
use imogene_golden::object::quadric::ScreenBox;
use imogene_scene::{FramedFacet, FramedMesh, FramedScene, Projection};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

type Point = [BigRational; 3];

/// The facets of a mesh along the rays of a screen.
#[derive(Clone, Debug)]
pub struct RayMesh {
    pub(crate) facets: Vec<RayFacet>,
}

/// One facet: on its inner side no edge is negative, and its plane is met where `slope w + constant` is zero.
#[derive(Clone, Debug)]
pub(crate) struct RayFacet {
    index: usize,
    pub window: ScreenBox,
    pub edges: Vec<[BigInt; 3]>,
    pub plane: [[BigInt; 3]; 2],
}

impl RayMesh {
    /// Sets up the rays of a scene's screen. A facet with a corner that is not before the viewer, which the preparation
    /// refuses, is left out, as is one that is a line on the screen.
    pub fn new(mesh: &FramedMesh, scene: &FramedScene) -> RayMesh {
        let rays = ray_points(scene);
        let first = [scene.width, scene.height].map(|n| -integer(i64::from(n)) / integer(2));
        // Column and line at which a point is seen; `None` if it is not before the viewer.
        let seen = |[x, y, z]: &Point| {
            let closer = match &scene.projection {
                Projection::Perspective { distance } if !(distance + z).is_positive() => {
                    return None;
                }
                Projection::Perspective { distance } => distance / (distance + z),
                Projection::Orthographic { .. } => integer(1),
            };
            Some([x * &closer - &first[0], y * &closer - &first[1]])
        };
        let seen: Vec<Option<[BigRational; 2]>> = mesh.vertices.iter().map(seen).collect();
        let facet = |(index, facet): (usize, &FramedFacet)| {
            let corners: Option<Vec<[BigRational; 2]>> =
                facet.corners.iter().map(|&k| seen[k].clone()).collect();
            let [p, q, r] = [0, 1, 2].map(|k| &mesh.vertices[facet.corners[k]]);
            let [a, b, c] = &cross(minus(q, p), minus(r, p));
            let d = -vector::dot([a, b, c].map(Clone::clone), p);
            let (factors, _) = common_denominator([a, b, c, &d]);
            let (constant, slope) = &rays;
            Some(RayFacet {
                index,
                edges: edges(corners.as_ref()?)?,
                window: window(corners.as_ref()?),
                plane: coprime([dot(&factors, slope), dot(&factors, constant)]),
            })
        };
        RayMesh {
            facets: mesh.facets.iter().enumerate().filter_map(facet).collect(),
        }
    }

    /// The first visible point of the mesh at a pixel; edges belong to their facets.
    pub fn first_hit(&self, x: i64, y: i64) -> Option<Hit> {
        let hits = self.facets.iter().filter_map(|facet| facet.hit(x, y));
        // The first of equal ones.
        hits.min_by(|one, other| one.w.cmp(&other.w))
    }
}

impl RayFacet {
    /// The visible point of this facet alone.
    pub fn hit(&self, x: i64, y: i64) -> Option<Hit> {
        let within = |edge| !first_degree(edge, x, y).is_negative();
        if !self.window.contains(x, y) || !self.edges.iter().all(within) {
            return None;
        }
        let [slope, constant] = self.plane.each_ref().map(|p| first_degree(p, x, y));
        if slope.is_zero() {
            return None;
        }
        let w = SurdReal::ratio(-constant, slope);
        is_visible(&w).then(|| Hit {
            part: self.index,
            ..Hit::new(w, FACE_FACET)
        })
    }
}

/// The sides, not negative inside; `None` if the corners are in a line.
fn edges(corners: &[[BigRational; 2]]) -> Option<Vec<[BigInt; 3]>> {
    let n = corners.len();
    let side = |k: usize| -> Point {
        let ([px, py], [qx, qy]) = (&corners[k], &corners[(k + 1) % n]);
        [py - qy, qx - px, px * qy - qx * py]
    };
    let [x, y] = &corners[2];
    let [a, b, c] = side(0);
    let turn = a * x + b * y + c;
    if turn.is_zero() {
        return None;
    }
    let inner = |k: usize| {
        let (side, _) = common_denominator(side(k).each_ref());
        let [form] = coprime([side]);
        form.map(|v| if turn.is_negative() { -v } else { v })
    };
    Some((0..n).map(inner).collect())
}

/// The pixels about the corners, a pixel more on each side.
fn window(corners: &[[BigRational; 2]]) -> ScreenBox {
    let at = |value: &BigRational| value.floor().to_integer().to_i64();
    let bound = |axis: usize| {
        let all = || corners.iter().map(|c| &c[axis]);
        let least = all().min().and_then(at).unwrap_or(i64::MIN);
        let greatest = all().max().and_then(at);
        [least, greatest.map_or(i64::MAX, |v| v.saturating_add(1))]
    };
    ScreenBox::of(bound(0), bound(1))
}

/// Normals of a mesh: those of its corners, weighted by the place within the facet, or the facet's own.
pub(super) struct MeshNormals<'a> {
    mesh: &'a FramedMesh,
    vertices: Vec<[f64; 3]>,
}

impl MeshNormals<'_> {
    pub fn new(mesh: &FramedMesh) -> MeshNormals<'_> {
        let vertices = mesh.vertices.iter().map(|v| v.each_ref().map(to_f64));
        MeshNormals {
            mesh,
            vertices: vertices.collect(),
        }
    }

    /// The direction at a point of a facet.
    pub fn at(&self, facet: usize, point: [f64; 3]) -> [f64; 3] {
        let facet = &self.mesh.facets[facet];
        let Some(normals) = &self.mesh.normals else {
            return facet.normal.map(f64::from);
        };
        let weigh = |triangle: [usize; 3]| {
            let corners = triangle.map(|k| facet.corners[k]);
            let weights = barycentric(corners.map(|k| self.vertices[k]), point);
            let least = weights.into_iter().fold(f64::INFINITY, f64::min);
            let sum = std::array::from_fn(|axis| {
                let terms = corners.iter().zip(weights);
                terms.map(|(&k, w)| w * f64::from(normals[k][axis])).sum()
            });
            (least, sum)
        };
        let one = weigh([0, 1, 2]);
        let other = (facet.corners.len() == 4).then(|| weigh([0, 2, 3]));
        other.filter(|other| other.0 > one.0).unwrap_or(one).1
    }
}

fn barycentric([p, q, r]: [Vector; 3], point: Vector) -> Vector {
    let dot = |u: Vector, v: Vector| vector::dot(u, v);
    let (u, v, w) = (minus(q, p), minus(r, p), minus(point, p));
    let (uu, uv, vv, wu, wv) = (dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v));
    let area = uu * vv - uv * uv;
    let (b, c) = ((vv * wu - uv * wv) / area, (uu * wv - uv * wu) / area);
    [1.0 - b - c, b, c]
}
