//! How each cell is drawn: by its surfaces, by facets where it is flat or its surfaces are refused, or not at all.

use super::cell::Cells;
use super::grid::{Corners, HeightGrid, is_plane, twist};
use super::map::{IMAGE, Map, VIEW};
use crate::error::{Error, Result};
use imogene_algebra::rational::{from_decimal, to_f64};
use imogene_algebra::vector::{dot, length, minus, square};
use imogene_golden::format::Format;
use imogene_prepare::{Framing, Options, refused};

/// Pixels by which a patch may bulge from its two facets (C17 of the source's systems).
const FLAT: f64 = 0.5;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    Surfaces,
    Facets,
    LeftOut,
}

pub(super) struct Cell {
    pub column: usize,
    pub row: usize,
    pub corners: Corners,
    pub form: Form,
}

pub(super) fn count(cells: &[Cell], form: Form) -> usize {
    cells.iter().filter(|cell| cell.form == form).count()
}

impl Map<'_> {
    pub fn cells(&self, grid: &HeightGrid) -> Vec<Cell> {
        let factor = from_decimal(self.options.height_factor);
        let mut cells = vec![];
        for row in 0..grid.rows - 1 {
            for column in 0..grid.columns - 1 {
                let known = |v: usize, u: usize| grid.height(column + u, row + v);
                let known = [0, 1].map(|v| [0, 1].map(|u| known(v, u)));
                if known.as_flattened().iter().all(Option::is_some) {
                    let height = |h: Option<f64>| from_decimal(h.expect("checked")) * &factor;
                    cells.push(Cell {
                        column,
                        row,
                        corners: known.map(|row| row.map(height)),
                        form: Form::Surfaces,
                    });
                }
            }
        }
        cells
    }

    /// Facets for the cells that are flat on the screen, if that is asked for; how many they are.
    pub fn choose_facets(&self, cells: &mut [Cell]) -> usize {
        if self.options.cells != Cells::Auto {
            return 0;
        }
        for cell in cells.iter_mut() {
            if is_plane(&cell.corners) || self.bulge(cell).is_some_and(|pixels| pixels < FLAT) {
                cell.form = Form::Facets;
            }
        }
        count(cells, Form::Facets)
    }

    /// Most pixels between a patch and its facets on the screen: |e| / 4 upwards at the corner that is nearest along
    /// the gaze; `None` if a corner is beside or behind the eye.
    fn bulge(&self, cell: &Cell) -> Option<f64> {
        let up = to_f64(&twist(&cell.corners)).abs() / 4.0;
        let mut most = 0f64;
        for (along, square) in self.corners_from_eye(cell) {
            if along <= 0.0 {
                return None;
            }
            // A displacement d moves a point on the screen by at most d (1 + tan) / depth of the distance to it.
            let aside = (square - along * along).max(0.0).sqrt() / along;
            most = most.max(up * (1.0 + aside) / along);
        }
        Some(most * f64::from(IMAGE.height) / VIEW)
    }

    /// How far each corner is before the eye, along the gaze, and the square of its distance.
    fn corners_from_eye(&self, cell: &Cell) -> [(f64, f64); 4] {
        let gaze = minus(self.target, self.eye);
        [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[u, v]| {
            let place = self.place([cell.column + u, cell.row + v]);
            let [x, z] = place.map(|p| to_f64(&p));
            let from = minus([x, to_f64(&cell.corners[v][u]), z], self.eye);
            (dot(from, gaze) / length(gaze), square(from))
        })
    }

    /// Facets for cells whose surfaces the base format refuses, nothing for those behind the eye; how many of each.
    pub fn replace_refused(&self, cells: &mut [Cell]) -> Result<(usize, usize)> {
        let facets_before = count(cells, Form::Facets);
        for cell in cells.iter_mut() {
            // A cell is within the hull of its corners.
            let corners = self.corners_from_eye(cell);
            if corners.iter().all(|(along, _)| *along <= 0.0) {
                cell.form = Form::LeftOut;
            }
        }
        let mut open: Vec<usize> = (0..cells.len()).collect();
        open.retain(|&index| cells[index].form != Form::LeftOut);
        while !open.is_empty() {
            let mut owners = vec![];
            let mut scene = self.empty_scene();
            for &index in &open {
                let objects = self.objects(&cells[index], cells)?;
                owners.extend(objects.iter().map(|_| index));
                scene.objects.extend(objects);
            }
            if scene.objects.is_empty() {
                break;
            }
            let framed = scene.frame(scene.image.width, scene.image.height);
            let framed = framed.map_err(|e| Error::whole(e, "see docs/scene-format.md"))?;
            let mut again = vec![];
            for (object, _) in refused(&framed, Format::BASE, Options::default()) {
                let cell = owners[object];
                if again.last() != Some(&cell) {
                    again.push(cell);
                    cells[cell].form = match cells[cell].form {
                        Form::Facets => Form::LeftOut,
                        _ => Form::Facets,
                    };
                }
            }
            open = again;
            open.retain(|&cell| cells[cell].form == Form::Facets);
        }
        let by_facets = count(cells, Form::Facets).saturating_sub(facets_before);
        Ok((by_facets, count(cells, Form::LeftOut)))
    }
}
