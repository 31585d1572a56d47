//! The scene of a grid of heights.

use super::cell::{Cells, Piece, bilinear_piece, facets};
use super::exact::decimals;
use super::form::{Cell, Form, count};
use super::grid::HeightGrid;
use super::map::{BANDS, Map};
use super::ruled::ruled_pieces;
use super::{Region, TerrainOptions};
use crate::error::{Error, Result};
use crate::kit::{Imported, object};
use imogene_algebra::rational::{from_decimal, to_f64};
use imogene_scene::{Object, Scale, Shape, Step, Surface};
use serde_json::json;

pub const MAX_CELLS: usize = 1 << 14;

pub fn scene_of(grid: &HeightGrid, options: &TerrainOptions) -> Result<Imported> {
    let grid = chosen(grid, options)?;
    let map = Map::new(&grid, options)?;
    let mut cells = map.cells(&grid);
    if cells.is_empty() {
        let accepted = "a cell needs its four corners";
        return Err(Error::whole("no cell has all four heights", accepted));
    }
    let flat = map.choose_facets(&mut cells);
    let (by_facets, left_out) = map.replace_refused(&mut cells)?;
    let mut scene = map.empty_scene();
    for cell in &cells {
        scene.objects.extend(map.objects(cell, &cells)?);
    }
    if scene.objects.is_empty() {
        let accepted = "an eye and a target that see the terrain are needed";
        return Err(Error::whole("every cell lies behind the eye", accepted));
    }
    let holes = (grid.columns - 1) * (grid.rows - 1) - cells.len();
    let bulging = "cells that bulge by less than half a pixel are drawn by facets";
    let too_near =
        "cells whose surface passes too near the eye for the depth word are drawn by facets";
    let notes = [
        (holes, "cells without a height at every corner are holes"),
        (flat, bulging),
        (by_facets, too_near),
        (left_out, "cells are not in front of the eye and left out"),
    ];
    let said = notes.iter().filter(|(count, _)| *count > 0);
    let of = |form: Form| count(&cells, form);
    let report = json!({
        "columns": grid.columns,
        "rows": grid.rows,
        "step": grid.step,
        "cells": cells.len(),
        "cells_of_surfaces": of(Form::Surfaces),
        "cells_of_facets": of(Form::Facets),
        "facets_because_flat": flat,
        "facets_because_refused": by_facets,
        "left_out": left_out,
        "without_data": holes,
        "eye": map.eye,
        "target": map.target,
    });
    Ok(Imported {
        scene,
        report,
        notes: said
            .map(|(count, text)| format!("{count} {text}"))
            .collect(),
    })
}

fn chosen(grid: &HeightGrid, options: &TerrainOptions) -> Result<HeightGrid> {
    let whole = [grid.columns, grid.rows];
    let (first, nodes) = ([0, 0], whole);
    let Region { first, nodes } = options.region.unwrap_or(Region { first, nodes });
    let every = options.every;
    let fits = (0..2).all(|k| {
        let end = first[k].checked_add(nodes[k]);
        end.is_some_and(|end| end <= whole[k]) && every > 0 && nodes[k] > every
    });
    if !fits {
        let ([columns, rows], [c, r], [width, depth]) = (nodes, first, whole);
        let problem = format!(
            "a region of {columns} x {rows} nodes from node ({c}, {r}), every {every} of them"
        );
        let accepted = format!(
            "at least two nodes a side within the grid of {width} x {depth} nodes are needed"
        );
        return Err(Error::whole(problem, accepted));
    }
    let part = grid.part(first, nodes, every);
    let cells = (part.columns - 1) * (part.rows - 1);
    if cells > MAX_CELLS {
        let accepted = format!(
            "at most {MAX_CELLS} are possible; take a region, or every second or third node"
        );
        return Err(Error::whole(format!("{cells} cells"), accepted));
    }
    Ok(part)
}

/// Part of a cell by which a patch reaches over an edge to facets, whose corners are rounded to a 16th of a pixel.
const OVERLAP: f64 = 1.0 / 16.0;

/// Part of a cell by which a surface reaches beyond an edge that it shares with another surface. Both pass through the
/// edge, but their depths are rounded, each by itself, and a pixel on the edge could fall to neither.
const SEAM: f64 = 1.0 / 256.0;

/// Parts of a cell by which its surfaces reach over its edges in the west, east, north and south; `cells` are sorted.
fn outwards(cell: &Cell, cells: &[Cell]) -> [f64; 4] {
    let (c, r) = (cell.column, cell.row);
    let (west, north) = (c.wrapping_sub(1), r.wrapping_sub(1));
    [(r, west), (r, c + 1), (north, c), (r + 1, c)].map(|place| {
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
                let shape = |(coefficients, cuts)| (Shape::Quadric { coefficients }, cuts);
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
            return ruled_pieces(&cell.corners, &eye, outwards);
        }
        Some(vec![bilinear_piece(&cell.corners, outwards)?])
    }

    fn digits(&self) -> Error {
        let problem = "the heights, the distance of nodes and the eye have too many digits together for exact surfaces";
        Error::whole(problem, "about 5 significant digits each are possible")
    }

    /// Index of the colour of a cell: its mean height.
    fn band(&self, cell: &Cell) -> usize {
        let mean = cell.corners.iter().flatten().map(to_f64).sum::<f64>() / 4.0;
        let (low, high) = self.heights;
        let part = (mean - low) / (high - low).max(f64::MIN_POSITIVE);
        ((part * BANDS.len() as f64) as usize).min(BANDS.len() - 1)
    }
}
