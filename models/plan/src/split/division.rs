//! How a screen is divided, as text and as pieces.

use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::words::Words;
use imogene_golden::unit::lattice::Lattice;
use serde::Serialize;
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// Most columns or lines of a zone, and most groups of lines.
pub const MOST: u32 = 4096;
/// Fewest columns or lines of a zone that text can ask for: smaller ones are more work to count than to draw.
pub const LEAST_ZONE: u32 = 8;

/// How a screen is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Division {
    /// Rectangles, line of zones by line of zones; those at the right and lower edge can be smaller.
    Zones {
        /// Columns, at least 1.
        width: u32,
        /// Lines, at least 1.
        height: u32,
    },
    /// So many groups of lines, at least 1: group i has the lines i, i + n, i + 2 n, ..
    Lines(u32),
}

/// Text that is no division of the screen.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error(
    "'{0}' is no split of the screen; expected zones:WxH or lines:N, such as zones:64x64 or lines:3; sides of zones from {LEAST_ZONE} to {MOST}, groups of lines from 1 to {MOST}"
)]
pub struct DivisionError(String);

impl FromStr for Division {
    type Err = DivisionError;

    fn from_str(text: &str) -> Result<Division, DivisionError> {
        let from = |least: u32, text: &str| {
            let value: Option<u32> = text.parse().ok();
            value.filter(|value| (least..=MOST).contains(value))
        };
        let division = match text.split_once(':') {
            Some(("zones", size)) => size.split_once('x').and_then(|(width, height)| {
                Some(Division::Zones {
                    width: from(LEAST_ZONE, width)?,
                    height: from(LEAST_ZONE, height)?,
                })
            }),
            Some(("lines", groups)) => from(1, groups).map(Division::Lines),
            _ => None,
        };
        division.ok_or_else(|| DivisionError(text.to_owned()))
    }
}

impl fmt::Display for Division {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Division::Zones { width, height } => write!(f, "zones:{width}x{height}"),
            Division::Lines(groups) => write!(f, "lines:{groups}"),
        }
    }
}

impl Serialize for Division {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// A piece of the screen, at least one pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Piece {
    /// First column of the screen.
    pub x0: u32,
    /// First line of the screen.
    pub y0: u32,
    /// Columns.
    pub width: u32,
    /// Lines.
    pub height: u32,
    /// Lines of the screen from one of its lines to the next; 1 in a zone.
    pub step: u32,
}

impl Division {
    /// The pieces of a screen, which cover each pixel exactly once.
    pub fn pieces(&self, width: u32, height: u32) -> Vec<Piece> {
        match *self {
            Division::Zones {
                width: columns,
                height: lines,
            } => {
                let zone = |x0: u32, y0: u32| Piece {
                    x0,
                    y0,
                    width: columns.min(width - x0),
                    height: lines.min(height - y0),
                    step: 1,
                };
                let along = (0..width).step_by(columns as usize);
                (0..height)
                    .step_by(lines as usize)
                    .flat_map(|y0| along.clone().map(move |x0| zone(x0, y0)))
                    .collect()
            }
            Division::Lines(groups) => (0..groups.min(height))
                .map(|first| Piece {
                    x0: 0,
                    y0: first,
                    width,
                    height: (height - first).div_ceil(groups),
                    step: groups,
                })
                .collect(),
        }
    }
}

impl Piece {
    /// Where pixel (x, y) of the piece is on a screen of so many columns, row-major.
    pub fn place(&self, x: usize, y: usize, screen_width: usize) -> usize {
        let line = self.y0 as usize + y * self.step as usize;
        line * screen_width + self.x0 as usize + x
    }

    /// The part of a screen box in the piece, in pixels of the piece.
    pub fn part_of(&self, screen_box: &ScreenBox) -> ScreenBox {
        let [width, height] = [self.width, self.height].map(i64::from);
        screen_box.on(&self.pixels()).in_zone(0, 0, width, height)
    }

    /// The words of an object or a volume for the piece.
    pub fn words<W: Words + Clone>(&self, words: &W) -> W {
        let mut own = words.on(&self.pixels());
        own.crop([self.width, self.height]);
        own
    }

    fn pixels(&self) -> Lattice {
        Lattice {
            dy: self.step.into(),
            ..Lattice::zone(self.x0.into(), self.y0.into())
        }
    }
}
