//! How often an object is loaded because several pieces of the screen touch it (source: 5.5).
//!
//! A box of `l x h` pixels anywhere on zones of `L x H` touches `(l + L)(h + H) / LH` of them on average, says the
//! source, for boxes that may begin anywhere between pixels. On whole pixels, where a box of one pixel touches one
//! zone, the average over all places is `(l + L - 1)(h + H - 1) / LH`, for boxes of any size.

use super::Division;
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
            let touches = |piece: &&super::Piece| !piece.part_of(window).is_empty();
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
fn expected(window: &ScreenBox, division: Division) -> [f64; 2] {
    let size = [window.x1 - window.x0 + 1, window.y1 - window.y0 + 1].map(|n| n as f64);
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

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x0: i64, y0: i64, l: i64, h: i64) -> ScreenBox {
        ScreenBox::of([x0, x0 + l - 1], [y0, y0 + h - 1])
    }

    /// The source's numbers: 80 in 128 gives 2.641, 80 in 64 gives 5.06.
    #[test]
    fn the_formula_is_the_source_s() {
        for (l, zone, wanted) in [(80, 128, 2.640625), (80, 64, 5.0625), (20, 32, 2.640625)] {
            let division = Division::Zones {
                width: zone,
                height: zone,
            };
            assert_eq!(expected(&at(0, 0, l, l), division)[0], wanted);
        }
    }

    /// Every place of boxes of several sizes, counted.
    #[test]
    fn the_mean_over_all_places_is_the_formula_for_whole_pixels() {
        let (width, height) = (6, 4);
        let division = Division::Zones { width, height };
        let pieces = division.pieces(60, 60);
        for (l, h) in [(1, 1), (2, 5), (6, 4), (13, 9), (30, 1)] {
            let mut touched = 0;
            for x0 in 0..i64::from(width) {
                for y0 in 0..i64::from(height) {
                    let window = at(x0, y0, l, h);
                    let touching = pieces.iter().filter(|p| !p.part_of(&window).is_empty());
                    touched += touching.count();
                }
            }
            let mean = touched as f64 / f64::from(width * height);
            let [source, whole] = expected(&at(0, 0, l, h), division);
            assert!((mean - whole).abs() < 1e-12, "{l} x {h}: {mean} {whole}");
            assert!(source > whole);
        }
        let lines = Division::Lines(4).pieces(60, 60);
        for h in [1, 3, 4, 9] {
            for y0 in 0..8 {
                let window = at(5, y0, 3, h);
                let touching = lines.iter().filter(|p| !p.part_of(&window).is_empty());
                assert_eq!(touching.count() as i64, h.min(4));
            }
        }
    }
}
