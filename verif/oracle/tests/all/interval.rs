use imogene_oracle::interval::Interval;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::FromPrimitive;
use proptest::prelude::*;

fn exact(value: f64) -> BigRational {
    BigRational::from_f64(value).expect("finite")
}

fn holds(interval: Interval, value: &BigRational) -> bool {
    exact(interval.lo) <= *value && *value <= exact(interval.hi)
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![-1e6f64..1e6, -1e-6f64..1e-6, Just(0.0), Just(1.0)]
}

#[test]
fn what_has_no_meaning_is_the_whole_line() {
    let one = Interval::point(1.0);
    assert_eq!(one / Interval::within(1.0), Interval::WHOLE);
    assert_eq!(Interval::WHOLE * Interval::WHOLE, Interval::WHOLE);
    assert_eq!(Interval::WHOLE * Interval::ZERO, Interval::ZERO);
    let huge = Interval::point(f64::MAX);
    assert_eq!((huge * huge).hi, f64::INFINITY);
    assert_eq!((huge * huge - huge * huge), Interval::WHOLE);
}

#[test]
fn exact_values_are_enclosed_as_narrowly_as_can_be() {
    let third = BigRational::new(BigInt::from(1), BigInt::from(3));
    let found = Interval::about(&third);
    assert!(holds(found, &third) && found.lo.next_up() == found.hi);
    assert_eq!(Interval::about(&exact(0.1)), Interval::point(0.1));
}

proptest! {
    #[test]
    fn operations_enclose_the_exact_result(a in number(), b in number(), c in number(), d in number()) {
        let (x, y) = (Interval::new(a.min(b), a.max(b)), Interval::new(c.min(d), c.max(d)));
        for (p, q) in [(a, c), (a, d), (b, c), (b, d)] {
            let (u, v) = (exact(p), exact(q));
            prop_assert!(holds(x + y, &(&u + &v)));
            prop_assert!(holds(x - y, &(&u - &v)));
            prop_assert!(holds(x * y, &(&u * &v)));
            prop_assert!(holds(x.square(), &(&u * &u)));
            if x.lo >= 0.0 {
                prop_assert!(holds(x.power(7), &u.pow(7)));
            }
            if !y.holds_zero() {
                prop_assert!(holds(x / y, &(&u / &v)));
            }
            let root = x.sqrt();
            if p >= 0.0 {
                prop_assert!(exact(root.lo).pow(2) <= u && u <= exact(root.hi).pow(2));
            }
        }
    }
}
