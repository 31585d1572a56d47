//! The shadow of a cut quadric as a set of cut quadrics (source: 3.2.1).
//!
//! With the source s as a homogeneous point and Q the quadric's matrix, `g = Q s` is the polar plane of the source and,
//! for a plane p,
//!
//! ```text
//! K  = (s'Qs) Q - g g'                                     the cone that touches the quadric along the polar plane
//! Kp = (p.s)^2 Q - (p.s)(p g' + g p') + (s'Qs) p p'         the cone through the conic in the plane p
//! ```
//!
//! A ray from s that meets the cut solid meets it in its point of the polar plane, or where a cut plane bounds what the
//! planes leave of the ray. So the shadow is the union of
//!
//! * V0, if the source is outside the unbounded quadric: in K, beyond the polar plane, that point kept by every cut;
//! * Vi for every cut i: in Kp, beyond plane i, the ray's point of plane i kept by every other cut.
//!
//! "Kept by cut j" depends on the direction of the ray alone: it is a plane through the source. The union is exact
//! except inside the solid itself, where nothing is seen. A polyhedron, whose Q is zero, has the volumes of its lit
//! faces, without a cone. A facet of a mesh has one, whichever of its sides the source sees: its own plane is the cut,
//! and the others go through its sides.

use crate::prepared::Beginning;
use imogene_algebra::matrix::{Matrix4, SYMMETRIC, image};
use imogene_algebra::vector::{cross, dot, minus};
use imogene_algebra::whole::common_denominator;
use imogene_scene::{FramedFacet, FramedMesh, FramedQuadric, Plane, Quadric};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// A homogeneous vector: a point, or a plane `a x + b y + c z + d`.
type Vector = [BigInt; 4];

/// One volume of a shadow, in the camera frame.
#[derive(Clone, Debug)]
pub struct ShadowPart {
    /// Inside where it is not positive.
    pub quadric: Quadric,
    /// Kept where they are not positive. The volume begins at the first; the others pass through the source.
    pub planes: Vec<Plane>,
    /// Where the volume begins.
    pub beginning: Beginning,
}

/// The source lies in the cut solid, or the solid is endless towards it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SourceInside;

/// The parts of an object's shadow for the source at the homogeneous point.
pub fn shadow_parts(
    object: &FramedQuadric,
    source: &[BigRational; 4],
) -> Result<Vec<ShadowPart>, SourceInside> {
    let rays = Rays::new(object, source);
    if rays.source_is_inside() {
        // A cylinder along its light darkens nothing but its own inside.
        return if !rays.is_polyhedron() && rays.polar.iter().all(Zero::is_zero) {
            Ok(vec![])
        } else {
            Err(SourceInside)
        };
    }
    let mut parts = Vec::new();
    if rays.at_source.is_positive() {
        parts.push(rays.beyond_polar_plane());
    }
    // What lies behind a polyhedron lies behind one of its lit faces.
    let cuts = (0..rays.planes.len())
        .filter(|&index| !rays.is_polyhedron() || rays.planes_at_source[index].is_positive());
    parts.extend(cuts.filter_map(|index| rays.beyond_cut(index)));
    Ok(parts)
}

/// The parts of a mesh's shadow: one of each facet that the source does not see edge-on.
pub fn mesh_shadow_parts(mesh: &FramedMesh, source: &[BigRational; 4]) -> Vec<ShadowPart> {
    let parts = mesh.facets.iter().enumerate().filter_map(|(index, facet)| {
        let everywhere = Matrix4::default();
        let part = Rays::of(everywhere, around(mesh, facet), source).beyond_cut(0)?;
        Some(ShadowPart {
            beginning: Beginning::Facet(index),
            ..part
        })
    });
    parts.collect()
}

