//! Planes in exact rationals: of a cut, in another frame, with whole coefficients.

use num_bigint::{BigInt, Sign};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::file::Cut;
use super::transform::{Transform, WholeInverse, WholeTransform};
use imogene_algebra::rational::from_decimal;

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

    /// The plane that keeps the other side.
    pub fn opposite(&self) -> Plane {
        Plane {
            a: -&self.a,
            b: -&self.b,
            c: -&self.c,
            d: -&self.d,
        }
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
        let inverse = WholeTransform::new(transform).inverse();
        let Self { a, b, c, d } = self.transformed_whole(&inverse);
        let [a, b, c, d] = [a, b, c, d].map(|v| v / &inverse.cofactor_unit);
        Self { a, b, c, d }
    }

    /// A positive multiple of the same, by whole numbers alone.
    pub(super) fn transformed_whole(&self, inverse: &WholeInverse) -> Self {
        let (whole, denominator) = common_denominator(self.coefficients());
        let [a, b, c, d] = std::array::from_fn(|column| {
            let terms = whole.iter().zip(&inverse.rows);
            let sum: BigInt = terms.map(|(p, row)| p * &row[column]).sum();
            let value = match inverse.sign {
                Sign::Minus => -sum,
                _ => sum,
            };
            BigRational::new_raw(value, denominator.clone())
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

/// Numerators over one common denominator.
pub(super) fn common_denominator<const N: usize>(
    values: [&BigRational; N],
) -> ([BigInt; N], BigInt) {
    let first = values[0].denom();
    if values.iter().all(|value| value.denom() == first) {
        return (values.map(|value| value.numer().clone()), first.clone());
    }
    let denominator = values
        .iter()
        .fold(BigInt::one(), |lcm, value| lcm.lcm(value.denom()));
    let whole = values.map(|value| value.numer() * (&denominator / value.denom()));
    (whole, denominator)
}

/// The positive multiple of `values` that is whole and without common divisor; zeros stay as they are.
pub(super) fn primitive<const N: usize>(values: [BigRational; N]) -> [BigRational; N] {
    let (numerators, _) = common_denominator(values.each_ref());
    let divisor = common_divisor(numerators.each_ref());
    if divisor.is_zero() || divisor.is_one() {
        return numerators.map(BigRational::from_integer);
    }
    numerators.map(|value| BigRational::from_integer(value / &divisor))
}

/// The greatest common divisor, from the smallest number upwards. Each number is divided by what has been found so far: mostly nothing remains, and then no
/// divisor has to be searched.
pub(crate) fn common_divisor<const N: usize>(mut values: [&BigInt; N]) -> BigInt {
    values.sort_by_key(|value| value.bits());
    values.iter().fold(BigInt::zero(), |gcd, value| {
        if gcd.is_zero() {
            return value.abs();
        }
        if gcd.is_one() {
            return gcd;
        }
        let rest = *value % &gcd;
        if rest.is_zero() { gcd } else { gcd.gcd(&rest) }
    })
}
