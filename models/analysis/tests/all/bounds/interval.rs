use imogene_algebra::rational::from_f64_exact;
use imogene_analysis::bounds::depth::Range;
use imogene_analysis::bounds::interval::{excess, range};
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;

fn holds(range: Range, value: &BigRational) -> bool {
    from_f64_exact(range.low) <= *value && *value <= from_f64_exact(range.high)
}

proptest! {
    /// Every operation holds the exact result, in rationals.
    #[test]
    fn ranges_hold_exact_results(a in -1e9f64..1e9, b in -1e9f64..1e9) {
        let exact = [a, b].map(from_f64_exact);
        let [p, q] = [a, b].map(Range::point);
        prop_assert!(holds(p + q, &(&exact[0] + &exact[1])));
        prop_assert!(holds(p - q, &(&exact[0] - &exact[1])));
        prop_assert!(holds(p * q, &(&exact[0] * &exact[1])));
        prop_assume!(b != 0.0);
        prop_assert!(holds(p / q, &(&exact[0] / &exact[1])));
        let root = Range::point(a.abs()).root();
        let square = from_f64_exact(a.abs());
        prop_assert!(from_f64_exact(root.low).pow(2) <= square && square <= from_f64_exact(root.high).pow(2));
    }

    #[test]
    fn long_integers_are_held(digits in proptest::collection::vec(any::<u32>(), 1..40), negative in any::<bool>()) {
        let value = BigInt::from(num_bigint::BigUint::new(digits));
        let value = if negative { -value } else { value };
        let excess = excess([&value]);
        let exact = BigRational::new(value.clone(), BigInt::from(1) << excess);
        prop_assert!(holds(range(&value, excess), &exact));
    }
}
