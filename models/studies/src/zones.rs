//! Scenes whose coefficients are rounded anew for each zone of the screen.

use imogene_analysis::metrics::ZoneScene;
use imogene_golden::format::Format;
use imogene_plan::culling::zones::window_of;
use imogene_plan::split::{Division, Piece};
use imogene_prepare::error::PrepareError;
use imogene_prepare::rounding::Anchor;
use imogene_prepare::{Options, prepare_with};
use imogene_scene::FramedScene;

/// The scene prepared for zones of `side` columns and lines, each with its middle as the anchor of all words.
/// Fails when it cannot be prepared in the format.
pub fn zones(
    scene: &FramedScene,
    format: Format,
    side: u32,
) -> Result<Vec<ZoneScene>, PrepareError> {
    let (width, height) = (side, side);
    let pieces = Division::Zones { width, height }.pieces(scene.width, scene.height);
    let zone = |piece: Piece| {
        let anchor = Anchor {
            x: i64::from(piece.x0 + piece.width / 2),
            y: i64::from(piece.y0 + piece.height / 2),
        };
        let mut options = Options::ROOTS;
        options.anchor = Some(anchor);
        Ok(ZoneScene {
            window: window_of(&piece),
            prepared: prepare_with(scene, format, options)?,
        })
    };
    pieces.into_iter().map(zone).collect()
}
