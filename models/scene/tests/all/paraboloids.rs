use imogene_algebra::rational::{fraction, integer, power_of_two, to_f64};
use imogene_scene::{on_unit_circle, root};
use num_traits::Signed;

#[test]
fn directions_are_exactly_of_length_one() {
    for (x, y) in [
        (1.0, 0.0),
        (-3.0, 4.0),
        (0.0, -2.0),
        (1e-9, 7.0),
        (-5.0, 0.0),
        (0.3, 0.1),
    ] {
        let [cos, sin] = on_unit_circle(x, y);
        assert_eq!(&cos * &cos + &sin * &sin, integer(1));
        let length = x.hypot(y);
        assert!((to_f64(&cos) - x / length).abs() < 1e-15);
        assert!((to_f64(&sin) - y / length).abs() < 1e-15);
    }
    assert_eq!(on_unit_circle(-3.0, 4.0), [fraction(-3, 5), fraction(4, 5)]);
}

#[test]
fn roots_of_fractions_are_exact() {
    assert_eq!(root(&fraction(49, 144)), fraction(7, 12));
    let two = root(&integer(2));
    let off = (&two * &two - integer(2)).abs();
    assert!(off > integer(0) && off < power_of_two(62).recip());
    let tiny = root(&power_of_two(4001).recip());
    assert!(tiny > power_of_two(2001).recip() && tiny < power_of_two(2000).recip());
}
