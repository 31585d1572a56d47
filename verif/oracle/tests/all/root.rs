use imogene_oracle::root::{Quadratic, Real};
use num_rational::BigRational;
use num_traits::Signed;
use proptest::prelude::*;
use std::cmp::Ordering;

fn polynomial(a: i64, b: i64, c: i64) -> Quadratic {
    Quadratic {
        a: a.into(),
        b: b.into(),
        c: c.into(),
    }
}

fn root(a: i64, b: i64, c: i64, greater: bool) -> Real {
    Real::root(&polynomial(a, b, c), greater)
}

fn fraction(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

#[test]
fn equal_numbers_of_different_polynomials_are_equal() {
    // (t - 2)(t - 5), (t - 2)(t + 3), and both times minus three.
    let (one, two) = (polynomial(2, -7, 20), polynomial(2, 1, -12));
    let mut minus = two.clone();
    (minus.a, minus.b, minus.c) = (-&two.a * 3, -&two.b * 3, -&two.c * 3);
    let equal = Real::root(&one, false);
    assert_eq!(equal.compare(&Real::root(&two, true)), Ordering::Equal);
    assert_eq!(equal.compare(&Real::root(&minus, true)), Ordering::Equal);
    let greater = Real::root(&one, true).compare(&Real::root(&two, true));
    assert_eq!(greater, Ordering::Greater);
    assert_eq!(equal.cmp_fraction(&fraction(2, 1)), Ordering::Equal);
    // sqrt(2) twice, and beside it.
    let irrational = root(1, 0, -2, true);
    assert_eq!(irrational.compare(&root(-3, 0, 6, true)), Ordering::Equal);
    let least = irrational.compare(&root(1, 0, -2, false));
    assert_eq!(least, Ordering::Greater);
    let mut beside = polynomial(1, 0, -2);
    beside.a <<= 300;
    beside.c = (beside.c << 300) - 1;
    let less = irrational.compare(&Real::root(&beside, true));
    assert_eq!(less, Ordering::Less);
    // Double roots have no greater one.
    let double = root(1, -3, 9, true).compare(&root(1, -3, 9, false));
    assert_eq!(double, Ordering::Equal);
}

proptest! {
    #[test]
    fn order_agrees_with_floats_that_can_tell(
        p in [-9i64..9, -30..30, -60..60], q in [-9i64..9, -30..30, -60..60], n in -50i64..50, d in 1i64..9,
        sides: [bool; 2]
    ) {
        // Of the second degree, and with the other sign of c if it has no root.
        let of = |[a, b, c]: [i64; 3]| {
            let a = if a == 0 { 9 } else { a };
            let one = polynomial(a, b, c);
            if one.discriminant().is_negative() { polynomial(a, b, -c) } else { one }
        };
        let (p, q) = (of(p), of(q));
        let float = |r: &Real| {
            let (low, high) = r.between(200);
            assert!(low <= high && r.cmp_fraction(&low) != Ordering::Less);
            assert_ne!(r.cmp_fraction(&high), Ordering::Greater);
            num_traits::ToPrimitive::to_f64(&low).unwrap()
        };
        let (x, y) = (Real::root(&p, sides[0]), Real::root(&q, sides[1]));
        let (fx, fy, ft) = (float(&x), float(&y), n as f64 / d as f64);
        if (fx - fy).abs() > 1e-9 {
            prop_assert_eq!(x.compare(&y), fx.total_cmp(&fy));
        }
        prop_assert_eq!(x.compare(&y), y.compare(&x).reverse());
        if (fx - ft).abs() > 1e-9 {
            prop_assert_eq!(x.cmp_fraction(&fraction(n, d)), fx.total_cmp(&ft));
        }
    }
}
