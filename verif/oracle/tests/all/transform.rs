use imogene_algebra::rational::{fraction, integer, to_f64};
use imogene_oracle::transform::{apply, diagonal, identity, inverse, placement, times};
use imogene_scene::{Axis, Rotation, Scale, Step};

fn rotation(axis: Axis, degrees: f64) -> Step {
    Step::Rotate(Rotation { axis, degrees })
}

#[test]
fn the_way_back_is_exact() {
    let steps = [
        Step::Scale(Scale::PerAxis([2.0, -0.3, 5.0])),
        rotation(Axis::Vector([1.0, 2.0, -0.5]), 35.0),
        Step::Translate([0.1, -7.0, 1e6]),
    ];
    let there = placement(&steps);
    let back = inverse(&there).expect("regular");
    assert_eq!(times(&there, &back), identity());
    assert!(inverse(&diagonal([integer(1), integer(0), integer(2)])).is_none());
}

#[test]
fn turns_are_counter_clockwise_and_quarters_are_exact() {
    let point = [fraction(1, 3), integer(2), integer(5), integer(1)];
    let [x, y, z, one] = &point;
    for (axis, degrees, wanted) in [
        (Axis::Z, 90.0, [&-y, x, z, one]),
        (Axis::X, -270.0, [x, &-z, y, one]),
    ] {
        let turned = apply(&placement(&[rotation(axis, degrees)]), &point);
        assert_eq!(turned.each_ref(), wanted);
    }
    let third = placement(&[rotation(Axis::Vector([1.0, 1.0, 1.0]), 120.0)]);
    let moved = apply(&third, &point).map(|v| to_f64(&v));
    for (found, expected) in moved.iter().zip([5.0, 1.0 / 3.0, 2.0]) {
        assert!((found - expected).abs() < 1e-14, "{moved:?}");
    }
}
