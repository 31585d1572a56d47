//! Pictures side by side, with maps of their errors below.

use super::Drawn;
use super::errors::PixelError;

/// White pixels between two panels.
const GAP: usize = 4;
/// A pixel that is drawn in one alone.
const PRESENCE: [u8; 3] = [235, 60, 50];
/// A pixel of another object.
const OBJECT: [u8; 3] = [250, 205, 70];
/// Nothing in both.
const BACKGROUND: [u8; 3] = [46, 48, 56];
/// Depth errors from `2^-FINEST` to `2^COARSEST` pixels have a brightness of their own.
const FINEST: f64 = 6.0;
const COARSEST: f64 = 4.0;

/// A sheet of pictures.
pub struct Sheet {
    /// Pixels per line.
    pub width: usize,
    /// Lines.
    pub height: usize,
    /// 8-bit red, green, blue.
    pub rgb: Vec<u8>,
}

/// The pictures of the variants in one row, the maps of their errors in the row below.
pub fn sheet(variants: &[(&Drawn, &[PixelError])], words_per_pixel: f64) -> Sheet {
    let Some((first, _)) = variants.first() else {
        return Sheet {
            width: 0,
            height: 0,
            rgb: vec![],
        };
    };
    let (width, height) = (first.frame.width, first.frame.height);
    let mut sheet = Sheet {
        width: variants.len() * (width + GAP) - GAP,
        height: 2 * height + GAP,
        rgb: vec![],
    };
    sheet.rgb = vec![255; 3 * sheet.width * sheet.height];
    for (column, (drawn, pixels)) in variants.iter().enumerate() {
        let left = column * (width + GAP);
        let map: Vec<u8> = pixels
            .iter()
            .flat_map(|pixel| colour(pixel, words_per_pixel))
            .collect();
        for (top, panel) in [(0, &drawn.rgb), (height + GAP, &map)] {
            for (y, line) in panel.chunks(3 * width).enumerate() {
                let start = 3 * ((top + y) * sheet.width + left);
                sheet.rgb[start..start + line.len()].copy_from_slice(line);
            }
        }
    }
    sheet
}

fn colour(pixel: &PixelError, words_per_pixel: f64) -> [u8; 3] {
    match pixel {
        PixelError::Background => BACKGROUND,
        PixelError::Presence => PRESENCE,
        PixelError::Object => OBJECT,
        PixelError::Same { depth, .. } => {
            let error = (depth / words_per_pixel).abs().log2();
            let level = ((error + FINEST) / (FINEST + COARSEST)).clamp(0.0, 1.0);
            // Black, blue, white.
            [level * level, level, level.sqrt()].map(|v| (v * 255.0).round() as u8)
        }
    }
}
