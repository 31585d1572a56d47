//! Values as they are written on the command line.

use std::str::FromStr;

/// A value that is accepted, or what would be.
pub fn value<T: FromStr>(
    text: &str,
    is_accepted: impl FnOnce(&T) -> bool,
    expected: &str,
) -> Result<T, String> {
    let value = text.parse().ok().filter(is_accepted);
    value.ok_or_else(|| expected.to_owned())
}

/// A finite number that is not negative.
pub fn at_least_zero(text: &str, expected: &str) -> Result<f64, String> {
    value(text, |v: &f64| v.is_finite() && *v >= 0.0, expected)
}

/// Two values with a mark between them.
pub fn pair<T: FromStr>(text: &str, mark: char) -> Option<(T, T)> {
    let (one, other) = text.split_once(mark)?;
    Some((one.parse().ok()?, other.parse().ok()?))
}
