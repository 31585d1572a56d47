//! All figures of a picture.

use super::drawing::Drawing;
use super::map::map;
use super::pixel::{Back, Golden, PixelError, SameFace, cracks, pixel_errors};
use super::spread::{Class, Spread, histogram};
use super::truth::Truth;
use serde::{Deserialize, Serialize};

/// How far a golden picture is from the truth; the keys are stable, `docs/trade.md` defines them.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Metrics {
    /// Pixels at which something is truly seen.
    pub covered: usize,
    /// Pixels at which something is truly seen and nothing in the picture.
    pub missing: usize,
    /// Pixels at which nothing is truly seen and something in the picture.
    pub extra: usize,
    /// Silhouette errors: missing and extra.
    pub silhouette: usize,
    /// Pixels that show another object.
    pub wrong_object: usize,
    /// Pixels that show another face or cut plane of the right object.
    pub wrong_face: usize,
    /// Visible-part errors: wrong object and wrong face.
    pub visible_part: usize,
    /// Pixels that look through a closed surface.
    pub cracks: usize,
    /// Front depth in words of the base format, over pixels that show the same face.
    pub depth_words: Spread,
    /// The same in pixels of depth.
    pub depth_px: Spread,
    /// Pixels by their depth error in words of the base format.
    pub depth_histogram: Vec<Class>,
    /// Back depth in words of the base format, over pixels whose processor hands it on.
    pub back_words: Spread,
    /// The same in pixels of depth.
    pub back_px: Spread,
    /// Pixels of patches at which truth and picture have not as many faces behind each other.
    pub back_differs: usize,
    /// Angle of the normals in degrees, over pixels that show the same face.
    pub normal_deg: Spread,
    /// Greatest channel difference in 1/255, over pixels that show an object, truly or in the picture.
    pub colour: Spread,
    /// The same over pixels that show the same face.
    pub colour_same_face: Spread,
}

/// Measures a drawing; also its map of errors, red, green and blue of every pixel.
pub fn measure(truth: &Truth, drawing: &Drawing) -> (Metrics, Vec<u8>) {
    let golden = Golden {
        format: &drawing.format,
        frame: &drawing.frame,
        backs: Some(&drawing.backs),
        numbered: &drawing.numbered,
    };
    let pixels = pixel_errors(truth, golden);
    let cracks = cracks(truth, golden);
    let count = |wanted: fn(&PixelError) -> bool| pixels.iter().filter(|p| wanted(p)).count();
    let missing = count(|p| matches!(p, PixelError::Missing));
    let extra = count(|p| matches!(p, PixelError::Extra));
    let wrong_object = count(|p| matches!(p, PixelError::Object));
    let wrong_face = count(|p| matches!(p, PixelError::Face));
    let same = || pixels.iter().filter_map(PixelError::same);
    let back = |s: &SameFace| match s.back {
        Back::Error(words) => Some(words.abs()),
        Back::None | Back::Differs => None,
    };
    let depths: Vec<f64> = same().map(|s| s.depth.abs()).collect();
    let depth_histogram = histogram(&depths);
    let depth_words = Spread::of(depths);
    let back_words = Spread::of(same().filter_map(back).collect());
    let channels = truth.rgb.chunks_exact(3).zip(drawing.rgb.chunks_exact(3));
    let difference = |(truth, drawn): (&[u8], &[u8])| {
        let channels = truth.iter().zip(drawn).map(|(a, b)| a.abs_diff(*b));
        channels.max().unwrap_or(0)
    };
    let differences: Vec<u8> = channels.map(difference).collect();
    let colour = |wanted: fn(&PixelError) -> bool| {
        let pixels = pixels.iter().zip(&differences).filter(|(p, _)| wanted(p));
        let differences = pixels.map(|(_, difference)| f64::from(*difference));
        Spread::of(differences.collect())
    };
    let metrics = Metrics {
        covered: truth.covered(),
        missing,
        extra,
        silhouette: missing + extra,
        wrong_object,
        wrong_face,
        visible_part: wrong_object + wrong_face,
        cracks: cracks.len(),
        depth_words,
        depth_px: depth_words.divided(truth.words_per_pixel),
        depth_histogram,
        back_words,
        back_px: back_words.divided(truth.words_per_pixel),
        back_differs: same().filter(|s| s.back == Back::Differs).count(),
        normal_deg: Spread::of(same().map(|s| s.angle).collect()),
        colour: colour(|p| !matches!(p, PixelError::Background)),
        colour_same_face: colour(|p| p.same().is_some()),
    };
    (metrics, map(&pixels, &cracks))
}
