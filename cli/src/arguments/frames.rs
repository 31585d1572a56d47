//! A range of frames as written on the command line.

use imogene_files::text::counted;
use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;

/// The frames from one to another, both included and counted from 1, or all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameRange(Option<(usize, usize)>);

/// Text that is no range of frames, or frames that an animation has not.
#[derive(Debug, PartialEq, Eq)]
pub enum FrameRangeError {
    /// The text.
    Text(String),
    /// The frames.
    Beyond {
        /// The option.
        option: &'static str,
        /// First frame asked for.
        first: usize,
        /// Last frame asked for.
        last: usize,
        /// Frames that there are.
        count: usize,
    },
}

impl fmt::Display for FrameRangeError {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Text(text) => write!(
                out,
                "'{text}' is no range of frames; expected FIRST..LAST, such as 1..24, or nothing for all of them"
            ),
            Self::Beyond {
                option,
                first,
                last,
                count,
            } => write!(
                out,
                "{option} {first}..{last}: the animation has {}; numbers from 1 to {count} are possible",
                counted(*count, "frame")
            ),
        }
    }
}

impl std::error::Error for FrameRangeError {}

impl fmt::Display for FrameRange {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        match self.0 {
            Some((first, last)) => write!(out, "{first}..{last}"),
            None => Ok(()),
        }
    }
}

impl FromStr for FrameRange {
    type Err = FrameRangeError;

    fn from_str(text: &str) -> Result<FrameRange, FrameRangeError> {
        if text.is_empty() {
            return Ok(FrameRange(None));
        }
        let (first, last) = text.split_once("..").unwrap_or((text, text));
        match (first.parse::<usize>(), last.parse::<usize>()) {
            (Ok(first), Ok(last)) if 1 <= first && first <= last => {
                Ok(FrameRange(Some((first, last))))
            }
            _ => Err(FrameRangeError::Text(text.to_owned())),
        }
    }
}

impl FrameRange {
    /// The frames of an animation of so many; errors name the option.
    pub fn of(
        self,
        option: &'static str,
        count: usize,
    ) -> Result<RangeInclusive<usize>, FrameRangeError> {
        let (first, last) = self.0.unwrap_or((1, count));
        if last > count {
            return Err(FrameRangeError::Beyond {
                option,
                first,
                last,
                count,
            });
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
        assert!(of("3..25").unwrap_err().to_string().contains("1 to 24"));
        for text in ["0..3", "4..3", "a", "1..", "..", "1...3", "-1..2"] {
            let refused = text.parse::<FrameRange>().unwrap_err();
            assert!(refused.to_string().contains("1..24"), "{text}");
        }
    }
}
