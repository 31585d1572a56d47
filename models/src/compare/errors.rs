//! A drawn frame against the truth: outline, depth, normals.

use super::Subject;
use crate::exact::render::DEPTH_FRACTION;
use crate::machine::frame::Frame;
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
    /// Mean angle of the normals in degrees, both turned to the viewer.
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

/// What one pixel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PixelError {
    /// Nothing in both.
    Background,
    /// Something in one alone.
    Presence,
    /// Another object.
    Object,
    /// The same object.
    Same {
        /// Depth less the exact depth, in depth words.
        depth: f64,
        /// Angle between the normals in degrees.
        angle: f64,
    },
}

/// The error of every pixel, row-major.
pub fn pixel_errors(subject: &Subject, frame: &Frame) -> Vec<PixelError> {
    let unit = (1i64 << DEPTH_FRACTION) as f64;
    let one = |(index, exact): (usize, &Option<crate::exact::render::ExactPixel>)| {
        let id = frame.id[index];
        match exact {
            None if id < 0 => PixelError::Background,
            Some(exact) if id >= 0 && exact.id == id as u32 => PixelError::Same {
                depth: ((frame.depth[index] << DEPTH_FRACTION) - exact.depth) as f64 / unit,
                angle: angle(frame.normal[index], subject.exact_frame.normal[index]),
            },
            Some(_) if id >= 0 => PixelError::Object,
            _ => PixelError::Presence,
        }
    };
    subject.exact.iter().enumerate().map(one).collect()
}

/// Sums up the pixels of a picture.
pub fn errors(subject: &Subject, pixels: &[PixelError]) -> Errors {
    let covered = subject.exact.iter().flatten().count();
    summed(pixels.iter().copied(), covered, subject.words_per_pixel)
}

fn summed(
    pixels: impl Iterator<Item = PixelError>,
    covered: usize,
    words_per_pixel: f64,
) -> Errors {
    let mut sum = Errors {
        covered,
        ..Errors::default()
    };
    let (mut squares, mut angles) = (0.0, 0.0);
    for pixel in pixels {
        match pixel {
            PixelError::Background => (),
            PixelError::Presence => sum.presence_differs += 1,
            PixelError::Object => sum.object_differs += 1,
            PixelError::Same { depth, angle } => {
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

/// The bulge of an object that is a sphere, over the pixels that show it in both; nothing if there are none.
pub fn bulge(subject: &Subject, pixels: &[PixelError], object: usize) -> Option<Bulge> {
    let radius_px = subject.radii[object];
    let percent = -100.0 / (subject.words_per_pixel * radius_px);
    let shows = |k: usize| subject.exact[k].is_some_and(|p| p.id as usize == object);
    let own = pixels.iter().enumerate().filter(|(k, _)| shows(*k));
    let (mut most, mut least) = (f64::NEG_INFINITY, f64::INFINITY);
    let own: Vec<PixelError> = own.map(|(_, pixel)| *pixel).collect();
    for pixel in &own {
        if let PixelError::Same { depth, .. } = pixel {
            most = most.max(depth * percent);
            least = least.min(depth * percent);
        }
    }
    let sum = summed(own.iter().copied(), own.len(), subject.words_per_pixel);
    (subject.spheres[object] && sum.same > 0).then_some(Bulge {
        radius_px,
        most_percent: most,
        least_percent: least,
        rms_percent: sum.depth_rms_words * percent.abs(),
        normal_mean_deg: sum.normal_mean_deg,
        normal_max_deg: sum.normal_max_deg,
    })
}

/// The angle between two normals, both turned towards the viewer as shading does.
fn angle(a: [i16; 3], b: [i16; 3]) -> f64 {
    let [a, b] = [a, b].map(|n| {
        let n = n.map(f64::from);
        if n[2] > 0.0 { n.map(|v| -v) } else { n }
    });
    let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    let cross = [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ];
    // The cosine alone has no digits left near zero.
    dot(cross, cross).sqrt().atan2(dot(a, b)).to_degrees()
}
