//! Quadrics and planes in exact rationals: of a shape or a cut, in another frame, with whole coefficients.

use super::shape::{Cut, Shape, Surface};
use super::transform::{Transform, WholeInverse, WholeTransform};
use imogene_algebra::matrix::{Matrix4, SYMMETRIC, product, symmetric, transposed};
use imogene_algebra::rational::{from_decimal, integer};
use imogene_algebra::vector::dot;
use imogene_algebra::whole::{common_denominator, primitive};
use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use num_traits::Zero;

/// `Q = a x^2 + b y^2 + c z^2 + 2d xy + 2e xz + 2f yz + 2g x + 2h y + 2i z + j`, inside where `Q <= 0`.
///
/// A framed quadric has whole coefficients without common divisor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quadric {
    /// Coefficient of x^2.
    pub a: BigRational,
    /// Coefficient of y^2.
    pub b: BigRational,
    /// Coefficient of z^2.
    pub c: BigRational,
    /// Half the coefficient of xy.
    pub d: BigRational,
    /// Half the coefficient of xz.
    pub e: BigRational,
    /// Half the coefficient of yz.
    pub f: BigRational,
    /// Half the coefficient of x.
    pub g: BigRational,
    /// Half the coefficient of y.
    pub h: BigRational,
    /// Half the coefficient of z.
    pub i: BigRational,
    /// Constant.
    pub j: BigRational,
}

impl Quadric {
    /// The quadric that is nowhere positive: all of space.
    pub fn everywhere() -> Self {
        Self::from_array(std::array::from_fn(|_| BigRational::zero()))
    }

    /// Whether it bounds nothing.
    pub fn is_everywhere(&self) -> bool {
        self.coefficients().iter().all(|value| value.is_zero())
    }

    /// The quadric of a shape, in its local coordinates; [`Quadric::everywhere`] for a polyhedron, which has none, and
    /// nothing for a mesh.
    pub fn from_shape(shape: &Shape) -> Option<Self> {
        let between = |[a, c]: [f64; 2]| [a, 1.0, c];
        // Signs of the squares over those of the half axes, and the constant.
        let (radii, signs, constant) = match *shape {
            Shape::Polyhedron => return Some(Self::everywhere()),
            Shape::Mesh(_) => return None,
            Shape::TetrahedronPatch {
                ref corners,
                ref weights,
            } => {
                let (matrix, _) = implicit(corners, weights)?;
                return Some(Self::from_array(
                    SYMMETRIC.map(|[i, j]| matrix[i][j].clone()),
                ));
            }
            Shape::Quadric { coefficients } => {
                return Some(Self::from_array(coefficients.map(from_decimal)));
            }
            Shape::Sphere { radius } => {
                let square = from_decimal(radius).pow(2);
                return Some(Self::diagonal([1, 1, 1].map(integer), -square));
            }
            Shape::Ellipsoid(radii) => (radii, [1, 1, 1], -1),
            Shape::EllipticCylinder(radii) => (between(radii), [1, 0, 1], -1),
            Shape::HyperbolicCylinder(radii) => (between(radii), [1, 0, -1], -1),
            Shape::ParabolicCylinder(radii) => (between(radii), [1, 0, 0], 0),
            Shape::Cone(radii) => (radii, [1, -1, 1], 0),
            Shape::HyperboloidOneSheet(radii) => (radii, [1, -1, 1], -1),
            Shape::HyperboloidTwoSheets(radii) => (radii, [1, -1, 1], 1),
            Shape::EllipticParaboloid(radii) => (radii, [1, 0, 1], 0),
            Shape::HyperbolicParaboloid(radii) => (radii, [1, 0, -1], 0),
        };
        let radii = radii.map(from_decimal);
        let squares = std::array::from_fn(|k| integer(signs[k]) / radii[k].pow(2));
        let mut quadric = Self::diagonal(squares, integer(constant));
        // Linear terms count twice, so that `-y/B` has the coefficient `-1/(2B)`.
        let linear = |radius: &BigRational| -(radius * integer(2)).recip();
        match shape {
            Shape::ParabolicCylinder { .. } => quadric.i = linear(&radii[2]),
            Shape::EllipticParaboloid { .. } | Shape::HyperbolicParaboloid { .. } => {
                quadric.h = linear(&radii[1]);
            }
            _ => {}
        }
        Some(quadric)
    }

