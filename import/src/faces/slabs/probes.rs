//! Places at which cells are asked whether they have all of the face and nothing else.

use super::strips::Strip;
use super::{WIDEST_GAP, Work};
use crate::faces::cell::Cell;
use crate::faces::planes::Planes;
use crate::faces::vector::Vector;

impl Work<'_> {
    /// Whether cells are strips, without a doubt.
    fn is_exact(&self) -> bool {
        !self.face.surface.is_sphere() && self.face.flat.is_none()
    }

    /// Slabs with places of the face that no cell has.
    pub fn lost(&self, cells: &[Cell], strips: &[Strip], planes: &Planes) -> Vec<f64> {
        if self.is_exact() {
            return vec![];
        }
        let taken = |p: &Vector| cells.iter().any(|cell| cell.takes(*p, planes));
        let inside = self.probed(strips, true);
        let lost = inside.filter(|(_, places)| !places.iter().all(taken));
        lost.map(|(middle, _)| middle).collect()
    }

    /// Whether a cell has places of strips that are not of the face.
    pub fn takes_others(&self, cell: &Cell, strips: &[Strip], planes: &Planes) -> bool {
        let mut outside = self.probed(strips, false).flat_map(|(_, places)| places);
        !self.is_exact() && outside.any(|p| cell.takes(p, planes))
    }

    /// For each strip that is of the face, or is not, the middle of its slab and places of it.
    fn probed(&self, strips: &[Strip], inside: bool) -> impl Iterator<Item = (f64, Vec<Vector>)> {
        let own = strips.iter().filter(move |strip| strip.inside == inside);
        own.map(|strip| {
            let middle = self.middle(strip.slab);
            let places = self.probes(strip.at).into_iter();
            let places = places.map(|v| self.chart.point(middle, v));
            (middle, places.collect())
        })
    }

    /// Places between two v, far out where one is open: a conic may come back there.
    fn probes(&self, [low, high]: [f64; 2]) -> Vec<f64> {
        if high - low <= WIDEST_GAP * self.face.size {
            return vec![];
        }
        let far = [0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0].map(|share| share * self.face.size);
        match (low.is_finite(), high.is_finite()) {
            (true, true) => {
                let shares = [0.1, 0.5, 0.9];
                shares.map(|share| low + share * (high - low)).to_vec()
            }
            (true, false) => far.map(|way| low + way).to_vec(),
            (false, true) => far.map(|way| high - way).to_vec(),
            (false, false) => vec![0.0],
        }
    }
}
