use imogene_studies::trade::report::{EstimateError, csv_field, undominated};

#[test]
fn the_front_is_what_no_other_point_beats() {
    let places = [
        (1.0, 5.0),
        (2.0, 5.0),
        (2.0, 3.0),
        (3.0, 4.0),
        (2.0, 3.0),
        (9.0, 0.0),
    ];
    let mut places: Vec<Option<(f64, f64)>> = places.into_iter().map(Some).collect();
    places.push(None);
    let wanted = [true, false, true, false, true, true, false];
    assert_eq!(undominated(&places), wanted);
}

#[test]
fn estimates_are_off_in_percent_of_what_is_known() {
    let pairs = [Some((101.0, 100.0)), None, Some((49.0, 50.0))];
    let error = EstimateError::of(pairs.into_iter()).unwrap();
    assert_eq!((error.points, error.max_percent), (2, 2.0));
    assert!((error.rms_percent - 2.5f64.sqrt()).abs() < 1e-9);
    assert_eq!(EstimateError::of([None].into_iter()), None);
}

#[test]
fn fields_with_commas_are_quoted() {
    assert_eq!(csv_field("a"), "a");
    assert_eq!(csv_field("a,\"b\""), "\"a,\"\"b\"\"\"");
}
