//! What is reported of an object, and what its pixels show.

use super::accumulators::Accumulators;
use super::depth::DepthTerms;
use super::outline::Presence;
use super::verdict::Verdict;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::unit::depth_interval::Class;
use imogene_prepare::{NeededWidths, NeededWord};
use imogene_scene::Surface;
use serde::Serialize;

/// One object of a checked scene.
#[derive(Clone, Debug, Serialize)]
pub struct ObjectReport {
    /// Name in the scene.
    pub name: String,
    /// What it is, as in scene files: of a quadric its type.
    pub kind: &'static str,
    /// The processor that draws it.
    pub processor: &'static str,
    /// Where the object can be on the screen.
    pub screen_box: ScreenBox,
    /// Pixels at which a golden processor sees it, hidden or not.
    pub pixels: usize,
    /// Pixels of the golden picture that show it.
    pub visible_pixels: usize,
    /// Whether any does, and if not, why.
    pub shows: Shows,
    /// Whether its material mirrors light.
    pub highlights: bool,
    /// Pixels that rounding could change.
    pub undecided: Undecided,
    /// What a person should know.
    pub problems: Vec<String>,
    /// What else there is to say, by its processor.
    #[serde(flatten)]
    pub detail: Detail,
}

/// What is reported by processor.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Detail {
    /// Of the quadric or the patch processor, with bounds.
    Quadric(Box<QuadricReport>),
    /// Of any other processor.
    Parts(PartsReport),
}

pub(super) struct Reviewed {
    pub kind: &'static str,
    pub found: Findings,
    pub problems: Vec<String>,
    pub detail: Detail,
}

impl ObjectReport {
    /// The report with bounds, if the object has one.
    pub fn quadric(&self) -> Option<&QuadricReport> {
        match &self.detail {
            Detail::Quadric(report) => Some(report),
            Detail::Parts(_) => None,
        }
    }

    /// Greatest depth error, in depth words.
    pub fn depth_lsb(&self) -> f64 {
        match &self.detail {
            Detail::Quadric(report) => report.bounds.depth_lsb,
            Detail::Parts(report) => report.bounds.depth_lsb,
        }
    }
}

/// An object that a quadric or a patch processor draws.
#[derive(Clone, Debug, Serialize)]
pub struct QuadricReport {
    /// Volume or surface.
    pub surface: Surface,
    /// How the object lies to the viewer.
    pub class: Class,
    /// Number of cut planes.
    pub planes: usize,
    /// Whether it is of class front: the viewer is inside the unbounded quadric.
    pub front_view: bool,
    /// Whether it is a prism: the quadric does not depend on the depth.
    pub prism: bool,
    /// Whether the quadric is no curved surface: planes, a line, a point, or nothing.
    pub degenerate: bool,
    /// Indices of the cut planes that are half-planes of the screen.
    pub perpendicular_planes: Vec<usize>,
    /// Indices of the cut planes that change no pixel.
    pub planes_without_effect: Vec<usize>,
    /// Bits that each accumulator needs.
    pub needed: NeededWidths,
    /// Bits that the values take at the pixels of the box, exactly; `None` if the box is empty.
    pub accumulators: Option<Accumulators>,
    /// Bounds that hold at every pixel of the box.
    pub bounds: ObjectBounds,
    /// The normal bounds that the scene's quantile is taken of.
    #[serde(skip)]
    pub(super) angles: Vec<f32>,
}

/// Bounds of a quadric.
#[derive(Clone, Debug, Default, Serialize)]
pub struct ObjectBounds {
    /// Rounding of f1, in depth words.
    pub f1: f64,
    /// Rounding of f2, in its last bit.
    pub f2: f64,
    /// Rounding of each plane, in its last bit.
    pub planes: Vec<f64>,
    /// Greatest depth error at any pixel at which the object is present, in depth words.
    pub depth_lsb: f64,
    /// The same in closed form, whatever the pixels.
    pub depth_lsb_closed_form: f64,
    /// The terms of the closed form that the quadric's faces add up, in depth words.
    pub depth_terms: DepthTerms,
    /// Greatest displacement of the silhouette, in pixels.
    pub silhouette_px: f64,
    /// True if the silhouette has a point without direction, as at an apex, or the object all but vanishes.
    pub silhouette_singular: bool,
    /// Greatest angle of a normal whose direction the words determine, in degrees.
    pub normal_deg: f64,
    /// 99.9 % of these normals are within this angle, in degrees.
    pub normal_deg_999: f64,
    /// Pixels whose normal the words do not determine.
    pub normals_undetermined: usize,
}

/// An object that another processor than quadric or patch draws, held against the truth at every pixel.
#[derive(Clone, Debug, Serialize)]
pub struct PartsReport {
    /// How many processors it takes.
    pub processors: usize,
    /// Bits that each accumulator needs.
    pub needed: Vec<NeededWord>,
    /// Bounds that hold at every pixel of the picture.
    pub bounds: PartsBounds,
}

/// Bounds of such an object.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct PartsBounds {
    /// Greatest depth error at any pixel at which both pictures show the same face, in depth words.
    pub depth_lsb: f64,
}

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
    /// Its screen box holds no pixel: out of range, edge-on, cut away, or so small that it lies between pixels.
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
    let problem = "no pixel shows it: it falls between the pixels, or its planes leave nothing";
    (pixels == 0 && !window.is_empty()).then(|| problem.to_owned())
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
