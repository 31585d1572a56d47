//! Exact numbers as the decimals of a scene file, which reads them back without loss.

use imogene_algebra::rational::{from_decimal, to_f64};
use imogene_algebra::whole::{greatest, primitive};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

/// Largest whole number that a scene file takes.
const LARGEST: i64 = 1_000_000_000_000;

/// The numbers times one positive factor, as decimals that read back exactly; `None` if 15 digits are too few.
pub fn proportional<const N: usize>(values: [&BigRational; N]) -> Option<[f64; N]> {
    let whole = primitive(values.map(BigRational::clone));
    let greatest = greatest(whole.each_ref());
    let mut unit = BigInt::one();
    while greatest.numer() / &unit > BigInt::from(LARGEST) {
        unit *= 10;
    }
    decimals(whole.map(|value| value / &unit).each_ref())
}

/// The numbers themselves, if each is a decimal that reads back as exactly what it stands for.
pub fn decimals<const N: usize>(values: [&BigRational; N]) -> Option<[f64; N]> {
    let floats = values.map(to_f64);
    let kept = |(float, value): (&f64, &&BigRational)| from_decimal(*float) == **value;
    floats.iter().zip(&values).all(kept).then_some(floats)
}
