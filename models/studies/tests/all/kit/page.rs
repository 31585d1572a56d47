use imogene_studies::kit::page::text;
use std::collections::BTreeMap;

/// A number as a filter prints it.
fn printed(filter: &str, value: f64) -> String {
    let template = format!("{{{{ value|{filter} }}}}");
    text("a number", &template, BTreeMap::from([("value", value)])).expect("it is printed")
}

#[test]
fn figures_have_three_significant_digits() {
    for (value, expected) in [
        (0.0, "0"),
        (0.012345, "0.0123"),
        (1.0, "1.00"),
        (99_999.0, "99999"),
        (123_456.0, "1.23e5"),
        (1.234e-9, "1.23e-9"),
        (f64::INFINITY, "none"),
    ] {
        assert_eq!(printed("figure", value), expected);
    }
}
#[test]
fn digits_are_counted_from_the_first_that_is_not_zero() {
    let found = [0.0, 0.00477, 6.0660, 56_077.4, 0.54].map(|value| printed("digits(4)", value));
    assert_eq!(found, ["0", "0.004770", "6.066", "56077", "0.5400"]);
}
