use imogene_studies::evaluate::row::{Row, number};

#[test]
fn numbers_are_readable() {
    for (value, expected) in [
        (0.0, "0"),
        (4116.0, "4116"),
        (225_732.0, "225 732"),
        (-1_600_000_000.0, "-1 600 000 000"),
        (2.640625, "2.641"),
        (145.5, "145.5"),
        (14.625, "14.62"),
        (57_600.4, "57 600"),
    ] {
        assert_eq!(number(value), expected);
    }
}

#[test]
fn a_correction_is_what_ours_is_compared_with() {
    let names = ["x", "5.1", "operations"];
    let row = Row::new(names, 600.0, 480.0, None);
    let percent = 100.0 * (0.8 - 1.0);
    assert_eq!((row.difference, row.percent), (Some(-120.0), Some(percent)));
    let row = Row::new(names, 600.0, 480.0, Some(400.0));
    assert_eq!(row.difference, Some(80.0));
    let limit = Row::new(names, "more than 100", 3.0, None);
    assert_eq!(limit.difference, None);
}
