//! How often an object is loaded because several pieces of the screen touch it (source: 5.5).
//!
//! A box of `l x h` pixels anywhere on zones of `L x H` touches `(l + L)(h + H) / LH` of them on average, says the
//! source, for boxes that may begin anywhere between pixels. On whole pixels, where a box of one pixel touches one
//! zone, the average over all places is `(l + L - 1)(h + H - 1) / LH`, for boxes of any size.

use super::division::{Division, Piece};
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::slot::Slot;
use imogene_golden::object::words::Words;
use serde::Serialize;

/// How often objects are loaded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Duplication {
    /// Processors with at least a pixel of the screen to visit.
    pub boxes: u64,
    /// Loads of all pieces.
    pub loads: u64,
    /// Loads of a box: the mean of what was counted.
    pub measured: f64,
    /// The source's formula, mean over the boxes.
    pub formula: f64,
    /// The formula for whole pixels, mean over the boxes.
    pub on_whole_pixels: f64,
}

impl Duplication {
    /// Of these processors on a screen.
    pub(super) fn of(slots: &[Slot], division: Division, width: u32, height: u32) -> Duplication {
        let pieces = division.pieces(width, height);
        let mut sum = Duplication::default();
        for slot in slots {
            let window = slot.words.screen_box();
            if window.is_empty() {
                continue;
            }
            let touches = |piece: &&Piece| !piece.part_of(window).is_empty();
            sum.boxes += 1;
            sum.loads += pieces.iter().filter(touches).count() as u64;
            let [formula, whole] = expected(window, division);
            sum.formula += formula;
            sum.on_whole_pixels += whole;
        }
        let boxes = sum.boxes.max(1) as f64;
        Duplication {
            measured: sum.loads as f64 / boxes,
            formula: sum.formula / boxes,
            on_whole_pixels: sum.on_whole_pixels / boxes,
            ..sum
        }
    }
}

/// Pieces that a box of this size touches, by the source's formula and on whole pixels.
///
/// Of n interleaved groups, h lines touch the smaller of n and h wherever they are; the source has no formula for them.
pub fn expected(window: &ScreenBox, division: Division) -> [f64; 2] {
    let size = window.size().map(|n| n as f64);
    match division {
        Division::Zones { width, height } => {
            let zone = [width, height].map(f64::from);
            [0.0, 1.0].map(|less| {
                let along = |k: usize| (size[k] + zone[k] - less) / zone[k];
                along(0) * along(1)
            })
        }
        Division::Lines(groups) => [size[1].min(groups.into()); 2],
    }
}
