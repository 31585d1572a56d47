//! The picture of errors: one colour for each pixel, few colours in all.

use super::pixel::PixelError;

/// A pixel that shows nothing where something is truly seen, or the other way round.
pub const PRESENCE: [u8; 3] = [235, 60, 50];
/// A pixel of another object.
pub const OBJECT: [u8; 3] = [250, 205, 70];
/// A pixel of another face of the object.
pub const FACE: [u8; 3] = [190, 90, 220];
/// Nothing in both.
pub const BACKGROUND: [u8; 3] = [46, 48, 56];
/// A crack.
pub const CRACK: [u8; 3] = [60, 230, 90];
/// Depth errors from `2^-FINEST` to `2^COARSEST` pixels have a brightness of their own.
const FINEST: f64 = 6.0;
const COARSEST: f64 = 4.0;

/// The colour of a pixel's error.
pub fn colour(pixel: &PixelError, words_per_pixel: f64) -> [u8; 3] {
    match pixel {
        PixelError::Background => BACKGROUND,
        PixelError::Missing | PixelError::Extra => PRESENCE,
        PixelError::Object => OBJECT,
        PixelError::Face => FACE,
        PixelError::Same(same) => {
            let error = (same.depth / words_per_pixel).abs().log2();
            shade(((error + FINEST) / (FINEST + COARSEST)).clamp(0.0, 1.0))
        }
    }
}

/// Black, blue, white.
fn shade(level: f64) -> [u8; 3] {
    [level * level, level, level.sqrt()].map(|v| (v * 255.0).round() as u8)
}

/// Least and greatest depth error, in words of the base format as powers of two, with a class of its own.
const CLASSES: [i32; 2] = [-4, 19];

/// The class of a depth error in words: its power of two, rounded up, -4 to 19.
pub fn class(words: f64) -> i32 {
    (words.abs().log2().ceil() as i32).clamp(CLASSES[0], CLASSES[1])
}

fn class_colour(class: i32) -> [u8; 3] {
    let [first, last] = CLASSES;
    shade(f64::from(class - first) / f64::from(last - first))
}

/// The map of a picture, row-major red, green, blue: as [`colour`], but depth errors in words of the base format, by
/// powers of two, and cracks on top.
pub fn map(pixels: &[PixelError], cracks: &[usize]) -> Vec<u8> {
    let one = |pixel: &PixelError| match pixel {
        PixelError::Same(same) => class_colour(class(same.depth)),
        other => colour(other, 1.0),
    };
    let mut rgb: Vec<[u8; 3]> = pixels.iter().map(one).collect();
    for &index in cracks {
        rgb[index] = CRACK;
    }
    rgb.into_iter().flatten().collect()
}

/// What the colours of a map mean: text and colour.
pub fn legend() -> Vec<(&'static str, [u8; 3])> {
    vec![
        ("nothing in both", BACKGROUND),
        ("missing or extra", PRESENCE),
        ("wrong object", OBJECT),
        ("wrong face", FACE),
        ("crack", CRACK),
        ("depth within 1/16 word", class_colour(-4)),
        ("1 word", class_colour(0)),
        ("16 words", class_colour(4)),
        ("256 words", class_colour(8)),
        ("4096 words", class_colour(12)),
        ("65536 words", class_colour(16)),
        ("2^19 words and more", class_colour(19)),
    ]
}
