use imogene_studies::evaluate::count::{Counted, number, numbers};
use imogene_studies::evaluate::work::facet::{Corners, contour, expressions, is_inside, value};

/// Doubled area 16, a power of two: every quotient is exact.
const CORNERS: [[f64; 3]; 3] = [[1.0, 2.0, 7.0], [5.0, 4.0, -3.0], [3.0, 7.0, 11.0]];

fn corners() -> Corners {
    CORNERS.map(numbers)
}

#[test]
fn expressions_hold_at_the_corners_whichever_way_round() {
    let mut corners = corners();
    for _ in 0..2 {
        let facet = expressions(corners);
        for (index, [x, y, z]) in corners.into_iter().enumerate() {
            assert_eq!(value(&facet.depth, x, y).value, z.value);
            let sides = facet.sides.map(|side| value(&side, x, y).value);
            assert_eq!(sides.iter().filter(|&&v| v == 0.0).count(), 2, "{index}");
            assert_eq!(sides.iter().sum::<f64>(), 16.0);
        }
        let at = |x: f64, y: f64| is_inside(&facet.sides, number(x), number(y));
        assert!(at(3.0, 4.0) && !at(1.0, 4.0) && !at(3.0, 2.0) && !at(5.0, 6.0));
        corners.swap(1, 2);
    }
}

#[test]
fn the_contour_has_the_gradient_of_the_expressions() {
    let corners = corners();
    let plane = expressions(corners).depth.map(|v| v.value);
    for order in [[0, 1, 2], [2, 1, 0], [1, 2, 0]] {
        let contour = contour(order.map(|index| corners[index])).expect("it has an area");
        assert_eq!(contour.depth.map(|v| v.value), plane[..2]);
        assert!(contour.middle_is_right);
        let slope = |slope: Option<Counted>| slope.expect("no side is level").value;
        let slopes = contour.slopes.map(slope);
        assert_eq!(slopes, [2.0, 2.0 / 5.0, -2.0 / 3.0]);
        let along: Vec<f64> = contour.depth_steps.iter().map(|v| v.value).collect();
        assert_eq!(along, [plane[1] + slopes[1] * plane[0]]);
    }
    let flat = corners.map(|[x, _, z]| [x, x, z]);
    assert!(contour(flat).is_none());
}
