use imogene_analysis::exact::number::SurdReal;
use num_bigint::BigInt;
use proptest::prelude::*;

fn surd() -> impl Strategy<Value = (i64, i32, i64, i64)> {
    (
        -40i64..40,
        -1i32..=1,
        0i64..50,
        prop_oneof![-9i64..=-1, 1i64..=9],
    )
}

fn exact((p, s, q, d): (i64, i32, i64, i64)) -> SurdReal {
    SurdReal::new(p.into(), s, q.into(), d.into())
}

fn float((p, s, q, d): (i64, i32, i64, i64)) -> f64 {
    (p as f64 + f64::from(s) * (q as f64).sqrt()) / d as f64
}

#[test]
fn equal_values_in_different_forms_are_equal() {
    // 1 + sqrt(8) = (2 + sqrt(32)) / 2, and sqrt(9) = 3.
    assert_eq!(exact((1, 1, 8, 1)), exact((2, 1, 32, 2)));
    assert_eq!(exact((0, 1, 9, 1)), exact((3, 0, 0, 1)));
    assert_eq!(exact((5, -1, 9, -2)), exact((-1, 0, 0, 1)));
    assert!(exact((0, 1, 2, 1)) < exact((0, 1, 3, 1)));
}

proptest! {
    #[test]
    fn order_agrees_with_floats_when_they_can_tell(a in surd(), b in surd()) {
        let (x, y) = (float(a), float(b));
        if (x - y).abs() > 1e-9 {
            prop_assert_eq!(exact(a).cmp(&exact(b)), x.total_cmp(&y));
        }
        if x.abs() > 1e-9 {
            prop_assert_eq!(exact(a).signum(), x.total_cmp(&0.0));
        }
        let fixed = exact(a).fixed(&BigInt::from(3), &BigInt::from(7), 20);
        let scaled = (3.0 * x + 7.0) * f64::from(1 << 20);
        let fixed: i64 = fixed.try_into().unwrap();
        prop_assert!((fixed as f64 - scaled).abs() <= 2.0);
    }
}
