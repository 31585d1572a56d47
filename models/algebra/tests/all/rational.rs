use imogene_algebra::rational::{
    floor, fraction, from_decimal, from_f64_exact, integer, power_of_two, round_half_up, to_f64,
    to_f64_up,
};
use num_bigint::BigInt;
use num_rational::BigRational;

#[test]
fn decimals_are_taken_as_written() {
    assert_eq!(from_decimal(0.1), fraction(1, 10));
    assert_eq!(from_decimal(-12.375), fraction(-12_375, 1000));
    assert_eq!(
        from_decimal(1.0 / 3.0),
        fraction(3_333_333_333_333_333, 10_000_000_000_000_000)
    );
    assert_eq!(
        from_decimal(3e20),
        integer(300_000_000_000) * integer(1_000_000_000)
    );
    assert_eq!(from_decimal(-0.0), integer(0));
    assert_eq!(to_f64(&from_decimal(5e-324)), 5e-324);
    assert_eq!(to_f64(&from_decimal(f64::MAX)), f64::MAX);
}

#[test]
fn binary_values_are_exact() {
    assert_eq!(
        from_f64_exact(0.1),
        fraction(3_602_879_701_896_397, 1 << 55)
    );
    assert_eq!(from_f64_exact(-2.5), fraction(-5, 2));
}

#[test]
fn large_ratios_keep_their_value() {
    let huge = BigInt::from(10).pow(900);
    let third = BigRational::new(huge.clone(), &huge * BigInt::from(3));
    assert_eq!(to_f64(&third), 1.0 / 3.0);
    let near_third = BigRational::new(&huge + BigInt::from(1), &huge * BigInt::from(3));
    assert_eq!(to_f64(&near_third), 1.0 / 3.0);
    let seven = BigRational::new(&huge * BigInt::from(7) + BigInt::from(1), huge);
    assert_eq!(to_f64(&seven), 7.0);
}

#[test]
fn bounds_are_rounded_upwards() {
    let third = fraction(1, 3);
    let up = to_f64_up(&third);
    assert!(from_f64_exact(up) > third && from_f64_exact(up.next_down()) < third);
    let minus = to_f64_up(&-&third);
    assert!(from_f64_exact(minus) > -&third && from_f64_exact(minus.next_down()) < -third);
    assert_eq!(to_f64_up(&integer(5)), 5.0);
    assert_eq!(power_of_two(70), integer(1 << 35) * integer(1 << 35));
}

#[test]
fn halves_round_upwards() {
    let cases = [
        (3, 2, 2),
        (-3, 2, -1),
        (1, 2, 1),
        (-1, 2, 0),
        (-7, 4, -2),
        (9, 4, 2),
    ];
    for (numerator, denominator, rounded) in cases {
        let value = fraction(numerator, denominator);
        assert_eq!(round_half_up(&value), BigInt::from(rounded), "{value}");
    }
    assert_eq!(floor(&fraction(-7, 4)), BigInt::from(-2));
}
