//! Exact numbers as the decimals of a scene file, which reads them back without loss.

use imogene_algebra::rational::{from_decimal, to_f64};
use imogene_algebra::whole::{greatest, primitive};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

/// Largest whole number that a scene file takes.
const LARGEST: i64 = 1_000_000_000_000;

/// The numbers times one positive factor, each a decimal that reads back as exactly what it stands for; `None` if 15
/// digits cannot hold them.
pub fn proportional<const N: usize>(values: [&BigRational; N]) -> Option<[f64; N]> {
    let whole = primitive(values.map(BigRational::clone));
    let greatest = greatest(whole.each_ref());
    let mut unit = BigInt::one();
    while greatest.numer() / &unit > BigInt::from(LARGEST) {
        unit *= 10;
    }
    let scaled = whole.map(|value| value / &unit);
    decimals(scaled.each_ref())
}

/// The numbers themselves, if each is a decimal that reads back as exactly what it stands for.
pub fn decimals<const N: usize>(values: [&BigRational; N]) -> Option<[f64; N]> {
    let floats = values.map(to_f64);
    let kept = |(float, value): (&f64, &&BigRational)| from_decimal(*float) == **value;
    floats.iter().zip(&values).all(kept).then_some(floats)
}

#[cfg(test)]
mod tests {
    use super::*;
    use imogene_algebra::rational::fraction;
    use num_traits::Signed;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn what_is_written_is_proportional_to_what_was_meant(n in [1i64..1_000_000, -1_000_000..1, 0..9], d in [1i64..60, 1..60, 1..60]) {
            let values: [BigRational; 3] = std::array::from_fn(|k| fraction(n[k], d[k]));
            let written = proportional(values.each_ref()).expect("few digits").map(from_decimal);
            let factor = &written[0] / &values[0];
            prop_assert!(factor.is_positive());
            for (one, value) in written.iter().zip(&values) {
                prop_assert_eq!(one, &(value * &factor));
            }
        }
    }

    #[test]
    fn too_many_digits_are_not_written() {
        let many = fraction(i64::MAX, 1);
        assert!(proportional([&many, &fraction(1, 3)]).is_none());
        assert!(decimals([&fraction(1, 3)]).is_none());
        assert_eq!(decimals([&fraction(1, 4)]), Some([0.25]));
    }
}
