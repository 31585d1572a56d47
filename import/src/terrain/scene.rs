//! The scene of a grid of heights.

use super::form::{Form, count};
use super::grid::HeightGrid;
use super::map::Map;
use super::options::{Region, TerrainOptions};
use crate::error::unusable;
use crate::{Imported, Result};
use serde_json::json;

/// Most cells of a scene.
pub const MAX_CELLS: usize = 1 << 14;

/// The scene of a grid; `file` is the name that messages give it.
pub fn scene_of(grid: &HeightGrid, file: &str, options: &TerrainOptions) -> Result<Imported> {
    let grid = chosen(grid, file, options)?;
    let map = Map::new(&grid, file, options)?;
    let mut cells = map.cells(&grid);
    if cells.is_empty() {
        let accepted = "a cell needs its four corners";
        return Err(unusable(file, "no cell has all four heights", accepted));
    }
    let flat = map.choose_facets(&mut cells);
    let (by_facets, left_out) = map.replace_refused(&mut cells)?;
    let mut scene = map.empty_scene();
    for cell in &cells {
        scene.objects.extend(map.objects(cell, &cells)?);
    }
    if scene.objects.is_empty() {
        let accepted = "an eye and a target that see the terrain are needed";
        return Err(unusable(file, "every cell lies behind the eye", accepted));
    }
    let holes = (grid.columns - 1) * (grid.rows - 1) - cells.len();
    let notes = notes(holes, flat, by_facets, left_out);
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
        notes,
    })
}

fn notes(holes: usize, flat: usize, by_facets: usize, left_out: usize) -> Vec<String> {
    let texts = [
        (holes, "cells without a height at every corner are holes"),
        (
            flat,
            "cells that bulge by less than half a pixel are drawn by facets",
        ),
        (
            by_facets,
            "cells whose surface passes too near the eye for the depth word are drawn by facets",
        ),
        (left_out, "cells are not in front of the eye and left out"),
    ];
    let said = texts.into_iter().filter(|(count, _)| *count > 0);
    said.map(|(count, text)| format!("{count} {text}"))
        .collect()
}

/// The nodes that are asked for.
fn chosen(grid: &HeightGrid, file: &str, options: &TerrainOptions) -> Result<HeightGrid> {
    let whole = [grid.columns, grid.rows];
    let Region { first, nodes } = options.region.unwrap_or(Region {
        first: [0, 0],
        nodes: whole,
    });
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
        return Err(unusable(file, problem, accepted));
    }
    let part = grid.part(first, nodes, every);
    let cells = (part.columns - 1) * (part.rows - 1);
    if cells > MAX_CELLS {
        let accepted = format!(
            "at most {MAX_CELLS} are possible; take a region, or every second or third node"
        );
        return Err(unusable(file, format!("{cells} cells"), accepted));
    }
    Ok(part)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::terrain::cell::{Cells, Edge};
    use crate::terrain::objects::SEAM;
    use crate::terrain::read::read;
    use imogene_algebra::rational::{fraction, integer};
    use imogene_scene::{Object, Quadric, SceneFile};

    const HILLS: &str = "step 60 90\n10 20 30 20\n15 40.5 60 20\n10 30 - 10\n";

    fn imported(options: &TerrainOptions) -> Result<Imported> {
        scene_of(&read(HILLS.as_bytes(), "hills").unwrap(), "hills", options)
    }

    #[test]
    fn a_scene_is_one_that_can_be_read_back() {
        for cells in [Cells::Bilinear, Cells::Auto, Cells::Ruled] {
            let defaults = TerrainOptions::default();
            let made = imported(&TerrainOptions { cells, ..defaults }).unwrap();
            let text = made.scene.to_toml().unwrap();
            assert_eq!(SceneFile::parse(&text, "again").unwrap(), made.scene);
            assert_eq!(made.report["cells"], 4);
            assert_eq!(made.report["without_data"], 2);
            assert!(made.notes[0].contains("2 cells without a height"));
        }
    }

    /// Neighbours pass through the same edge and reach a little beyond it; where there is no neighbour a cell ends at
    /// its edge.
    #[test]
    fn neighbours_meet_in_their_edge_and_overlap() {
        let made = imported(&TerrainOptions::default()).unwrap();
        let cell = |name: &str| {
            let mut objects = made.scene.objects.iter();
            objects.find(|o| o.name == name).expect("a cell")
        };
        let (left, right) = (cell("cell-0-0"), cell("cell-1-0"));
        let reach = |cell: &Object, edge: Edge| {
            let cut = &cell.cuts[edge as usize];
            let from_edge = edge.cut(0.0);
            let along = (0..3).map(|k| (cut.point[k] - from_edge.point[k]) * cut.normal[k]);
            along.sum::<f64>()
        };
        assert_eq!(reach(left, Edge::East), SEAM);
        assert_eq!(reach(right, Edge::West), SEAM);
        assert_eq!(reach(left, Edge::West), 0.0);
        assert_eq!(reach(right, Edge::North), 0.0);
        // The edge runs from height 20 to 40.5.
        for v in [0, 1, 2, 4] {
            let place = fraction(v, 4);
            let height = integer(20) + fraction(41, 2) * &place;
            let at = |cell: &Object, u: i64| {
                let quadric = Quadric::from_shape(&cell.shape).unwrap();
                quadric.value_at(&integer(u), &height, &place)
            };
            assert_eq!(at(left, 1), integer(0));
            assert_eq!(at(right, 0), integer(0));
        }
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        let with = |change: &dyn Fn(&mut TerrainOptions)| {
            let mut options = TerrainOptions::default();
            change(&mut options);
            imported(&options).unwrap_err().to_string()
        };
        let (first, nodes) = ([2, 0], [3, 2]);
        let out = with(&|o| o.region = Some(Region { first, nodes }));
        assert!(out.contains("within the grid of 4 x 3 nodes"), "{out}");
        let wide = with(&|o| o.every = 3);
        assert!(wide.contains("every 3 of them"), "{wide}");
        let back = with(&|o| {
            o.eye = Some([0.0, 100.0, -1000.0]);
            o.target = Some([0.0, 100.0, -2000.0]);
        });
        assert!(back.contains("every cell lies behind the eye"), "{back}");
        let huge = HeightGrid {
            columns: 200,
            rows: 200,
            step: [1.0, 1.0],
            heights: vec![Some(0.0); 40_000],
        };
        let many = scene_of(&huge, "huge", &TerrainOptions::default()).unwrap_err();
        assert!(many.to_string().contains("39601 cells"), "{many}");
    }
}
