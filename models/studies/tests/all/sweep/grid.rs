use imogene_algebra::rational::fraction;
use imogene_studies::sweep::grid::{decades, decimal, number};

#[test]
fn grids_are_decimals_as_written() {
    let grid = decades(&[5, 1], (-2..=0).rev());
    assert_eq!(grid, ["5", "1", "0.5", "0.1", "0.05", "0.01"]);
    assert_eq!(number("0.05"), fraction(1, 20));
    assert_eq!(decimal(&fraction(1, 8)), 0.125);
}

#[test]
#[should_panic(expected = "no decimal of 15 digits")]
fn a_third_is_no_number_of_a_scene() {
    decimal(&fraction(1, 3));
}
