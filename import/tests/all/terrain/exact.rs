use imogene_algebra::rational::{fraction, from_decimal};
use imogene_import::terrain::exact::{decimals, proportional};
use num_rational::BigRational;
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
