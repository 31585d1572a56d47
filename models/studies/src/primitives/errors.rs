//! A drawn frame against the truth: outline, depth, normals.

use super::Subject;
use imogene_analysis::metrics::{self, Golden, PixelError, SameFace};
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
    let mut sum = Errors {
        covered,
        ..Errors::default()
    };
    let (mut squares, mut angles) = (0.0, 0.0);
    for pixel in pixels.iter().copied() {
        match pixel {
            PixelError::Background => (),
            PixelError::Missing | PixelError::Extra => sum.presence_differs += 1,
            PixelError::Object | PixelError::Face => sum.object_differs += 1,
            PixelError::Same(SameFace { depth, angle, .. }) => {
                sum.same += 1;
                sum.depth_max_words = sum.depth_max_words.max(depth.abs());
                squares += depth * depth;
                angles += angle;
                sum.normal_max_deg = sum.normal_max_deg.max(angle);
            }
        }
    }
    let count = sum.same.max(1) as f64;
    sum.depth_rms_words = (squares / count).sqrt();
    sum.normal_mean_deg = angles / count;
    sum.depth_max_px = sum.depth_max_words / words_per_pixel;
    sum.depth_rms_px = sum.depth_rms_words / words_per_pixel;
    sum
}

/// The bulge of an object that is a sphere, over the pixels that show it in both; `None` if there are none.
pub fn bulge(subject: &Subject, pixels: &[PixelError], object: usize) -> Option<Bulge> {
    let radius_px = subject.radii[object];
    let percent = -100.0 / (subject.truth.words_per_pixel * radius_px);
    let shows = |k: usize| subject.truth.pixels[k].is_some_and(|p| p.id as usize == object);
    let own = pixels.iter().enumerate().filter(|(k, _)| shows(*k));
    let (mut most, mut least) = (f64::NEG_INFINITY, f64::INFINITY);
    let own: Vec<PixelError> = own.map(|(_, pixel)| *pixel).collect();
    for pixel in &own {
        if let PixelError::Same(SameFace { depth, .. }) = pixel {
            most = most.max(depth * percent);
            least = least.min(depth * percent);
        }
    }
    let sum = summed(subject, &own, own.len());
    (subject.spheres[object] && sum.same > 0).then_some(Bulge {
        radius_px,
        most_percent: most,
        least_percent: least,
        rms_percent: sum.depth_rms_words * percent.abs(),
        normal_mean_deg: sum.normal_mean_deg,
        normal_max_deg: sum.normal_max_deg,
    })
}
