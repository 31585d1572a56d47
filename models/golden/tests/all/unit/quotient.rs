use imogene_golden::unit::quotient::{Quotient, restoring_quotient};
use num_bigint::BigInt;
use num_integer::Integer;
use proptest::prelude::*;

fn expected(n: i128, d: i128, bits: u32) -> Quotient {
    if d == 0 {
        return Quotient::None;
    }
    let exact = BigInt::from(n).div_floor(&BigInt::from(d));
    let half = BigInt::from(1) << (bits - 1);
    if exact < -&half {
        Quotient::Below
    } else if exact >= half {
        Quotient::Above
    } else {
        Quotient::Word(i64::try_from(exact).expect("a word"))
    }
}

#[test]
fn every_small_quotient_is_rounded_downwards() {
    for bits in 1..=6 {
        for n in -300..=300 {
            for d in -20..=20 {
                let found = restoring_quotient(n, d, bits);
                assert_eq!(found, expected(n, d, bits), "{n} / {d}");
            }
        }
    }
}

proptest! {
    #[test]
    fn wide_words_too(
        d in -(1i128 << 44)..1 << 44, q in -(1i128 << 33)..1 << 33, rest in -(1i128 << 44)..1 << 44,
        bits in prop_oneof![Just(16u32), Just(24), Just(32)]
    ) {
        // About the ends of the word as often as within it.
        let q = if q % 3 == 0 { q >> 20 } else { q };
        let n = q * d + rest % (d.abs() + 1);
        prop_assert_eq!(restoring_quotient(n, d, bits), expected(n, d, bits));
    }
}
