//! Scenes whose coefficients are rounded anew for each zone of the screen.

use imogene_analysis::metrics::ZoneScene;
use imogene_golden::format::Format;
use imogene_prepare::error::PrepareError;
use imogene_prepare::rounding::Anchor;
use imogene_prepare::{Options, prepare_with};
use imogene_scene::FramedScene;

/// The scene prepared for zones of `side` columns and lines, each with its middle as the anchor of all words.
///
/// # Errors
///
/// When it cannot be prepared in the format.
pub fn zones(
    scene: &FramedScene,
    format: Format,
    side: u32,
) -> Result<Vec<ZoneScene>, PrepareError> {
    let (width, height, side) = (scene.width as usize, scene.height as usize, side as usize);
    let mut all = vec![];
    for y in (0..height).step_by(side) {
        for x in (0..width).step_by(side) {
            let size = (side.min(width - x), side.min(height - y));
            let anchor = Anchor {
                x: (x + size.0 / 2) as i64,
                y: (y + size.1 / 2) as i64,
            };
            let options = Options {
                anchor: Some(anchor),
                ..Options::ROOTS
            };
            all.push(ZoneScene {
                first: (x, y),
                size,
                prepared: prepare_with(scene, format, options)?,
            });
        }
    }
    Ok(all)
}
