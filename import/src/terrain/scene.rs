//! The scene of a grid of heights.

use super::cell::{Cells, Piece, bilinear_piece, facets, pieces_for};
use super::exact::decimals;
use super::grid::{Corners, HeightGrid, is_plane, twist};
use super::options::{Region, TerrainOptions};
use crate::{ImportError, Imported};
use imogene_models::format::Format;
use imogene_models::prepare::error::PrepareError;
use imogene_models::prepare::refused;
use imogene_models::rational::{fraction, from_decimal, integer, to_f64};
use imogene_models::scene::{
    Camera, ImageSize, Light, Material, Node, Object, Scale, SceneFile, Shape, Step, Surface,
};
use num_rational::BigRational;
use serde_json::json;

/// Most cells of a scene.
pub const MAX_CELLS: usize = 1 << 14;

/// Colours of altitudes, lowest first, as on a map.
const BANDS: [[f64; 3]; 7] = [
    [0.25, 0.45, 0.30],
    [0.40, 0.58, 0.32],
    [0.60, 0.68, 0.38],
    [0.78, 0.72, 0.46],
    [0.70, 0.56, 0.38],
    [0.58, 0.48, 0.42],
    [0.93, 0.94, 0.96],
];

/// Part of a cell by which a patch reaches beyond an edge that it shares with facets, whose corners are rounded to a sixteenth of a pixel.
const OVERLAP: f64 = 1.0 / 16.0;

/// Part of a cell by which a surface reaches beyond an edge that it shares with another surface. Both pass through the edge, but their depths are rounded, each by itself, and a
/// pixel on the edge could fall to neither.
const SEAM: f64 = 1.0 / 256.0;

/// Pixels by which a patch may bulge from its two facets (C17 of the source's systems).
const FLAT: f64 = 0.5;

/// How a cell is drawn at last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Surfaces,
    Facets,
    LeftOut,
}

/// One cell with four heights.
struct Cell {
    column: usize,
    row: usize,
    corners: Corners,
    form: Form,
}

/// By how much of a cell its surfaces reach beyond its edges in the west, east, north and south; `cells` are in rows from the north, each from the west.
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

/// The scene of a grid; `file` is the name that messages give it.
pub fn scene_of(
    grid: &HeightGrid,
    file: &str,
    options: &TerrainOptions,
) -> Result<Imported, ImportError> {
    let grid = chosen(grid, file, options)?;
    let map = Map::new(&grid, file, options)?;
    let mut cells = map.cells(&grid);
    if cells.is_empty() {
        return Err(unusable(
            file,
            "no cell has all four heights".into(),
            "a cell needs its four corners",
        ));
    }
    let flat = map.choose_facets(&mut cells);
    let (by_facets, left_out) = map.replace_refused(&mut cells)?;
    let scene = map.scene(&cells)?;
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

fn count(cells: &[Cell], form: Form) -> usize {
    cells.iter().filter(|cell| cell.form == form).count()
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

fn unusable(file: &str, problem: String, accepted: &str) -> ImportError {
    ImportError::Unusable {
        file: file.to_owned(),
        problem,
        accepted: accepted.to_owned(),
    }
}

/// The nodes that are asked for.
fn chosen(
    grid: &HeightGrid,
    file: &str,
    options: &TerrainOptions,
) -> Result<HeightGrid, ImportError> {
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
        let [columns, rows] = nodes;
        let problem = format!(
            "a region of {columns} x {rows} nodes from node ({}, {}), every {every} of them",
            first[0], first[1]
        );
        let accepted = format!(
            "at least two nodes a side within the grid of {} x {} nodes are needed",
            whole[0], whole[1]
        );
        return Err(unusable(file, problem, &accepted));
    }
    let part = grid.part(first, nodes, every);
    let cells = (part.columns - 1) * (part.rows - 1);
    if cells > MAX_CELLS {
        let accepted = format!(
            "at most {MAX_CELLS} are possible; take a region, or every second or third node"
        );
        return Err(unusable(file, format!("{cells} cells"), &accepted));
    }
    Ok(part)
}

/// Where things are.
struct Map<'a> {
    file: &'a str,
    options: &'a TerrainOptions,
    step: [BigRational; 2],
    /// Scene coordinates of the first node: x and z.
    first: [BigRational; 2],
    heights: (f64, f64),
    eye: [f64; 3],
    target: [f64; 3],
    /// In scene units.
    viewer_distance: f64,
}

/// Height of the picture at the distance of the screen plane, in viewer distances.
const VIEW: f64 = 0.8;

