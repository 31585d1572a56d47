//! Planes in exact rationals: of a cut, in another frame, with whole coefficients.

use super::shape::Cut;
use super::transform::{Transform, WholeInverse, WholeTransform};
use imogene_algebra::rational::from_decimal;
use imogene_algebra::vector::dot;
use imogene_algebra::whole::{common_denominator, primitive};
use num_bigint::{BigInt, Sign};
use num_rational::BigRational;

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
