//! The objects of a cell, and how far they reach beyond its edges.

use super::cell::{Cells, Piece, bilinear_piece, facets};
use super::exact::decimals;
use super::form::{Cell, Form};
use super::map::{BANDS, Map};
use super::ruled::pieces_for;
use crate::error::unusable;
use crate::object;
use crate::{ImportError, Result};
use imogene_algebra::rational::{from_decimal, to_f64};
use imogene_scene::{Object, Scale, Shape, Step, Surface};

/// Part of a cell by which a patch reaches beyond an edge that it shares with facets, whose corners are rounded to a
/// sixteenth of a pixel.
const OVERLAP: f64 = 1.0 / 16.0;

/// Part of a cell by which a surface reaches beyond an edge that it shares with another surface. Both pass through the
/// edge, but their depths are rounded, each by itself, and a pixel on the edge could fall to neither.
pub(super) const SEAM: f64 = 1.0 / 256.0;

/// By how much of a cell its surfaces reach beyond its edges in the west, east, north and south; `cells` are in rows
/// from the north, each from the west.
fn outwards(cell: &Cell, cells: &[Cell]) -> [f64; 4] {
    let (c, r) = (cell.column, cell.row);
    let neighbours = [
        (r, c.wrapping_sub(1)),
        (r, c + 1),
        (r.wrapping_sub(1), c),
        (r + 1, c),
    ];
    neighbours.map(|place| {
        let found = cells.binary_search_by_key(&place, |cell| (cell.row, cell.column));
        match found.map(|index| cells[index].form) {
            Ok(Form::Facets) => OVERLAP,
            Ok(Form::Surfaces) => SEAM,
            Ok(Form::LeftOut) | Err(_) => 0.0,
        }
    })
}

impl Map<'_> {
    /// The objects of a cell, one of `cells`.
    pub(super) fn objects(&self, cell: &Cell, cells: &[Cell]) -> Result<Vec<Object>> {
        let shapes: Vec<(Shape, Vec<_>)> = match cell.form {
            Form::LeftOut => return Ok(vec![]),
            Form::Facets => vec![(Shape::Mesh(facets(&cell.corners)), vec![])],
            Form::Surfaces => {
                let pieces = self.pieces(cell, cells).ok_or_else(|| self.digits())?;
                let shape = |piece: Piece| {
                    let coefficients = piece.coefficients;
                    (Shape::Quadric { coefficients }, piece.cuts)
                };
                pieces.into_iter().map(shape).collect()
            }
        };
        let [x, z] = self.place([cell.column, cell.row]);
        let [x, z] = decimals([&x, &z]).ok_or_else(|| self.digits())?;
        let [sx, sz] = self.step.each_ref().map(to_f64);
        let single = shapes.len() == 1;
        let object = |(index, (shape, cuts)): (usize, (Shape, Vec<_>))| {
            let mut name = format!("cell-{}-{}", cell.column, cell.row);
            if !single {
                name = format!("{name}-{index}");
            }
            let material = format!("altitude-{}", self.band(cell));
            Object {
                mode: Surface::Patch,
                place: vec![
                    Step::Scale(Scale::PerAxis([sx, 1.0, sz])),
                    Step::Translate([x, 0.0, z]),
                ],
                cuts,
                ..object(name, shape, material)
            }
        };
        Ok(shapes.into_iter().enumerate().map(object).collect())
    }

    fn pieces(&self, cell: &Cell, cells: &[Cell]) -> Option<Vec<Piece>> {
        let outwards = outwards(cell, cells);
        if self.options.cells == Cells::Ruled {
            let [x, z] = self.place([cell.column, cell.row]);
            let eye = [
                (from_decimal(self.eye[0]) - x) / &self.step[0],
                (from_decimal(self.eye[2]) - z) / &self.step[1],
            ];
            return pieces_for(&cell.corners, &eye, outwards);
        }
        Some(vec![bilinear_piece(&cell.corners, outwards)?])
    }

    fn digits(&self) -> ImportError {
        unusable(
            self.file,
            "the heights, the distance of nodes and the eye have too many digits together for exact surfaces",
            "about 5 significant digits each are possible",
        )
    }

    /// Index of the colour of a cell: its mean height.
    fn band(&self, cell: &Cell) -> usize {
        let mean = cell.corners.iter().flatten().map(to_f64).sum::<f64>() / 4.0;
        let (low, high) = self.heights;
        let part = (mean - low) / (high - low).max(f64::MIN_POSITIVE);
        ((part * BANDS.len() as f64) as usize).min(BANDS.len() - 1)
    }
}
