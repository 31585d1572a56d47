use imogene_algebra::rational::from_f64_exact;
use imogene_studies::trial::exact::at_most;
use num_rational::BigRational;
use proptest::prelude::*;

proptest! {
    #[test]
    fn comparisons_with_a_bound_are_exact(
        n in 0i128..1 << 60,
        d in 1i128..1 << 50,
        off in -3i64..=3,
        far in any::<bool>(),
    ) {
        let near = n as f64 / d as f64;
        let near_bits = (near.to_bits() as i64 + off).max(0) as u64;
        let bound = if far { near * 1.5 } else { f64::from_bits(near_bits) };
        let exact = BigRational::new(n.into(), d.into()) <= from_f64_exact(bound);
        prop_assert_eq!(at_most(n, d, bound), exact);
    }
}

#[test]
fn bounds_that_are_reached_hold() {
    assert!(at_most(3, 4, 0.75) && !at_most(3, 4, 0.75f64.next_down()));
    assert!(at_most(0, 1, 0.0) && !at_most(1, 1 << 100, 0.0));
    assert!(at_most(1 << 100, 1 << 100, 1.0) && !at_most((1 << 100) + 1, 1 << 100, 1.0));
}
