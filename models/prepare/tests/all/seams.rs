use imogene_algebra::rational::fraction;
use imogene_golden::object::quadric::ScreenBox;
use imogene_prepare::seams::{join, key};

#[test]
fn both_sides_have_the_same_key_and_others_have_not() {
    let of = |n: [i64; 4]| {
        let values = n.map(|n| fraction(n, 1));
        key(values.each_ref())
    };
    let one = of([0, -3, 2, 5]);
    assert_eq!(one, of([0, 3, -2, -5]));
    assert_ne!(one, of([0, 3, -2, 5]));
    assert_ne!(one, of([1, 3, -2, -5]));
    // Nothing leads; it stays as it is.
    assert_eq!(of([0; 4]), [0; 4].map(|n| fraction(n, 1)));
}

#[test]
fn boxes_that_touch_become_one_and_others_stay() {
    let of = |x0, x1, y0, y1| ScreenBox { x0, x1, y0, y1 };
    let mut boxes = vec![];
    for added in [of(0, 9, 0, 9), of(20, 29, 0, 9), of(0, 9, 20, 29)] {
        join(&mut boxes, added);
    }
    assert_eq!(boxes.len(), 3);
    // Beside the first, and with it beside the second.
    join(&mut boxes, of(10, 19, 5, 6));
    boxes.sort_by_key(|b| b.y0);
    assert_eq!(boxes, [of(0, 29, 0, 9), of(0, 9, 20, 29)]);
    // One column is between.
    assert!(!of(0, 9, 0, 9).touches(&of(11, 19, 0, 9)));
}
