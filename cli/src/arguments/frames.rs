//! A range of frames as written on the command line.

use imogene_files::text::counted;
use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;

/// The frames from one to another, both included and counted from 1, or all of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrameRange(Option<(usize, usize)>);

impl fmt::Display for FrameRange {
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