    /// The value of Q at a point, exactly.
    pub fn value_at(&self, x: &BigRational, y: &BigRational, z: &BigRational) -> BigRational {
        let along_x = &self.a * x + (&self.d * y + &self.e * z + &self.g) * integer(2);
        let along_y = &self.b * y + (&self.f * z + &self.h) * integer(2);
        let along_z = &self.c * z + &self.i * integer(2);
        along_x * x + along_y * y + along_z * z + &self.j
    }

    /// The same volume after the change of frame `P' = M P`.
    ///
    /// `cof(M) Q cof(M)^T` is the exact image times det(M)^2, a positive factor that changes neither surface nor
    /// inside. The source prints `M^-1 Q M^-1t`, which holds for row points only (section 5.1.2).
    pub fn transformed(&self, transform: &Transform) -> Self {
        let inverse = WholeTransform::new(transform).inverse();
        let square = &inverse.cofactor_unit * &inverse.cofactor_unit;
        let whole = self.transformed_whole(&inverse);
        let over = |v: &BigRational| BigRational::new_raw(v.numer().clone(), v.denom() * &square);
        Self::from_array(whole.coefficients().map(over))
    }

    /// A positive multiple of the same, by whole numbers alone, from the inverse of M.
    pub fn transformed_whole(&self, inverse: &WholeInverse) -> Self {
        // Whole numbers are multiplied and divided once: reducing fractions on the way would take most of the time.
        let (whole, denominator) = common_denominator(self.coefficients());
        let half = product(&symmetric(whole.each_ref()), &inverse.rows);
        Self::from_array(SYMMETRIC.map(|[i, j]| {
            let terms = inverse.rows.iter().zip(&half);
            let sum: BigInt = terms.map(|(left, right)| &left[i] * &right[j]).sum();
            BigRational::new_raw(sum, denominator.clone())
        }))
    }

    /// The coefficients a to j.
    pub fn coefficients(&self) -> [&BigRational; 10] {
        let [a, b, c, d, e] = [&self.a, &self.b, &self.c, &self.d, &self.e];
        let [f, g, h, i, j] = [&self.f, &self.g, &self.h, &self.i, &self.j];
        [a, b, c, d, e, f, g, h, i, j]
    }

    /// The symmetric matrix of Q.
    pub fn matrix(&self) -> Matrix4<BigRational> {
        symmetric(self.coefficients())
    }

    /// The positive multiple with whole coefficients without common divisor.
    pub fn primitive(self) -> Self {
        Self::from_array(primitive(self.coefficients().map(BigRational::clone)))
    }

    /// The quadric of the factors of the squares and the constant.
    pub(super) fn diagonal([a, b, c]: [BigRational; 3], j: BigRational) -> Self {
        let [d, e, f, g, h, i] = std::array::from_fn(|_| BigRational::zero());
        Self::from_array([a, b, c, d, e, f, g, h, i, j])
    }

    /// The quadric of the coefficients a to j.
    pub fn from_array([a, b, c, d, e, f, g, h, i, j]: [BigRational; 10]) -> Self {
        Self {
            a,
            b,
            c,
            d,
            e,
            f,
            g,
            h,
            i,
            j,
        }
    }
}

/// `a x + b y + c z + d`, kept where it is negative or zero; (a, b, c) is the outward normal.
///
/// A framed plane has whole coefficients without common divisor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plane {
    /// Coefficient of x.
    pub a: BigRational,
    /// Coefficient of y.
    pub b: BigRational,
    /// Coefficient of z.
    pub c: BigRational,
    /// Constant.
    pub d: BigRational,
}

impl Plane {
    /// The plane of a cut, in the local coordinates of the object.
    pub fn from_cut(cut: &Cut) -> Self {
        let normal = cut.normal.map(from_decimal);
        let d = -dot(&normal, cut.point.map(from_decimal));
        let [a, b, c] = normal;
        Self { a, b, c, d }
    }

