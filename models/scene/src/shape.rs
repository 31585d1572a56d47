//! What an object is: its kind, the numbers of its kind, and the planes that cut it.

use super::keys::numbers;
use serde::{Deserialize, Serialize};

/// Whether an object is the cut volume or only the cut surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Surface {
    /// The volume: a cut shows a flat face.
    #[default]
    Solid,
    /// The surface alone: a cut opens it, and its inner wall shows.
    Patch,
}

/// The processor that draws an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Processor {
    /// The quadric processor of the second generation.
    Quadric,
    /// The patch processor.
    Patch,
    /// The quadric processor of the first generation.
    FirstGeneration,
    /// The sphere or the cylinder processor, by paraboloids.
    Paraboloid,
    /// The processor of non-planar facets.
    CurvedFacet,
}

/// Flat facets with common corners.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corners.
    pub vertices: Vec<[f64; 3]>,
    /// Facets of three or four corners, as indices of vertices from 0.
    pub faces: Vec<Vec<usize>>,
    /// A normal for each vertex, interpolated over the facets; flat facets if there are none.
    pub normals: Vec<[f64; 3]>,
}

/// What an object is. The quadrics are in canonical position, inside where the expression is negative or zero (thesis
/// Table 2.1); their families have the half axes A, B and C, or A and C.
///
/// Axes of revolution, of two-sheetedness and of rulings of the cylinders all lie along the local y axis.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// `x^2/A^2 + y^2/B^2 + z^2/C^2 - 1`
    Ellipsoid([f64; 3]),
    /// `x^2 + y^2 + z^2 - R^2`
    Sphere {
        /// R.
        radius: f64,
    },
    /// `x^2/A^2 + z^2/C^2 - 1`
    EllipticCylinder([f64; 2]),
    /// `x^2/A^2 - z^2/C^2 - 1`, the part that contains the y axis.
    HyperbolicCylinder([f64; 2]),
    /// `x^2/A^2 - z/C`, open towards +z.
    ParabolicCylinder([f64; 2]),
    /// `x^2/A^2 - y^2/B^2 + z^2/C^2`, both halves, apex at the origin.
    Cone([f64; 3]),
    /// `x^2/A^2 - y^2/B^2 + z^2/C^2 - 1`, the part that contains the y axis.
    HyperboloidOneSheet([f64; 3]),
    /// `x^2/A^2 - y^2/B^2 + z^2/C^2 + 1`, tips at y = -B and y = B.
    HyperboloidTwoSheets([f64; 3]),
    /// `x^2/A^2 + z^2/C^2 - y/B`, open towards +y.
    EllipticParaboloid([f64; 3]),
    /// `x^2/A^2 - z^2/C^2 - y/B`, the part above the saddle.
    HyperbolicParaboloid([f64; 3]),
    /// `a x^2 + b y^2 + c z^2 + 2d xy + 2e xz + 2f yz + 2g x + 2h y + 2i z + j`
    Quadric {
        /// a to j.
        coefficients: [f64; 10],
    },
    /// The convex solid that the cuts leave.
    Polyhedron,
    /// Flat facets.
    Mesh(Mesh),
    /// The quadric `sum of w_ii b_i^2 + sum of w_ij 2 b_i b_j = 0` inside a tetrahedron, b the barycentric coordinates
    /// of its corners.
    TetrahedronPatch {
        /// Corners 0 to 3.
        corners: Box<[[f64; 3]; 4]>,
        /// w00, w11, w22, w33, w01, w02, w03, w12, w13, w23.
        weights: Box<[f64; 10]>,
    },
}

impl Shape {
    /// The half axes of a family that has two or three.
    pub(crate) fn radii(&self) -> Option<&[f64]> {
        match self {
            Shape::EllipticCylinder(radii)
            | Shape::HyperbolicCylinder(radii)
            | Shape::ParabolicCylinder(radii) => Some(radii),
            Shape::Ellipsoid(radii)
            | Shape::Cone(radii)
            | Shape::HyperboloidOneSheet(radii)
            | Shape::HyperboloidTwoSheets(radii)
            | Shape::EllipticParaboloid(radii)
            | Shape::HyperbolicParaboloid(radii) => Some(radii),
            _ => None,
        }
    }

    pub(crate) fn kind(&self) -> Kind {
        match self {
            Shape::Ellipsoid { .. } => Kind::Ellipsoid,
            Shape::Sphere { .. } => Kind::Sphere,
            Shape::EllipticCylinder { .. } => Kind::EllipticCylinder,
            Shape::HyperbolicCylinder { .. } => Kind::HyperbolicCylinder,
            Shape::ParabolicCylinder { .. } => Kind::ParabolicCylinder,
            Shape::Cone { .. } => Kind::Cone,
            Shape::HyperboloidOneSheet { .. } => Kind::HyperboloidOneSheet,
            Shape::HyperboloidTwoSheets { .. } => Kind::HyperboloidTwoSheets,
            Shape::EllipticParaboloid { .. } => Kind::EllipticParaboloid,
            Shape::HyperbolicParaboloid { .. } => Kind::HyperbolicParaboloid,
            Shape::Quadric { .. } => Kind::Quadric,
            Shape::Polyhedron => Kind::Polyhedron,
            Shape::Mesh(_) => Kind::Mesh,
            Shape::TetrahedronPatch { .. } => Kind::TetrahedronPatch,
        }
    }
}

/// A cut plane in local coordinates: the part on the side of the normal is removed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cut {
    /// A point of the plane.
    #[serde(deserialize_with = "numbers")]
    pub point: [f64; 3],
    /// Outward normal, of any length.
    #[serde(deserialize_with = "numbers")]
    pub normal: [f64; 3],
}

#[derive(Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Kind {
    #[default]
    Ellipsoid,
    Sphere,
    EllipticCylinder,
    HyperbolicCylinder,
    ParabolicCylinder,
    Cone,
    HyperboloidOneSheet,
    HyperboloidTwoSheets,
    EllipticParaboloid,
    HyperbolicParaboloid,
    Quadric,
    Polyhedron,
    Mesh,
    TetrahedronPatch,
}

impl Kind {
    /// The keys that hold the parameters of this kind, and their meaning.
    pub fn parameters(self) -> (&'static [&'static str], &'static str) {
        match self {
            Self::Sphere => (&["radius"], "`radius`, one number"),
            Self::EllipticCylinder | Self::HyperbolicCylinder | Self::ParabolicCylinder => {
                (&["radii"], "`radii`, the two numbers A and C")
            }
            Self::Quadric => (&["coefficients"], "`coefficients`, the ten numbers a to j"),
            Self::Polyhedron => (&[], "`cuts`, the planes of its faces"),
            Self::Mesh => (
                &["vertices", "faces", "normals"],
                "`vertices` and `faces`, and `normals` if it is to look round",
            ),
            Self::TetrahedronPatch => (
                &["corners", "weights"],
                "`corners`, four points, and `weights`, ten numbers",
            ),
            _ => (&["radii"], "`radii`, the three numbers A, B and C"),
        }
    }
}
