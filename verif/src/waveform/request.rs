//! What is asked of waveforms, and where their window begins.

use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// Waveforms wanted of a run.
#[derive(Clone, Debug)]
pub struct WaveformRequest {
    /// Where the window begins; the clocks around the first mismatch are always recorded.
    pub from: WindowStart,
    /// Clocks of the window.
    pub clocks: u64,
    /// Paths of nets inside the machine, or of instances all of whose nets are meant; `all` is every net.
    pub nets: Vec<String>,
}

/// Where a window of waveforms begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WindowStart {
    /// Where it is of most use: at the middle line of a traced object, at the first clock of a machine with a screen.
    Usual,
    /// Where this place of the picture is drawn.
    At(Place),
    /// Nowhere: a mismatch alone is shown.
    Mismatch,
}

/// A place in the pictures of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Frame, counted from 1; if none, the first that shows a scene.
    pub frame: Option<u32>,
    /// Column.
    pub column: usize,
    /// Line.
    pub line: usize,
}

/// A place that a run does not have.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum PlaceError {
    /// Column and line, and those of the last pixel.
    #[error("there is no pixel {},{} to trace from; accepted: 0,0 to {},{}", .0[0], .0[1], .1[0], .1[1])]
    Pixel([usize; 2], [usize; 2]),
    /// A frame of a run that has one.
    #[error("there is no frame {0} to trace from: a scene is drawn once; accepted: frame:1")]
    Frame(u32),
}

impl Place {
    /// Refuses a pixel that a picture of this size does not have.
    pub fn check(&self, width: usize, height: usize) -> Result<(), PlaceError> {
        if self.column < width && self.line < height {
            return Ok(());
        }
        let last = [width - 1, height - 1];
        Err(PlaceError::Pixel([self.column, self.line], last))
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(frame) = self.frame {
            write!(f, "frame:{frame},")?;
        }
        write!(f, "{},{}", self.column, self.line)
    }
}

/// `X,Y`, `line:Y` or `frame:N`, or one of the first two behind the last and a comma.
impl FromStr for Place {
    type Err = String;

    fn from_str(text: &str) -> Result<Place, String> {
        let read = || {
            let (frame, pixel) = match text.strip_prefix("frame:") {
                Some(rest) => {
                    let (frame, pixel) = rest.split_once(',').unwrap_or((rest, "line:0"));
                    let frame = frame.parse().ok().filter(|frame| *frame > 0);
                    (Some(frame?), pixel)
                }
                None => (None, text),
            };
            let (column, line) = match pixel.strip_prefix("line:") {
                Some(line) => ("0", line),
                None => pixel.split_once(',')?,
            };
            Some(Place {
                frame,
                column: column.parse().ok()?,
                line: line.parse().ok()?,
            })
        };
        read().ok_or_else(|| {
            "expected COLUMN,LINE of a pixel, line:LINE or frame:NUMBER with a number from 1 on, such as 160,120, \
             line:120, frame:2, frame:2,line:120 or frame:2,160,120"
                .into()
        })
    }
}
