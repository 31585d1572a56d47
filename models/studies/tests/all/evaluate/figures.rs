use imogene_golden::unit::pe2::Quadratic;
use imogene_studies::evaluate::figures::{fair_ball, numbers};
use serde_json::json;

#[test]
fn numbers_of_nested_structures() {
    assert_eq!(numbers(&Quadratic::default()), 6.0);
    let nested = json!({ "a": [1, [2, 3]], "screen_box": { "x": 1 }, "kind": "none" });
    assert_eq!(numbers(&nested), 3.0);
}

#[test]
fn half_of_a_ball_is_seen() {
    // 20 sides and ten bands: 200 facets.
    assert_eq!(fair_ball().unwrap(), [20.0, 100.0]);
}
