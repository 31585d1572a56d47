//! Places at which cells are asked whether they have all of the face and nothing else.

use super::face::WIDEST_GAP;
use super::strips::Strip;
use super::work::Work;
use crate::faces::cell::Cell;
use crate::faces::planes::Planes;

impl Work<'_> {
    /// Whether cells are strips, without a doubt.
    fn is_exact(&self) -> bool {
        !self.face.surface.is_sphere() && self.face.flat.is_none()
    }

    /// Slabs with places of the face that no cell has.
    pub fn lost(&self, cells: &[Cell], strips: &[Vec<Strip>], planes: &Planes) -> Vec<f64> {
        if self.is_exact() {
            return vec![];
        }
        let mut lost = vec![];
        for (slab, strips) in strips.iter().enumerate() {
            let middle = self.middle(slab);
            for strip in strips.iter().filter(|strip| strip.inside) {
                let mut places = self.probes(strip.at).into_iter();
                let taken = |v: f64| {
                    let p = self.chart.point(middle, v);
                    cells.iter().any(|cell| cell.takes(p, planes))
                };
                if !places.all(taken) {
                    lost.push(middle);
                }
            }
        }
        lost
    }

    /// Whether a cell has places of strips that are not of the face.
    pub fn takes_others(&self, cell: &Cell, strips: &[Vec<Strip>], planes: &Planes) -> bool {
        !self.is_exact()
            && strips.iter().enumerate().any(|(slab, strips)| {
                let middle = self.middle(slab);
                strips.iter().filter(|strip| !strip.inside).any(|strip| {
                    let mut places = self.probes(strip.at).into_iter();
                    places.any(|v| cell.takes(self.chart.point(middle, v), planes))
                })
            })
    }

    /// Places between two v, far out where one is open: a conic may come back there.
    pub fn probes(&self, [low, high]: [f64; 2]) -> Vec<f64> {
        if high - low <= WIDEST_GAP * self.face.size {
            return vec![];
        }
        let far = [0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0].map(|share| share * self.face.size);
        match (low.is_finite(), high.is_finite()) {
            (true, true) => [0.1, 0.5, 0.9]
                .map(|share| low + share * (high - low))
                .to_vec(),
            (true, false) => far.map(|way| low + way).to_vec(),
            (false, true) => far.map(|way| high - way).to_vec(),
            (false, false) => vec![0.0],
        }
    }
}