    /// The plane of the coefficients a to d.
    pub fn from_array([a, b, c, d]: [BigRational; 4]) -> Self {
        Self { a, b, c, d }
    }

    /// The plane that keeps the other side.
    pub fn opposite(&self) -> Plane {
        Self::from_array(self.coefficients().map(|value| -value))
    }

    /// The value of `a x + b y + c z + d` at a point, exactly.
    pub fn value_at(&self, x: &BigRational, y: &BigRational, z: &BigRational) -> BigRational {
        &self.a * x + &self.b * y + &self.c * z + &self.d
    }

    /// The same half-space after the change of frame `P' = M P`.
    ///
    /// `cof(M) p` is the exact image times det(M): a mirror would exchange the kept and the removed side, so the sign
    /// of the determinant is put back, which the source omits (section 5.1.2).
    pub fn transformed(&self, transform: &Transform) -> Self {
        let inverse = WholeTransform::new(transform).inverse();
        let whole = self.transformed_whole(&inverse);
        Self::from_array(whole.coefficients().map(|v| v / &inverse.cofactor_unit))
    }

    /// A positive multiple of the same, by whole numbers alone, from the inverse of M.
    pub fn transformed_whole(&self, inverse: &WholeInverse) -> Self {
        let (whole, denominator) = common_denominator(self.coefficients());
        Self::from_array(std::array::from_fn(|column| {
            let terms = whole.iter().zip(&inverse.rows);
            let sum: BigInt = terms.map(|(p, row)| p * &row[column]).sum();
            let value = match inverse.sign {
                Sign::Minus => -sum,
                _ => sum,
            };
            BigRational::new_raw(value, denominator.clone())
        }))
    }

    /// The coefficients a to d.
    pub fn coefficients(&self) -> [&BigRational; 4] {
        [&self.a, &self.b, &self.c, &self.d]
    }

    /// The positive multiple with whole coefficients without common divisor.
    pub fn primitive(self) -> Self {
        Self::from_array(primitive(self.coefficients().map(BigRational::clone)))
    }
}

/// The matrix of the quadric and the four planes of a tetrahedron, in the coordinates of its corners; `None` if the
/// corners lie in one plane.
///
/// With the barycentric coordinates b as affine functions of the point, F = b' W b for the symmetric W of the weights:
/// a pair stands in it twice, which is the factor 2 of its Bernstein polynomial. Plane i keeps b_i >= 0, so it is the
/// face opposite corner i.
pub(super) fn implicit(
    corners: &[[f64; 3]; 4],
    weights: &[f64; 10],
) -> Option<(Matrix4<BigRational>, Matrix4<BigRational>)> {
    let corners = corners.map(|[x, y, z]| [x, y, z, 1.0].map(from_decimal));
    let points = Transform {
        rows: transposed(&corners),
    };
    let determinant = points.determinant();
    if determinant.is_zero() {
        return None;
    }
    // Row i of the inverse is b_i: column i of the cofactors over the determinant.
    let coordinates = transposed(&points.cofactors()).map(|row| row.map(|v| v / &determinant));
    let [w00, w11, w22, w33, w01, w02, w03, w12, w13, w23] = &weights.map(from_decimal);
    let weights = symmetric([w00, w11, w22, w01, w02, w12, w03, w13, w23, w33]);
    let matrix = product(&product(&transposed(&coordinates), &weights), &coordinates);
    Some((matrix, coordinates.map(|plane| plane.map(|v| -v))))
}

/// A quadric bounded by planes, in the camera frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FramedQuadric {
    /// Unique name.
    pub name: String,
    /// Volume or surface.
    pub surface: Surface,
    /// The quadric.
    pub quadric: Quadric,
    /// The cut planes in the order of the file.
    pub planes: Vec<Plane>,
    /// Index of the material.
    pub material: usize,
    /// Whether it keeps the light of sources with shadows off others.
    pub casts_shadow: bool,
}
