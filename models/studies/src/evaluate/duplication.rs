//! How many zones a box touches (source: 1.3.2, chapter 5).

use super::EvaluateError;
use super::scenes::{Moving, ZONE_SIDE, zone_machine};
use imogene_plan::zone::plan::ZonePlan;
use serde::Serialize;

/// Shares of the places at which a box touches 1, 2 and 4 zones; the rest touches more.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Touched {
    /// One zone.
    pub one: f64,
    /// Two.
    pub two: f64,
    /// Four.
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
    let (first, last) = match edges {
        Edges::Anywhere => (1, 2 * size + 1),
        Edges::OnPixels => (0, 2 * size - 1),
    };
    let zone = |half_pixels: u64| half_pixels / (2 * side);
    let along = |place: u64| zone(2 * place + last) - zone(2 * place + first) + 1;
    let along: Vec<u64> = (0..side).map(along).collect();
    let zones = along.iter().flat_map(|x| along.iter().map(move |y| x * y));
    let places = (side * side) as f64;
    let share = |wanted: u64| zones.clone().filter(|n| *n == wanted).count() as f64 / places;
    Touched {
        one: share(1),
        two: share(2),
        four: share(4),
        mean: zones.clone().sum::<u64>() as f64 / places,
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
        let parts = plan.zones.iter().map(|zone| zone.parts.len());
        zones += parts.sum::<usize>();
    }
    Ok(zones as f64 / (side * side) as f64)
}
