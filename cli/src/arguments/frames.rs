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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_read() {
        let of = |text: &str| text.parse::<FrameRange>().unwrap().of("--frames", 24);
        assert_eq!(of("").unwrap(), 1..=24);
        assert_eq!(of("3..7").unwrap(), 3..=7);
        assert_eq!(of("24").unwrap(), 24..=24);
        assert!(of("3..25").unwrap_err().contains("1 to 24"));
        for text in ["0..3", "4..3", "a", "1..", "..", "1...3", "-1..2"] {
            let refused = text.parse::<FrameRange>().unwrap_err();
            assert!(refused.contains("1..24"), "{text}");
        }
    }
}