/// The plane of a facet, and one at a right angle to it through each of its sides, not positive on the facet.
fn around(mesh: &FramedMesh, facet: &FramedFacet) -> Vec<Vector> {
    let corner = |k: usize| &mesh.vertices[facet.corners[k % facet.corners.len()]];
    let through = |normal: &[BigRational; 3], point: &[BigRational; 3]| {
        let [a, b, c] = normal;
        common_denominator([a, b, c, &-dot(normal, point)]).0
    };
    let side = |k: usize| minus(corner(k + 1), corner(k));
    let normal = cross(side(0), side(1));
    let sides = (0..facet.corners.len()).map(|k| through(&cross(side(k), &normal), corner(k)));
    let own = [through(&normal, corner(0))];
    own.into_iter().chain(sides).collect()
}

struct Rays {
    q: Matrix4<BigInt>,
    /// s'Qs.
    at_source: BigInt,
    /// Q s.
    polar: Vector,
    planes: Vec<Vector>,
    /// p.s of each plane.
    planes_at_source: Vec<BigInt>,
}

impl Rays {
    fn new(object: &FramedQuadric, source: &[BigRational; 4]) -> Rays {
        let q = object.quadric.clone().primitive().matrix();
        let q = q.map(|row| row.map(|value| value.to_integer()));
        let planes = object.planes.iter();
        let planes = planes.map(|plane| common_denominator(plane.coefficients()).0);
        Rays::of(q, planes.collect(), source)
    }

    fn of(q: Matrix4<BigInt>, planes: Vec<Vector>, source: &[BigRational; 4]) -> Rays {
        let (source, _) = common_denominator(source.each_ref());
        let polar = image(&q, &source);
        Rays {
            at_source: dot(&polar, &source),
            planes_at_source: planes.iter().map(|plane| dot(plane, &source)).collect(),
            q,
            polar,
            planes,
        }
    }

    /// The quadric is everywhere: planes alone bound the object.
    fn is_polyhedron(&self) -> bool {
        self.q.iter().flatten().all(Zero::is_zero)
    }

    fn source_is_inside(&self) -> bool {
        !self.at_source.is_positive() && self.planes_at_source.iter().all(|v| !v.is_positive())
    }

    fn beyond_polar_plane(&self) -> ShadowPart {
        let (sigma, g) = (&self.at_source, &self.polar);
        let cone = symmetric(|i, j| sigma * &self.q[i][j] - &g[i] * &g[j]);
        let mut planes = vec![plane(g.clone())];
        for (p, at) in self.planes.iter().zip(&self.planes_at_source) {
            planes.push(plane(std::array::from_fn(|k| sigma * &p[k] - at * &g[k])));
        }
        ShadowPart {
            quadric: cone,
            planes,
            beginning: Beginning::PolarPlane,
        }
    }

    /// `None` if the plane passes through the source: no ray crosses it.
    fn beyond_cut(&self, index: usize) -> Option<ShadowPart> {
        let (p, at) = (&self.planes[index], &self.planes_at_source[index]);
        if at.is_zero() {
            return None;
        }
        let (sigma, g, square) = (&self.at_source, &self.polar, at * at);
        let cone = symmetric(|i, j| {
            &square * &self.q[i][j] - at * (&p[i] * &g[j] + &g[i] * &p[j]) + sigma * &p[i] * &p[j]
        });
        let side = at.signum();
        let mut planes = vec![plane(p.each_ref().map(|v| &side * v))];
        for (j, (other, other_at)) in self.planes.iter().zip(&self.planes_at_source).enumerate() {
            if j != index {
                planes.push(plane(std::array::from_fn(|k| {
                    &side * (at * &other[k] - other_at * &p[k])
                })));
            }
        }
        Some(ShadowPart {
            quadric: cone,
            planes,
            beginning: Beginning::Cut(index),
        })
    }
}

fn symmetric(entry: impl Fn(usize, usize) -> BigInt) -> Quadric {
    Quadric::from_array(SYMMETRIC.map(|[i, j]| entry(i, j).into())).primitive()
}

fn plane(values: Vector) -> Plane {
    let [a, b, c, d] = values.map(BigRational::from_integer);
    Plane { a, b, c, d }.primitive()
}
