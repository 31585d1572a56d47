//! How many zones a box touches (source: 1.3.2, chapter 5).

use super::EvaluateError;
use super::scenes::{Moving, ZONE_SIDE, zone_machine};
use imogene_plan::zone::plan::ZonePlan;
use serde::Serialize;

/// Shares of the places at which a box touches 1, 2 and 4 zones; the rest touches more.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Touched {
    pub one: f64,
    pub two: f64,
    pub four: f64,
    /// Mean number of zones: the duplication factor.
    pub mean: f64,
}

/// How the edges of a box lie to the pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edges {
    /// Anywhere: the box is a rectangle of the plane, as in the source.
    Anywhere,
    /// The box is made of whole pixels, as in a machine.
    OnPixels,
}

/// Counts the zones of a square box at every place of a grid over one zone.
pub fn touched(size: u64, side: u64, edges: Edges) -> Touched {
    // In half pixels. A rectangle whose edges are on odd half pixels has no edge on an edge of a zone, and its places
    // stand for all others.
    let first = |place: u64| match edges {
        Edges::Anywhere => 2 * place + 1,
        Edges::OnPixels => 2 * place,
    };
    let last = |place: u64| match edges {
        Edges::Anywhere => first(place) + 2 * size,
        Edges::OnPixels => first(place) + 2 * size - 1,
    };
    let along = |place: u64| last(place) / (2 * side) - first(place) / (2 * side) + 1;
    let mut counts = [0u64; 3];
    let mut sum = 0;
    for x in 0..side {
        for y in 0..side {
            let zones = along(x) * along(y);
            sum += zones;
            if let Some(place) = [1, 2, 4].iter().position(|&n| n == zones) {
                counts[place] += 1;
            }
        }
    }
    let places = (side * side) as f64;
    let [one, two, four] = counts.map(|count| count as f64 / places);
    Touched {
        one,
        two,
        four,
        mean: sum as f64 / places,
    }
}

/// The source's formula.
pub fn formula(size: f64, side: f64) -> f64 {
    ((size + side) / side).powi(2)
}

/// Mean zones of a ball of 80 pixels in the plans of a zone machine, at all places of a zone.
pub fn planned(ball: &Moving) -> Result<f64, EvaluateError> {
    let side = i64::from(ZONE_SIDE);
    let mut zones = 0;
    for place in (0..side).flat_map(|x| (0..side).map(move |y| [x, y])) {
        let plan = ZonePlan::of(&ball.at(&[place], [3 * ZONE_SIDE; 2]), zone_machine(1))?;
        zones += plan
            .zones
            .iter()
            .map(|zone| zone.parts.len())
            .sum::<usize>();
    }
    Ok(zones as f64 / (side * side) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rectangles_follow_the_formula_exactly() {
        for (size, side) in [(20, 32), (80, 128), (80, 64), (1, 8), (8, 8), (37, 16)] {
            let found = touched(size, side, Edges::Anywhere);
            let expected = formula(size as f64, side as f64);
            assert!((found.mean - expected).abs() < 1e-12, "{size} in {side}");
        }
        let Touched {
            one,
            two,
            four,
            mean,
        } = touched(20, 32, Edges::Anywhere);
        // l h / L H, (h L + l H - 2 l h) / L H, (L - l)(H - h) / L H.
        assert_eq!(
            [four, two, one],
            [400.0 / 1024.0, 480.0 / 1024.0, 144.0 / 1024.0]
        );
        assert_eq!(mean, one + 2.0 * two + 4.0 * four);
    }

    #[test]
    fn a_pixel_is_in_one_zone() {
        assert_eq!(touched(1, 8, Edges::OnPixels).mean, 1.0);
        assert_eq!(touched(9, 8, Edges::OnPixels).mean, 4.0);
    }
}
