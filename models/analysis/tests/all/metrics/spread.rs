use imogene_analysis::metrics::{Spread, histogram};

#[test]
fn the_quantile_leaves_one_in_a_thousand_out() {
    let of = |n: u32| Spread::of((1..=n).rev().map(f64::from).collect());
    assert_eq!((of(1000).max, of(1000).quantile_999), (1000.0, 999.0));
    assert_eq!(of(999).quantile_999, 999.0);
    assert_eq!(of(2001).quantile_999, 1999.0);
    assert_eq!((of(3).mean, of(1).quantile_999), (2.0, 1.0));
    let two = Spread::of(vec![3.0, 4.0]);
    assert_eq!((two.rms, two.divided(2.0).max), (12.5f64.sqrt(), 2.0));
    assert_eq!(Spread::of(vec![]), Spread::default());
}

#[test]
fn classes_are_half_open_powers_of_two() {
    let classes = histogram(&[0.0, 0.124, 0.125, 0.5, 0.99, 1.0, 3.9]);
    let counts: Vec<(f64, usize)> = classes.iter().map(|c| (c.below, c.count)).collect();
    let wanted = [
        (0.125, 2),
        (0.25, 1),
        (0.5, 0),
        (1.0, 2),
        (2.0, 1),
        (4.0, 1),
    ];
    assert_eq!(counts, wanted);
    assert_eq!(histogram(&[]).len(), 1);
}
