//! A drawn frame against the truth: outline, depth, normals.

use super::Subject;
use crate::kit::plot::span;
use imogene_analysis::metrics::{self, Golden, PixelError, Spread};
use imogene_golden::machine::frame::Frame;
use serde::Serialize;

/// What differs over the pixels of a picture, or of one object; the keys are stable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Errors {
    /// Pixels at which something is truly seen.
    pub covered: usize,
    /// Pixels at which something is seen in one and nothing in the other.
    pub presence_differs: usize,
    /// Pixels at which both see something, but not the same object.
    pub object_differs: usize,
    /// Pixels at which both see the same object: those of all that follows.
    pub same: usize,
    /// Greatest depth error in pixels.
    pub depth_max_px: f64,
    /// Root of the mean square of the depth error in pixels.
    pub depth_rms_px: f64,
    /// Greatest depth error in depth words, against the exact depth with its fraction.
    pub depth_max_words: f64,
    /// Root of the mean square in depth words.
    pub depth_rms_words: f64,
    /// Mean angle between the lines of the normals in degrees.
    pub normal_mean_deg: f64,
    /// Greatest angle in degrees.
    pub normal_max_deg: f64,
}

/// How far a sphere bulges too much towards the viewer, in percent of its radius; the keys are stable.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Bulge {
    /// Radius in pixels.
    pub radius_px: f64,
    /// Most.
    pub most_percent: f64,
    /// Least: the worst inside.
    pub least_percent: f64,
    /// Root of the mean square over its pixels.
    pub rms_percent: f64,
    /// Mean angle of its normals in degrees.
    pub normal_mean_deg: f64,
    /// Greatest angle in degrees.
    pub normal_max_deg: f64,
}

/// The error of every pixel, row-major. The processors number their faces in different ways, so faces are not compared.
pub fn pixel_errors(subject: &Subject, frame: &Frame) -> Vec<PixelError> {
    let golden = Golden {
        format: &subject.format,
        frame,
        backs: None,
        numbered: &vec![false; subject.radii.len()],
    };
    metrics::pixel_errors(&subject.truth, golden)
}

/// Sums up the pixels of a picture.
pub fn errors(subject: &Subject, pixels: &[PixelError]) -> Errors {
    summed(subject, pixels, subject.truth.covered())
}

fn summed(subject: &Subject, pixels: &[PixelError], covered: usize) -> Errors {
    let words_per_pixel = subject.truth.words_per_pixel;
    let count = |is: fn(&PixelError) -> bool| pixels.iter().filter(|pixel| is(pixel)).count();
    let same = || pixels.iter().filter_map(PixelError::same);
    let depth = Spread::of(same().map(|same| same.depth.abs()).collect());
    let angle = Spread::of(same().map(|same| same.angle).collect());
    Errors {
        covered,
        presence_differs: count(|p| matches!(p, PixelError::Missing | PixelError::Extra)),
        object_differs: count(|p| matches!(p, PixelError::Object | PixelError::Face)),
        same: depth.count,
        depth_max_px: depth.max / words_per_pixel,
        depth_rms_px: depth.rms / words_per_pixel,
        depth_max_words: depth.max,
        depth_rms_words: depth.rms,
        normal_mean_deg: angle.mean,
        normal_max_deg: angle.max,
    }
}

/// The bulge of an object that is a sphere, over the pixels that show it in both; `None` if there are none.
pub fn bulge(subject: &Subject, pixels: &[PixelError], object: usize) -> Option<Bulge> {
    let radius_px = subject.radii[object];
    let percent = -100.0 / (subject.truth.words_per_pixel * radius_px);
    let shows = |k: usize| subject.truth.pixels[k].is_some_and(|p| p.id as usize == object);
    let own = pixels.iter().enumerate().filter(|(k, _)| shows(*k));
    let own: Vec<PixelError> = own.map(|(_, pixel)| *pixel).collect();
    let bulges = own.iter().filter_map(PixelError::same);
    let bulges = span(bulges.map(|same| same.depth * percent));
    let sum = summed(subject, &own, own.len());
    (subject.spheres[object] && sum.same > 0).then_some(Bulge {
        radius_px,
        most_percent: bulges.end,
        least_percent: bulges.start,
        rms_percent: sum.depth_rms_words * percent.abs(),
        normal_mean_deg: sum.normal_mean_deg,
        normal_max_deg: sum.normal_max_deg,
    })
}
