//! Pictures side by side, with maps of their errors below.

use super::Drawn;
use imogene_analysis::metrics::PixelError;
use imogene_analysis::metrics::map::colour;

/// White pixels between two panels.
const GAP: usize = 4;

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
