//! Values as they are written on the command line.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use imogene_files::text::counted;
use std::fmt::{self, Display};
use std::ops::RangeInclusive;
use std::str::FromStr;

/// Values, their names, and what the help says of each; nothing of a name from before, which is understood still.
pub type Choices<T> = &'static [(T, &'static str, &'static str)];

/// Reads one of these names.
pub fn choice<T: Copy + Send + Sync>(table: Choices<T>) -> impl TypedValueParser<Value = T> {
    let names = table.iter().map(|(_, name, help)| {
        let name = PossibleValue::new(*name).help(*help);
        name.hide(help.is_empty())
    });
    PossibleValuesParser::new(names).map(|name| {
        let row = table.iter().find(|row| row.1 == name);
        row.expect("no other name is accepted").0
    })
}

/// The name of a value of the table.
pub fn name<T: PartialEq>(table: Choices<T>, value: T) -> &'static str {
    let row = table.iter().find(|row| row.0 == value);
    row.expect("a value of the table").1
}

/// An option as it is written on the command line, with a blank before it; nothing without a value.
pub fn option(name: &str, value: Option<impl Display>) -> String {
    value.map_or(String::new(), |value| format!(" --{name} {value}"))
}

/// Values with commas between.
pub fn list<T: FromStr>(text: &str) -> Option<Vec<T>> {
    let values = text.split(',').map(|part| part.trim().parse().ok());
    values.collect()
}

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

/// A depth word as written on the command line.
pub fn depth_word(text: &str) -> Result<u32, String> {
    value(text, |_| true, "expected a number of bits, 8 to 32")
}

/// The frames from one to another, both included and counted from 1, or all of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrameRange(Option<(usize, usize)>);

impl Display for FrameRange {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        match self.0 {
            Some((first, last)) => write!(out, "{first}..{last}"),
            None => Ok(()),
        }
    }
}

impl FromStr for FrameRange {
    type Err = String;

    fn from_str(text: &str) -> Result<FrameRange, String> {
        if text.is_empty() {
            return Ok(FrameRange(None));
        }
        let (first, last) = text.split_once("..").unwrap_or((text, text));
        match (first.parse::<usize>(), last.parse::<usize>()) {
            (Ok(first), Ok(last)) if 1 <= first && first <= last => {
                Ok(FrameRange(Some((first, last))))
            }
            _ => Err(format!(
                "'{text}' is no range of frames; expected FIRST..LAST, such as 1..24, or nothing for all of them"
            )),
        }
    }
}

impl FrameRange {
    /// The frames of an animation of so many; errors name the option.
    pub fn of(self, option: &str, count: usize) -> Result<RangeInclusive<usize>, String> {
        let (first, last) = self.0.unwrap_or((1, count));
        if last > count {
            return Err(format!(
                "{option} {first}..{last}: the animation has {}; numbers from 1 to {count} are possible",
                counted(count, "frame")
            ));
        }
        Ok(first..=last)
    }
}
