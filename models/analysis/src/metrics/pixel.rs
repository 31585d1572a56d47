//! One pixel of a golden picture against the truth; and cracks, where the picture looks through a
//! surface that is closed.

use super::truth::Truth;
use crate::exact::back::ExactBack;
use crate::exact::render::{DEPTH_FRACTION, ExactPixel};
use imogene_algebra::vector::{cross, dot, length};
use imogene_golden::format::Format;
use imogene_golden::machine::frame::Frame;

/// What one pixel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PixelError {
    /// Nothing in both.
    Background,
    /// Something truly, nothing in the picture.
    Missing,
    /// Nothing truly, something in the picture.
    Extra,
    /// Another object.
    Object,
    /// Another face, or another cut plane, of the right object.
    Face,
    /// The same face of the same object.
    Same(SameFace),
}

impl PixelError {
    /// The errors where it shows the right face.
    pub fn same(&self) -> Option<&SameFace> {
        match self {
            PixelError::Same(same) => Some(same),
            _ => None,
        }
    }
}

/// The errors at a pixel that shows the right face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SameFace {
    /// Front depth less the exact one, in words of the base format.
    pub depth: f64,
    /// The same of the back.
    pub back: Back,
    /// Angle between the normals' lines in degrees, 0 to 90: surfaces are two-sided.
    pub angle: f64,
}

/// How the back depth of a pixel compares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Back {
    /// The processor hands none on, or the object is a patch of which one face is seen, truly and in the picture.
    None,
    /// Of a patch one shows two faces and the other one.
    Differs,
    /// Back depth less the exact one, in words of the base format.
    Error(f64),
}

/// A golden picture as far as it is compared with the truth.
#[derive(Clone, Copy, Debug)]
pub struct Golden<'a> {
    /// Format of its words.
    pub format: &'a Format,
    /// What is seen.
    pub frame: &'a Frame,
    /// Back depths; none if they are not to be compared.
    pub backs: Option<&'a [i64]>,
    /// Of each object, whether its face numbers can be compared with the true ones.
    pub numbered: &'a [bool],
}

/// The error of every pixel, row-major.
pub fn pixel_errors(truth: &Truth, golden: Golden) -> Vec<PixelError> {
    let pixels = 0..truth.pixels.len();
    pixels.map(|at| pixel_error(truth, golden, at)).collect()
}

fn pixel_error(truth: &Truth, golden: Golden, index: usize) -> PixelError {
    let id = golden.frame.id[index];
    let exact = match (&truth.pixels[index], id >= 0) {
        (None, false) => return PixelError::Background,
        (None, true) => return PixelError::Extra,
        (Some(_), false) => return PixelError::Missing,
        (Some(exact), true) => exact,
    };
    if exact.id != id as u32 {
        return PixelError::Object;
    }
    if golden.numbered[id as usize] && exact.number != golden.frame.number[index] {
        return PixelError::Face;
    }
    let normal = golden.frame.normal[index];
    PixelError::Same(SameFace {
        depth: word_error(golden.frame.depth[index], exact.depth, golden.format),
        back: back(truth, golden, index, exact),
        angle: angle(normal.map(f64::from), truth.normals[index]),
    })
}

/// A depth word of a format less an exact depth, in words of the base format: exact until the last division.
fn word_error(word: i64, exact: i64, format: &Format) -> f64 {
    let [own, base] = [format, &Truth::FORMAT].map(|format| i128::from(format.z_max()));
    let difference = ((i128::from(word) * base) << DEPTH_FRACTION) - i128::from(exact) * own;
    difference as f64 / ((own << DEPTH_FRACTION) as f64)
}

fn back(truth: &Truth, golden: Golden, index: usize, exact: &ExactPixel) -> Back {
    let numbered = golden.numbered[exact.id as usize];
    let (Some(words), Some(ExactBack { depth, is_apart }), true) =
        (golden.backs, truth.backs[index], numbered)
    else {
        return Back::None;
    };
    let (front, word) = (golden.frame.depth[index], words[index]);
    match (is_apart, word != front) {
        (true, true) => Back::Error(word_error(word, depth, golden.format)),
        (false, false) => Back::None,
        // Front and back within one word of each other look like one.
        _ if word_error(word, depth, golden.format).abs() <= one_word(golden.format) => Back::None,
        _ => Back::Differs,
    }
}

/// A depth word of a format, in words of the base format.
fn one_word(format: &Format) -> f64 {
    Truth::FORMAT.z_max() as f64 / format.z_max() as f64
}

/// The angle between two lines in degrees; 90 where one of them has no direction, the worst there is.
fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
    let (sine, cosine) = (length(cross(a, b)), dot(a, b));
    if sine == 0.0 && cosine == 0.0 {
        return 90.0;
    }
    // The cosine alone has no digits left near zero.
    sine.atan2(cosine.abs()).to_degrees()
}

/// Pixels at which the truth shows a surface, there and at all eight neighbours, and the picture shows the background,
/// or a point of another object or face that lies behind all nine true points by more than a pixel of depth and more
/// than a word of its format.
///
/// All nine: a pixel on an object's outline that the picture misses shows what is truly seen beside it, which is no
/// crack.
pub fn cracks(truth: &Truth, golden: Golden) -> Vec<usize> {
    let lines = 1..truth.height.saturating_sub(1);
    let all = lines.flat_map(|y| (1..truth.width.saturating_sub(1)).map(move |x| (x, y)));
    let cracks = all.filter(|&(x, y)| is_crack(truth, golden, x, y));
    cracks.map(|(x, y)| y * truth.width + x).collect()
}

fn is_crack(truth: &Truth, golden: Golden, x: usize, y: usize) -> bool {
    let index = y * truth.width + x;
    let Some(exact) = truth.pixels[index] else {
        return false;
    };
    let id = golden.frame.id[index];
    let is_same_face =
        || !golden.numbered[id as usize] || golden.frame.number[index] == exact.number;
    if id == exact.id as i32 && is_same_face() {
        return false;
    }
    let lines = (y - 1..=y + 1).map(|line| line * truth.width + x);
    let mut around = lines.flat_map(|index| &truth.pixels[index - 1..=index + 1]);
    let deepest = around.try_fold(i64::MIN, |most, pixel| Some(most.max((*pixel)?.depth)));
    let margin = truth.words_per_pixel.max(one_word(golden.format));
    deepest.is_some_and(|deepest| {
        id < 0 || word_error(golden.frame.depth[index], deepest, golden.format) > margin
    })
}
