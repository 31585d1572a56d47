use imogene_analysis::exact::number::{Ball, Number};
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;
use std::cmp::Ordering;

/// Whole numbers of up to 260 bits.
fn whole() -> impl Strategy<Value = BigInt> {
    (any::<i64>(), 0u32..200).prop_map(|(number, places)| (BigInt::from(number) << places) + number)
}

#[test]
fn what_is_exact_has_a_sign() {
    let [one, third] = [1, 3].map(|n| Ball::scaled(&BigInt::from(n), 0));
    assert_eq!(one.minus(&one).known_sign(), Some(Ordering::Equal));
    assert_eq!(one.minus(&third).known_sign(), Some(Ordering::Less));
    let zero = one.whole(0);
    assert_eq!(zero.negated().known_sign(), Some(Ordering::Equal));
    // Not even of what is infinite.
    let unknown = Ball::new(0.0, f64::INFINITY);
    assert_eq!(unknown.known_sign(), None);
    assert_eq!(unknown.product(&zero).known_sign(), Some(Ordering::Equal));
}

#[test]
fn what_rounding_hides_has_no_sign() {
    let long = (BigInt::from(1) << 80) + 1;
    let [long, short] = [long, BigInt::from(1) << 80].map(|n| Ball::scaled(&n, 80));
    assert_eq!(long.minus(&short).known_sign(), None);
    // The exponents leave the range of floating point.
    let tiny = Ball::scaled(&BigInt::from(1), 5000);
    assert_eq!(tiny.known_sign(), None);
    assert_eq!(
        Ball::scaled(&(BigInt::from(1) << 5000), 0).known_sign(),
        None
    );
}

proptest! {
    /// `a b - c d + e` and its product with `a`, of numbers of very different sizes and of such as nearly cancel.
    #[test]
    fn a_sign_that_is_known_is_the_true_one(
        numbers in [whole(), whole(), whole(), whole(), whole()],
        exponent in -50i64..300,
        cancels: bool,
    ) {
        let [a, b, mut c, mut d, e] = numbers;
        if cancels {
            (c, d) = (b.clone() + 1, a.clone());
        }
        let ball = |n: &BigInt| Ball::scaled(n, exponent);
        let unit = BigRational::from(BigInt::from(2)).pow(exponent as i32);
        let exact = |n: &BigInt| BigRational::from(n.clone()) / &unit;
        let near = ball(&a).product(&ball(&b)).minus(&ball(&c).product(&ball(&d))).plus(&ball(&e));
        let truth = exact(&a) * exact(&b) - exact(&c) * exact(&d) + exact(&e);
        for (near, truth) in [(near, truth.clone()), (near.times(&ball(&a)), truth * exact(&a))] {
            if let Some(sign) = near.known_sign() {
                prop_assert_eq!(sign, truth.cmp(&BigRational::from(BigInt::from(0))));
            }
        }
    }
}
