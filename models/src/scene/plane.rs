//! Planes in exact rationals: of a cut, in another frame, with whole coefficients.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::file::Cut;
use super::transform::Transform;
use crate::rational::from_decimal;

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
        let [a, b, c] = cut.normal.map(from_decimal);
        let [x, y, z] = cut.point.map(from_decimal);
        let d = -(&a * x + &b * y + &c * z);
        Self { a, b, c, d }
    }

    /// The value of `a x + b y + c z + d` at a point, exactly.
    pub fn value_at(&self, x: &BigRational, y: &BigRational, z: &BigRational) -> BigRational {
        &self.a * x + &self.b * y + &self.c * z + &self.d
    }

    /// The same half-space after the change of frame `P' = M P`.
    ///
    /// `cof(M) p` is the exact image times det(M): a mirror would exchange the kept and the removed side, so the sign of the
    /// determinant is put back, which the source omits (section 5.1.2).
    pub fn transformed(&self, transform: &Transform) -> Self {
        let column = [&self.a, &self.b, &self.c, &self.d];
        let sign = transform.determinant().signum();
        let [a, b, c, d] = transform.cofactors().map(|row| {
            let value: BigRational = row.iter().zip(column).map(|(m, p)| m * p).sum();
            value * &sign
        });
        Self { a, b, c, d }
    }

    /// The coefficients a to d.
    pub fn coefficients(&self) -> [&BigRational; 4] {
        [&self.a, &self.b, &self.c, &self.d]
    }

    /// The positive multiple with whole coefficients without common divisor.
    pub fn primitive(self) -> Self {
        let [a, b, c, d] = primitive(self.coefficients().map(BigRational::clone));
        Self { a, b, c, d }
    }
}

/// The positive multiple of `values` that is whole and without common divisor; zeros stay as they are.
pub(super) fn primitive<const N: usize>(values: [BigRational; N]) -> [BigRational; N] {
    let denominator = values
        .iter()
        .fold(BigInt::one(), |lcm, value| lcm.lcm(value.denom()));
    let numerators = values.map(|value| value.numer() * (&denominator / value.denom()));
    let divisor = numerators.iter().fold(BigInt::zero(), |gcd, value| {
        if gcd.is_one() { gcd } else { gcd.gcd(value) }
    });
    if divisor.is_zero() {
        return numerators.map(BigRational::from_integer);
    }
    numerators.map(|value| BigRational::from_integer(value / &divisor))
}
