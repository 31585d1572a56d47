//! What is allowed, and whether a picture keeps to it.

use super::FitError;
use imogene_analysis::metrics::Metrics;
use serde::Serialize;
use std::fmt;
use std::str::FromStr;

/// Greatest error of a depth.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum DepthLimit {
    /// In words of the base format, `D / (2^23 - 1)`, whatever the depth word of the machine.
    Words(f64),
    /// In pixels of depth.
    Pixels(f64),
}

/// Greatest number of pixels of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum CountLimit {
    /// So many.
    Pixels(usize),
    /// So many percent of the picture, rounded down.
    Percent(f64),
}

fn positive(text: &str) -> Option<f64> {
    let value: f64 = text.trim().parse().ok()?;
    (value.is_finite() && value >= 0.0).then_some(value)
}

impl FromStr for DepthLimit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let limit = match text.strip_suffix("px") {
            Some(pixels) => positive(pixels).map(Self::Pixels),
            None => positive(text.strip_suffix("lsb").unwrap_or(text)).map(Self::Words),
        };
        limit.ok_or_else(|| {
            format!(
                "'{text}' is no limit of a depth; expected words of the base format, such as 1 or 1lsb (a word is D / (2^23 - 1)), or pixels of depth, such as 0.5px"
            )
        })
    }
}

impl FromStr for CountLimit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let limit = match text.strip_suffix('%') {
            Some(percent) => positive(percent).map(Self::Percent),
            None => text.parse().ok().map(Self::Pixels),
        };
        limit.ok_or_else(|| {
            format!(
                "'{text}' is no number of pixels; expected one such as 0 or 12, or a part of the picture such as 0.1%"
            )
        })
    }
}

impl fmt::Display for DepthLimit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Words(words) => write!(f, "{words}lsb"),
            Self::Pixels(pixels) => write!(f, "{pixels}px"),
        }
    }
}

impl fmt::Display for CountLimit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pixels(pixels) => write!(f, "{pixels}"),
            Self::Percent(percent) => write!(f, "{percent}%"),
        }
    }
}

impl CountLimit {
    /// So many pixels of a picture of `pixels`.
    pub fn of(self, pixels: usize) -> usize {
        match self {
            Self::Pixels(count) => count,
            Self::Percent(percent) => (percent / 100.0 * pixels as f64).floor() as usize,
        }
    }
}

/// What is allowed in every frame; what is not given is not limited.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Budget {
    /// Depth of visible faces, over pixels that show the right face.
    pub depth: Option<DepthLimit>,
    /// Silhouette errors: something is seen in picture or truth alone.
    pub silhouette: Option<CountLimit>,
    /// Visible-part errors: another object or another face.
    pub faces: Option<CountLimit>,
    /// Greatest channel difference in 1/255, over pixels that show the right face.
    pub colour: Option<f64>,
    /// Angle of normals in degrees, over pixels that show the right face.
    pub normal: Option<f64>,
}

/// One limit, and what was found; the keys are stable.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Item {
    /// Which: `depth`, `silhouette`, `faces`, `colour`, `normal`.
    pub limit: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// What is allowed.
    pub allowed: f64,
    /// What was found, the greatest of all frames.
    pub measured: f64,
}

impl Item {
    /// True if the limit is kept.
    pub fn holds(&self) -> bool {
        self.measured <= self.allowed
    }
}

impl fmt::Display for Item {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (limit, unit) = (self.limit, self.unit);
        let (measured, allowed) = (self.measured, self.allowed);
        write!(f, "{limit}: {measured:.4} {unit} of {allowed} allowed")
    }
}

impl Budget {
    /// Refuses a budget that limits nothing.
    pub fn check(&self) -> Result<(), FitError> {
        match *self == Budget::default() {
            true => Err(FitError::NoBudget),
            false => Ok(()),
        }
    }

    /// The options of the command line that give it.
    pub fn options(&self) -> String {
        fn option<T: fmt::Display>(name: &str, limit: Option<T>) -> String {
            limit.map_or(String::new(), |limit| format!(" --max-{name} {limit}"))
        }
        [
            option("depth-error", self.depth),
            option("silhouette-errors", self.silhouette),
            option("face-errors", self.faces),
            option("colour-error", self.colour),
            option("normal-error", self.normal),
        ]
        .concat()
    }

    /// Every limit against the metrics of one frame of so many pixels.
    pub fn judge(&self, metrics: &Metrics, pixels: usize) -> Vec<Item> {
        let count = |limit: Option<CountLimit>| limit.map(|limit| limit.of(pixels) as f64);
        let (unit, depth, off) = match self.depth {
            Some(DepthLimit::Words(words)) => ("lsb", Some(words), metrics.depth_words.max),
            Some(DepthLimit::Pixels(px)) => ("px", Some(px), metrics.depth_px.max),
            None => ("px", None, 0.0),
        };
        let (silhouette, faces) = (metrics.silhouette as f64, metrics.visible_part as f64);
        let colour = metrics.colour_same_face.max;
        let limits = [
            ("depth", unit, depth, off),
            ("silhouette", "pixels", count(self.silhouette), silhouette),
            ("faces", "pixels", count(self.faces), faces),
            ("colour", "of 255", self.colour, colour),
            ("normal", "degrees", self.normal, metrics.normal_deg.max),
        ];
        let item = |(limit, unit, allowed, measured): (_, _, Option<f64>, f64)| {
            let allowed = allowed?;
            Some(Item {
                limit,
                unit,
                allowed,
                measured,
            })
        };
        limits.into_iter().filter_map(item).collect()
    }
}

/// The worst of each limit over frames.
pub fn worst(frames: &[Vec<Item>]) -> Vec<Item> {
    let mut worst: Vec<Item> = frames.first().cloned().unwrap_or_default();
    for frame in frames {
        for (most, item) in worst.iter_mut().zip(frame) {
            most.measured = most.measured.max(item.measured);
        }
    }
    worst
}
