use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use imogene_studies::evaluate::count::{number, numbers};
use imogene_studies::evaluate::work::facet::value;
use imogene_studies::evaluate::work::zones::{
    box_of, box_of_outline, moved_conic, moved_line, outline, zones,
};

#[test]
fn moved_expressions_are_those_of_the_golden_model() {
    let [k, l] = numbers([128.0, -256.0]);
    let found = moved_line(&numbers([3.0, -5.0, 7.0]), k, l).map(|v| v.value as i128);
    let Linear { a, b, c } = Linear::new(3, -5, 7).from_zone(128, -256);
    assert_eq!(found, [a, b, c]);
    let found = moved_conic(&numbers([2.0, 3.0, -4.0, 5.0, 6.0, 7.0]), k, l);
    let golden = Quadratic::new([2, 3, -4, 5, 6, 7]);
    let Quadratic { a, b, c, d, e, f } = golden.from_zone(128, -256);
    assert_eq!(found.map(|v| v.value as i128), [a, b, c, d, e, f]);
}

#[test]
fn the_box_of_an_ellipse_touches_it() {
    // 100 - (x - 3)^2 - 4 (y + 2)^2: x from -7 to 13, y from -7 to 3.
    let conic = [-1.0, -4.0, 0.0, 6.0, -16.0, 75.0];
    let found = box_of_outline(&numbers(conic)).map(|v| v.value);
    for (found, expected) in found.into_iter().zip([-7.0, 13.0, -7.0, 3.0]) {
        // A dozen operations on numbers below 1000.
        assert!((found - expected).abs() < 1e-11, "{found} {expected}");
    }
    // A sheared one has a value that vanishes along its tangents only.
    let conic = [-2.0, -3.0, 1.5, 4.0, -5.0, 90.0];
    let [x0, x1, _, _] = box_of_outline(&numbers(conic)).map(|v| v.value);
    for x in [x0, x1] {
        let [a, b, c, d, e, f] = conic;
        let (linear, constant) = (c * x + e, a * x * x + d * x + f);
        let discriminant = linear * linear - 4.0 * b * constant;
        assert!(discriminant.abs() < 1e-9);
    }
}

#[test]
fn outlines_and_boxes_of_points() {
    let points = |list: [[f64; 2]; 4]| list.map(numbers);
    let with_inner = points([[0.0, 0.0], [9.0, 1.0], [2.0, 8.0], [3.0, 3.0]]);
    assert_eq!(outline(&with_inner).len(), 3);
    let four = points([[0.0, 0.0], [9.0, 1.0], [2.0, 8.0], [9.0, 9.0]]);
    let sides = outline(&four);
    assert_eq!(sides.len(), 4);
    for side in &sides {
        assert!(!value(side, number(4.0), number(4.0)).is_negative());
    }
    let window = box_of(&four);
    assert_eq!(window.map(|v| v.value), [0.0, 9.0, 0.0, 9.0]);
    let span = zones(window.map(|v| v - number(1.0)), number(0.25));
    assert_eq!(span.map(|v| v.value), [-1.0, 2.0, -1.0, 2.0]);
}
