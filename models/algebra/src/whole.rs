//! Rationals as whole numbers over one denominator, and as whole numbers without a common divisor.

use crate::rational::to_f64;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// Numerators over one positive common denominator, unreduced: a greatest common divisor of numbers of a thousand bits
/// takes longer than everything else that is done with them.
pub fn common_denominator<const N: usize>(values: [&BigRational; N]) -> ([BigInt; N], BigInt) {
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
pub fn primitive<const N: usize>(values: [BigRational; N]) -> [BigRational; N] {
    let (numerators, _) = common_denominator(values.each_ref());
    let divisor = common_divisor(numerators.each_ref());
    if divisor.is_zero() || divisor.is_one() {
        return numerators.map(BigRational::from_integer);
    }
    numerators.map(|value| BigRational::from_integer(value / &divisor))
}

/// The greatest common divisor, from the smallest number upwards. Each number is divided by what has been found so
/// far: mostly nothing remains, and then no divisor has to be searched.
pub fn common_divisor<const N: usize>(mut values: [&BigInt; N]) -> BigInt {
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

/// The greatest magnitude.
/// Panics if there is no value.
pub fn greatest<T: Signed + Ord, const N: usize>(values: [&T; N]) -> T {
    values.into_iter().map(T::abs).max().expect("a value")
}

/// Numbers over the greatest magnitude among them; all zero where that is.
pub fn scaled<const N: usize>(values: [&BigRational; N]) -> [f64; N] {
    let greatest = greatest(values);
    match greatest.is_zero() {
        true => [0.0; N],
        false => values.map(|value| to_f64(&(value / &greatest))),
    }
}
