//! Quadrics in exact rationals: of a shape, in another frame, with whole coefficients.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::file::Shape;
use super::plane::primitive;
use super::tetrahedron::implicit;
use super::transform::Transform;
use crate::rational::{from_decimal, integer};

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

    /// It is zero everywhere, so that it bounds nothing.
    pub fn is_everywhere(&self) -> bool {
        self.coefficients().iter().all(|value| value.is_zero())
    }

    /// The quadric of a shape, in its local coordinates; [`Quadric::everywhere`] for a polyhedron, which has none, and nothing for a mesh.
    pub fn from_shape(shape: &Shape) -> Option<Self> {
        let one = integer(1);
        Some(match shape {
            Shape::Polyhedron => Self::everywhere(),
            Shape::Mesh(_) => return None,
            Shape::TetrahedronPatch { corners, weights } => implicit(corners, weights)?.0,
            Shape::Ellipsoid { radii } => {
                let [a, b, c] = inverse_squares(radii);
                Self::diagonal(a, b, c, -one)
            }
            Shape::Sphere { radius } => {
                let square = from_decimal(*radius).pow(2);
                Self::diagonal(one.clone(), one.clone(), one, -square)
            }
            Shape::EllipticCylinder { radii } => {
                let [a, c] = inverse_squares(radii);
                Self::diagonal(a, integer(0), c, -one)
            }
            Shape::HyperbolicCylinder { radii } => {
                let [a, c] = inverse_squares(radii);
                Self::diagonal(a, integer(0), -c, -one)
            }
            Shape::ParabolicCylinder { radii } => {
                let [a, _] = inverse_squares(radii);
                let mut quadric = Self::diagonal(a, integer(0), integer(0), integer(0));
                quadric.i = minus_half_inverse(radii[1]);
                quadric
            }
            Shape::Cone { radii } => {
                let [a, b, c] = inverse_squares(radii);
                Self::diagonal(a, -b, c, integer(0))
            }
            Shape::HyperboloidOneSheet { radii } => {
                let [a, b, c] = inverse_squares(radii);
                Self::diagonal(a, -b, c, -one)
            }
            Shape::HyperboloidTwoSheets { radii } => {
                let [a, b, c] = inverse_squares(radii);
                Self::diagonal(a, -b, c, one)
            }
            Shape::EllipticParaboloid { radii } => {
                let [a, _, c] = inverse_squares(radii);
                let mut quadric = Self::diagonal(a, integer(0), c, integer(0));
                quadric.h = minus_half_inverse(radii[1]);
                quadric
            }
            Shape::HyperbolicParaboloid { radii } => {
                let [a, _, c] = inverse_squares(radii);
                let mut quadric = Self::diagonal(a, integer(0), -c, integer(0));
                quadric.h = minus_half_inverse(radii[1]);
                quadric
            }
            Shape::Quadric { coefficients } => Self::from_array(coefficients.map(from_decimal)),
        })
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
    /// `cof(M) Q cof(M)^T` is the exact image times det(M)^2, a positive factor that changes neither surface nor inside. The
    /// source prints `M^-1 Q M^-1t`, which holds for row points only (section 5.1.2).
    pub fn transformed(&self, transform: &Transform) -> Self {
        let (cofactors, unit) = transform.whole_cofactors();
        let [a, b, c, d, e, f, g, h, i, j] = self.coefficients();
        let denominator = [a, b, c, d, e, f, g, h, i, j]
            .iter()
            .fold(BigInt::one(), |lcm, value| lcm.lcm(value.denom()));
        let matrix = self
            .matrix()
            .map(|row| row.map(|value| value.numer() * (&denominator / value.denom())));
        // Whole numbers are multiplied and divided once: reducing fractions on the way would take most of the time.
        let entry = |row: usize, column: usize| {
            let sum: BigInt = (0..16)
                .map(|k| &cofactors[row][k / 4] * &matrix[k / 4][k % 4] * &cofactors[column][k % 4])
                .sum();
            BigRational::new_raw(sum, &unit * &unit * &denominator)
        };
        let order = [
            (0, 0),
            (1, 1),
            (2, 2),
            (0, 1),
            (0, 2),
            (1, 2),
            (0, 3),
            (1, 3),
            (2, 3),
            (3, 3),
        ];
        Self::from_array(order.map(|(row, column)| entry(row, column)))
    }

    /// The quadric of a symmetric matrix.
    pub(super) fn from_matrix(matrix: [[BigRational; 4]; 4]) -> Self {
        let [[a, d, e, g], [_, b, f, h], [_, _, c, i], [_, _, _, j]] = matrix;
        Self::from_array([a, b, c, d, e, f, g, h, i, j])
    }

    /// The coefficients a to j.
    pub fn coefficients(&self) -> [&BigRational; 10] {
        [
            &self.a, &self.b, &self.c, &self.d, &self.e, &self.f, &self.g, &self.h, &self.i,
            &self.j,
        ]
    }

    /// The symmetric matrix of Q.
    pub fn matrix(&self) -> [[BigRational; 4]; 4] {
        let Self {
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
        } = self;
        [[a, d, e, g], [d, b, f, h], [e, f, c, i], [g, h, i, j]]
            .map(|row| row.map(BigRational::clone))
    }

    /// The positive multiple with whole coefficients without common divisor.
    pub fn primitive(self) -> Self {
        Self::from_array(primitive(self.coefficients().map(BigRational::clone)))
    }

    pub(super) fn diagonal(a: BigRational, b: BigRational, c: BigRational, j: BigRational) -> Self {
        let [d, e, f, g, h, i] = std::array::from_fn(|_| BigRational::zero());
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

fn inverse_squares<const N: usize>(radii: &[f64; N]) -> [BigRational; N] {
    radii.map(|radius| from_decimal(radius).pow(2).recip())
}

/// Linear terms count twice in a quadric, so `-y/B` has the coefficient `-1/(2B)`.
fn minus_half_inverse(radius: f64) -> BigRational {
    -(from_decimal(radius) * integer(2)).recip()
}
