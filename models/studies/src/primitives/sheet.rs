//! Pictures side by side, with maps of their errors below.

use super::Drawn;
use crate::kit::sheet::Sheet;
use imogene_analysis::metrics::PixelError;
use imogene_analysis::metrics::map::colour;

/// The pictures of the variants in one row, the maps of their errors in the row below.
pub fn sheet(variants: &[(&Drawn, &[PixelError])], words_per_pixel: f64) -> Sheet {
    let frames = variants.iter().map(|(drawn, _)| &drawn.frame);
    let size = frames.map(|frame| (frame.width, frame.height)).next();
    let pair = |(drawn, pixels): &(&Drawn, &[PixelError])| {
        let map = pixels
            .iter()
            .flat_map(|pixel| colour(pixel, words_per_pixel));
        [drawn.rgb.clone(), map.collect()]
    };
    let pairs: Vec<[Vec<u8>; 2]> = variants.iter().map(pair).collect();
    Sheet::of(&pairs, size.unwrap_or_default(), variants.len())
}