impl<'a> Map<'a> {
    fn new(
        grid: &HeightGrid,
        file: &'a str,
        options: &'a TerrainOptions,
    ) -> Result<Map<'a>, ImportError> {
        let factor = options.height_factor;
        let (low, high) = grid.range().ok_or_else(|| {
            unusable(
                file,
                "no node of the region has a height".into(),
                "choose another region",
            )
        })?;
        let heights = if factor > 0.0 {
            (low * factor, high * factor)
        } else {
            (high * factor, low * factor)
        };
        let step = grid.step.map(from_decimal);
        let nodes = [grid.columns, grid.rows];
        let first: [BigRational; 2] =
            std::array::from_fn(|k| -&step[k] * fraction(nodes[k] as i64 - 1, 2));
        let half = first.each_ref().map(|v| -to_f64(v));
        let extent = 2.0 * half[0].max(half[1]);
        let middle = 0.5 * (heights.0 + heights.1);
        let eye = options.eye.unwrap_or([
            0.0,
            short(heights.1 + 0.3 * extent),
            short(half[1] + 0.45 * extent),
        ]);
        let target = options.target.unwrap_or([0.0, short(middle), 0.0]);
        // The near end is at half the viewer distance from the eye; a small one also keeps the words of surfaces that pass the eye small.
        let outside = |value: f64, low: f64, high: f64| (low - value).max(value - high).max(0.0);
        let gaps = [
            outside(eye[0], -half[0], half[0]),
            outside(eye[1], heights.0, heights.1),
            outside(eye[2], -half[1], half[1]),
        ];
        let nearest = gaps.iter().map(|g| g * g).sum::<f64>().sqrt();
        Ok(Map {
            file,
            options,
            first,
            heights,
            eye,
            target,
            viewer_distance: short(nearest.clamp(extent / 200.0, extent / 8.0)),
            step,
        })
    }

    /// The cells with four heights.
    fn cells(&self, grid: &HeightGrid) -> Vec<Cell> {
        let factor = from_decimal(self.options.height_factor);
        let mut cells = vec![];
        for row in 0..grid.rows - 1 {
            for column in 0..grid.columns - 1 {
                let known = |v: usize, u: usize| grid.height(column + u, row + v);
                let [Some(nw), Some(ne), Some(sw), Some(se)] =
                    [known(0, 0), known(0, 1), known(1, 0), known(1, 1)]
                else {
                    continue;
                };
                let [nw, ne, sw, se] = [nw, ne, sw, se].map(|h| from_decimal(h) * &factor);
                cells.push(Cell {
                    column,
                    row,
                    corners: [[nw, ne], [sw, se]],
                    form: Form::Surfaces,
                });
            }
        }
        cells
    }

    /// Facets for the cells that are flat on the screen, if that is asked for; how many they are.
    fn choose_facets(&self, cells: &mut [Cell]) -> usize {
        if self.options.cells != Cells::Auto {
            return 0;
        }
        let mut count = 0;
        for cell in cells {
            if is_plane(&cell.corners) || self.bulge(cell).is_some_and(|pixels| pixels < FLAT) {
                cell.form = Form::Facets;
                count += 1;
            }
        }
        count
    }

    /// Most pixels between a patch and its facets on the screen: |e| / 4 upwards at the corner that is nearest along the gaze; nothing if a corner is beside or
    /// behind the eye.
    fn bulge(&self, cell: &Cell) -> Option<f64> {
        let up = to_f64(&twist(&cell.corners)).abs() / 4.0;
        let gaze: [f64; 3] = std::array::from_fn(|k| self.target[k] - self.eye[k]);
        let length = gaze.iter().map(|g| g * g).sum::<f64>().sqrt();
        let mut most = 0f64;
        for v in 0..2 {
            for u in 0..2 {
                let [x, z] = self
                    .place([cell.column + u, cell.row + v])
                    .map(|p| to_f64(&p));
                let point = [x, to_f64(&cell.corners[v][u]), z];
                let from: [f64; 3] = std::array::from_fn(|k| point[k] - self.eye[k]);
                let along = from.iter().zip(&gaze).map(|(a, b)| a * b).sum::<f64>() / length;
                if along <= 0.0 {
                    return None;
                }
                // A displacement d moves a point on the screen by at most d (1 + tan) / depth of the distance to the screen.
                let square = from.iter().map(|f| f * f).sum::<f64>();
                let aside = (square - along * along).max(0.0).sqrt() / along;
                most = most.max(up * (1.0 + aside) / along);
            }
        }
        Some(most * f64::from(self.options.size[1]) / VIEW)
    }

    /// Facets for the cells whose surfaces the base format refuses, and nothing for those that lie behind the eye; how many of each.
    fn replace_refused(&self, cells: &mut [Cell]) -> Result<(usize, usize), ImportError> {
        let facets_before = count(cells, Form::Facets);
        let mut open: Vec<usize> = (0..cells.len()).collect();
        while !open.is_empty() {
            let trial = open.iter().map(|&index| &cells[index]);
            let mut owners = vec![];
            let mut scene = self.empty_scene();
            for (place, cell) in trial.enumerate() {
                let objects = self.objects(cell, cells)?;
                owners.extend(objects.iter().map(|_| open[place]));
                scene.objects.extend(objects);
            }
            if scene.objects.is_empty() {
                break;
            }
            let framed = scene.frame(scene.image.width, scene.image.height);
            let framed = framed
                .map_err(|e| unusable(self.file, e.to_string(), "see docs/scene-format.md"))?;
            let mut again = vec![];
            for (object, problem) in refused(&framed, Format::BASE) {
                let cell = owners[object];
                if again.last() == Some(&cell) {
                    continue;
                }
                let form = match (&problem, cells[cell].form) {
                    (PrepareError::BehindViewer { .. }, _) | (_, Form::Facets) => Form::LeftOut,
                    _ => Form::Facets,
                };
                again.push(cell);
                cells[cell].form = form;
            }
            open = again;
            open.retain(|&cell| cells[cell].form == Form::Facets);
        }
        let by_facets = count(cells, Form::Facets).saturating_sub(facets_before);
        Ok((by_facets, count(cells, Form::LeftOut)))
    }

    /// Scene coordinates (x, z) of a node.
    fn place(&self, node: [usize; 2]) -> [BigRational; 2] {
        std::array::from_fn(|k| &self.first[k] + &self.step[k] * integer(node[k] as i64))
    }

    /// The objects of a cell, one of `cells`.
    fn objects(&self, cell: &Cell, cells: &[Cell]) -> Result<Vec<Object>, ImportError> {
        let shapes: Vec<(Shape, Vec<_>)> = match cell.form {
            Form::LeftOut => return Ok(vec![]),
            Form::Facets => {
                let heights = cell
                    .corners
                    .each_ref()
                    .map(|row| row.each_ref().map(to_f64));
                let mesh = facets(&heights, is_plane(&cell.corners));
                vec![(Shape::Mesh(mesh), vec![])]
            }
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
            let part = if single {
                String::new()
            } else {
                format!("-{index}")
            };
            Object {
                name: format!("cell-{}-{}{part}", cell.column, cell.row),
                shape,
                processor: None,
                mode: Surface::Patch,
                material: format!("altitude-{}", self.band(cell)),
                place: vec![
                    Step::Scale(Scale::PerAxis([sx, 1.0, sz])),
                    Step::Translate([x, 0.0, z]),
                ],
                cuts,
                group: None,
                visible: true,
                casts_shadow: true,
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
            "the heights, the distance of nodes and the eye have too many digits together for exact surfaces".into(),
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

    fn scene(&self, cells: &[Cell]) -> Result<SceneFile, ImportError> {
        let mut scene = self.empty_scene();
        for cell in cells {
            scene.objects.extend(self.objects(cell, cells)?);
        }
        if scene.objects.is_empty() {
            return Err(unusable(
                self.file,
                "every cell lies behind the eye".into(),
                "an eye and a target that see the terrain are needed",
            ));
        }
        Ok(scene)
    }

    fn empty_scene(&self) -> SceneFile {
        let material = |(index, colour): (usize, &[f64; 3])| Material {
            name: format!("altitude-{index}"),
            colour: *colour,
            ambient: 0.25,
            diffuse: 0.75,
            specular: 0.0,
            exponent: 1,
        };
        let [width, height] = self.options.size;
        let camera = Camera::Perspective {
            eye: self.eye,
            target: self.target,
            up: [0.0, 1.0, 0.0],
            viewer_distance: self.viewer_distance,
            view_height: short(VIEW * self.viewer_distance),
            node: Node::default(),
        };
        SceneFile {
            background: [0.62, 0.74, 0.88],
            ambient: [1.0; 3],
            image: ImageSize { width, height },
            lights: vec![Light::Directional {
                from: [-3.0, 3.0, 1.0],
                colour: [1.0; 3],
                intensity: 1.0,
                shadows: false,
                node: Node::default(),
            }],
            materials: BANDS.iter().enumerate().map(material).collect(),
            ..SceneFile::new(&self.options.title, camera)
        }
    }
}

/// The number rounded to three digits.
fn short(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::terrain::cell::Edge;
    use crate::terrain::read;
    use imogene_models::scene::Quadric;

    const HILLS: &str = "step 60 90\n10 20 30 20\n15 40.5 60 20\n10 30 - 10\n";

    fn imported(options: &TerrainOptions) -> Result<Imported, ImportError> {
        scene_of(&read(HILLS.as_bytes(), "hills").unwrap(), "hills", options)
    }

    #[test]
    fn a_scene_is_one_that_can_be_read_back() {
        for cells in [Cells::Bilinear, Cells::Auto, Cells::Ruled] {
            let options = TerrainOptions {
                cells,
                ..TerrainOptions::default()
            };
            let made = imported(&options).unwrap();
            let text = made.scene.to_toml().unwrap();
            assert_eq!(SceneFile::parse(&text, "again").unwrap(), made.scene);
            assert_eq!(made.report["cells"], 4);
            assert_eq!(made.report["without_data"], 2);
            assert!(made.notes[0].contains("2 cells without a height"));
        }
    }

    /// Neighbours pass through the same edge and reach a little beyond it; where there is no neighbour a cell ends at its edge.
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
        let with = |change: fn(&mut TerrainOptions)| {
            let mut options = TerrainOptions::default();
            change(&mut options);
            imported(&options).unwrap_err().to_string()
        };
        let out = with(|o| {
            o.region = Some(Region {
                first: [2, 0],
                nodes: [3, 2],
            })
        });
        assert!(out.contains("within the grid of 4 x 3 nodes"), "{out}");
        let wide = with(|o| o.every = 3);
        assert!(wide.contains("every 3 of them"), "{wide}");
        let back = with(|o| {
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
