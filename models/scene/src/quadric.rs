//! Quadrics in exact rationals: of a shape, in another frame, with whole coefficients.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;

use super::file::Shape;
use super::plane::{common_denominator, primitive};
use super::tetrahedron::implicit;
use super::transform::{Transform, WholeInverse, WholeTransform};
use imogene_algebra::rational::{from_decimal, integer};

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
        let inverse = WholeTransform::new(transform).inverse();
        let square = &inverse.cofactor_unit * &inverse.cofactor_unit;
        let whole = self.transformed_whole(&inverse);
        Self::from_array(
            whole
                .coefficients()
                .map(|v| BigRational::new_raw(v.numer().clone(), v.denom() * &square)),
        )
    }

    /// A positive multiple of the same, by whole numbers alone.
    pub(super) fn transformed_whole(&self, inverse: &WholeInverse) -> Self {
        let inverse = &inverse.rows;
        let ([a, b, c, d, e, f, g, h, i, j], denominator) = common_denominator(self.coefficients());
        let matrix = [
            [&a, &d, &e, &g],
            [&d, &b, &f, &h],
            [&e, &f, &c, &i],
            [&g, &h, &i, &j],
        ];
        // Whole numbers are multiplied and divided once: reducing fractions on the way would take most of the time.
        let half: [[BigInt; 4]; 4] = std::array::from_fn(|row| {
            std::array::from_fn(|column| {
                sum_of_products((0..4).map(|k| (matrix[row][k], &inverse[k][column])))
            })
        });
        let entry = |row: usize, column: usize| {
            let sum = sum_of_products((0..4).map(|k| (&inverse[k][row], &half[k][column])));
            BigRational::new_raw(sum, denominator.clone())
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

/// Most entries of a matrix of a quadric or a placement are zero.
fn sum_of_products<'a>(terms: impl Iterator<Item = (&'a BigInt, &'a BigInt)>) -> BigInt {
    let not_zero = terms.filter(|(a, b)| !a.is_zero() && !b.is_zero());
    not_zero.map(|(a, b)| a * b).sum()
}

fn inverse_squares<const N: usize>(radii: &[f64; N]) -> [BigRational; N] {
    radii.map(|radius| from_decimal(radius).pow(2).recip())
}

/// Linear terms count twice in a quadric, so `-y/B` has the coefficient `-1/(2B)`.
fn minus_half_inverse(radius: f64) -> BigRational {
    -(from_decimal(radius) * integer(2)).recip()
}

#[cfg(test)]
mod tests {
    use super::super::file::{Axis, Rotation, Scale, Step};
    use super::super::plane::{Plane, common_divisor};
    use super::*;
    use num_integer::Integer;
    use num_traits::Signed;
    use proptest::prelude::*;

    fn step() -> impl Strategy<Value = Step> {
        let decimal = || (-9999i32..9999).prop_map(|n| f64::from(n) / 1000.0);
        let factor = || prop_oneof![1i32..4000, -4000i32..-1].prop_map(|n| f64::from(n) / 1000.0);
        let vector = [decimal(), decimal(), decimal()];
        prop_oneof![
            vector.clone().prop_map(Step::Translate),
            [factor(), factor(), factor()].prop_map(|f| Step::Scale(Scale::PerAxis(f))),
            (vector, 0i32..360).prop_map(|([x, y, z], degrees)| {
                let axis = Axis::Vector([x, y, z + 20.0]);
                let degrees = f64::from(degrees);
                Step::Rotate(Rotation { axis, degrees })
            }),
        ]
    }

    proptest! {
        /// The image has at the image of a point the value of the original at the point, times det(M)^2 for a quadric and |det(M)| for a plane; the whole
        /// multiples become the same primitive ones.
        #[test]
        fn images_have_the_values_of_their_originals(
            steps in proptest::collection::vec(step(), 0..4), camera in proptest::collection::vec(step(), 0..3),
            q in proptest::collection::vec(-50i64..50, 10), p in proptest::array::uniform4(-50i64..50), at in proptest::array::uniform3(-20i64..20)
        ) {
            let camera = Transform::placement(&camera);
            let transform = camera.after(&Transform::placement(&steps));
            let determinant = transform.determinant();
            let at = at.map(integer);
            let [x, y, z] = transform.point(&at);
            let quadric = Quadric::from_array(std::array::from_fn(|k| integer(q[k]) / integer(7)));
            let image = quadric.transformed(&transform);
            let expected = quadric.value_at(&at[0], &at[1], &at[2]) * &determinant * &determinant;
            prop_assert_eq!(image.value_at(&x, &y, &z), expected);
            let [a, b, c, d] = p.map(integer);
            let plane = Plane { a, b, c, d };
            let cut = plane.transformed(&transform);
            prop_assert_eq!(cut.value_at(&x, &y, &z), plane.value_at(&at[0], &at[1], &at[2]) * determinant.abs());
            let inverse = WholeTransform::of_steps(&WholeTransform::new(&camera), &steps).inverse();
            prop_assert_eq!(quadric.transformed_whole(&inverse).primitive(), image.primitive());
            prop_assert_eq!(plane.transformed_whole(&inverse).primitive(), cut.primitive());
        }

        #[test]
        fn the_divisor_is_the_greatest(values in proptest::array::uniform6(-1_000_000i64..1_000_000), factor in 0i64..1000) {
            let values = values.map(|v| BigInt::from(v * factor));
            let expected = values.iter().fold(BigInt::zero(), |gcd, v| gcd.gcd(v));
            prop_assert_eq!(common_divisor(values.each_ref()), expected);
        }
    }
}
