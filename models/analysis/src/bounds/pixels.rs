//! What the pixels of an object show.

use super::outline::Presence;
use super::verdict::Verdict;
use imogene_golden::object::quadric::ScreenBox;
use serde::Serialize;

/// Whether the golden picture shows an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Shows {
    /// At one pixel at least.
    Visible,
    /// Others are before it at all its pixels.
    Hidden,
    /// Its screen box has pixels, but none shows it: it falls between them, or its planes leave nothing.
    BetweenPixels,
    /// Its screen box holds no pixel: off the screen or its depth range, edge-on, cut away, or so small that it lies
    /// between the pixels.
    EmptyBox,
}

impl Shows {
    pub(super) fn of(window: &ScreenBox, pixels: usize, visible: usize) -> Shows {
        match (pixels, visible) {
            _ if window.is_empty() => Shows::EmptyBox,
            (0, _) => Shows::BetweenPixels,
            (_, 0) => Shows::Hidden,
            _ => Shows::Visible,
        }
    }
}

/// Pixels that rounding could change.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Undecided {
    /// The sign of f2 is open.
    pub silhouette: usize,
    /// A comparison with a plane, or with the near or far end, is open.
    pub edge: usize,
    /// Pixels of the picture at which the outline may be a pixel or more away from the true one.
    pub adrift: usize,
}

impl Undecided {
    /// Counts what is open at a pixel.
    pub(super) fn count(&mut self, verdict: &Verdict) {
        if let Verdict::Undecided { silhouette, .. } = *verdict {
            self.silhouette += usize::from(silhouette);
            self.edge += usize::from(!silhouette);
        }
    }
}

/// What a person should know of an outline that is adrift.
pub(super) fn adrift_problem(adrift: &[(i64, i64)]) -> Option<String> {
    let (x, y) = adrift.get(adrift.len() / 2)?;
    Some(format!(
        "rounding decides whether it is there at {} pixels, as at ({x}, {y}), where its outline may be a pixel or more away from the true one",
        adrift.len()
    ))
}

/// What a person should know of an object that has a box and no pixel.
pub(super) fn unshown_problem(window: &ScreenBox, pixels: usize) -> Option<String> {
    let unshown = pixels == 0 && !window.is_empty();
    let problem = "no pixel shows it: it falls between the pixels, or its planes leave nothing";
    unshown.then(|| problem.to_owned())
}

/// What a pass over some lines finds; of other processors than quadric and patch neither caps nor normals.
#[derive(Default)]
pub(super) struct Findings {
    pub pixels: usize,
    pub near_end: usize,
    pub undetermined: usize,
    pub depth: f64,
    pub angles: Vec<f32>,
    pub undecided: Undecided,
    /// Line by line.
    pub presence: Vec<Presence>,
}

impl Findings {
    pub fn merged(mut self, other: Findings) -> Findings {
        self.pixels += other.pixels;
        self.near_end += other.near_end;
        self.undetermined += other.undetermined;
        self.depth = self.depth.max(other.depth);
        self.angles.extend(other.angles);
        self.undecided.silhouette += other.undecided.silhouette;
        self.undecided.edge += other.undecided.edge;
        self.presence.extend(other.presence);
        self
    }
}
