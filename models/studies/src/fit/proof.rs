//! What is proven of a machine before a pixel is drawn, and what only by comparing every pixel.

use super::budget::{Budget, DepthLimit, Item};
use super::frames::{Drawn, Frames};
use imogene_analysis::bounds::check;
use imogene_golden::format::Format;
use serde::Serialize;

/// Bounds that hold whatever is drawn, the greatest of all frames; the keys are stable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Bounds {
    /// Depth, in words of the base format.
    pub depth_lsb: f64,
    /// Displacement of a silhouette in pixels.
    pub silhouette_px: f64,
    /// Angle of a normal in degrees, where the words determine it.
    pub normal_deg: f64,
    /// Pixels at which the visible object or face is not proven to be the true one.
    pub undecided_pixels: usize,
}

/// How a limit is known to be kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Proof {
    /// A bound is not above it.
    Bound,
    /// Every pixel of every frame was compared with the truth.
    Exhaustive,
}

/// A limit with the bound that belongs to it; the keys are stable.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Proven {
    /// The limit and what was found.
    #[serde(flatten)]
    pub item: Item,
    /// What is proven, in the same unit; none where nothing is.
    pub bound: Option<f64>,
    /// How it is known.
    pub proof: Proof,
}

/// The bounds of all frames.
pub fn bounds(frames: &Frames, drawn: &Drawn) -> Bounds {
    let scenes = frames.all.iter().zip(&drawn.prepared);
    let mut most = Bounds::default();
    for (frame, prepared) in scenes {
        let report = check(&frame.scene, prepared);
        let (bounds, undecided_pixels) = (report.bounds, report.undecided_pixels);
        // A word of this format, in words of the base format.
        let word = Format::BASE.z_max() as f64 / prepared.format.z_max() as f64;
        most.depth_lsb = most.depth_lsb.max(bounds.depth_lsb * word);
        most.silhouette_px = most.silhouette_px.max(bounds.silhouette_px);
        most.normal_deg = most.normal_deg.max(bounds.normal_deg);
        most.undecided_pixels = most.undecided_pixels.max(undecided_pixels);
    }
    most
}

/// How each limit is known to be kept.
pub fn proofs(
    frames: &Frames,
    budget: &Budget,
    drawn: &Drawn,
    bounds: Option<&Bounds>,
) -> Vec<Proven> {
    let words_per_pixel = frames.all.iter().map(|f| f.truth.words_per_pixel);
    let words_per_pixel = words_per_pixel.fold(f64::INFINITY, f64::min);
    let of = |item: &Item| {
        let bound = bounds.and_then(|bounds| match item.limit {
            "depth" => Some(match budget.depth {
                Some(DepthLimit::Pixels(_)) => bounds.depth_lsb / words_per_pixel,
                _ => bounds.depth_lsb,
            }),
            // Everywhere else picture and truth are proven to show the same face.
            "silhouette" | "faces" => Some(bounds.undecided_pixels as f64),
            "normal" => Some(bounds.normal_deg),
            _ => None,
        });
        let proof = match bound.is_some_and(|bound| bound <= item.allowed) {
            true => Proof::Bound,
            false => Proof::Exhaustive,
        };
        Proven {
            item: item.clone(),
            bound,
            proof,
        }
    };
    drawn.items.iter().map(of).collect()
}
