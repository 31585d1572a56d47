use imogene_analysis::exact::number::{Number, Surd};
use num_bigint::BigInt;
use proptest::prelude::*;
use std::cmp::Ordering;

fn surd(u: i64, v: i64, q: i64) -> Surd {
    Surd::new(u.into(), v.into(), q.into())
}

#[test]
fn exact_zeros_are_zero() {
    // 3 - sqrt(9), and (1 + sqrt(2)) (1 - sqrt(2)) + 1.
    assert_eq!(surd(3, -1, 9).sign(), Ordering::Equal);
    let product = surd(1, 1, 2).product(&surd(1, -1, 2));
    let sum = product.plus(&product.whole(1));
    assert_eq!(sum.sign(), Ordering::Equal);
}

proptest! {
    #[test]
    fn signs_agree_with_floats_when_they_can_tell(a in [-30i64..30, -30..30], b in [-30i64..30, -30..30], q in 0i64..50) {
        let float = |[u, v]: [i64; 2]| u as f64 + v as f64 * (q as f64).sqrt();
        let (x, y) = (surd(a[0], a[1], q), surd(b[0], b[1], q));
        let (fx, fy) = (float(a), float(b));
        for (exact, real) in [
            (x.plus(&y), fx + fy),
            (x.minus(&y), fx - fy),
            (x.product(&y), fx * fy),
            (x.negated().times(&BigInt::from(7)), -7.0 * fx),
        ] {
            if real.abs() > 1e-9 {
                prop_assert_eq!(exact.sign(), real.total_cmp(&0.0));
            }
        }
    }
}
