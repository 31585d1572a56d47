//! Terrain as quadric cells (thesis of Coquillart, sections 2.2 to 2.5), and random heights (section 4.2).

mod cell;
pub mod exact;
mod form;
mod grid;
mod map;
pub mod random_field;
mod read;
pub mod ruled;
mod scene;

pub use cell::{Cells, Piece};
pub use grid::{Corners, twist};
pub use random_field::heights_text;

use crate::error::ImportError;
use crate::kit::Imported;

/// A part of a grid, in nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    /// First column and row, from 0.
    pub first: [usize; 2],
    /// Columns and rows.
    pub nodes: [usize; 2],
}

/// Options of terrain.
#[derive(Clone, Debug)]
pub struct TerrainOptions {
    /// What a cell is drawn as.
    pub cells: Cells,
    /// Factor of the heights, not zero.
    pub height_factor: f64,
    /// The part of the grid; all of it if none is given.
    pub region: Option<Region>,
    /// Every how many-th node is taken, from 1.
    pub every: usize,
    /// The eye, in scene units: x east and z south of the middle, y the height. One that sees all if none is given.
    pub eye: Option<[f64; 3]>,
    /// What the eye looks at; the middle of the terrain if none is given.
    pub target: Option<[f64; 3]>,
    /// Title of the scene.
    pub title: String,
}

impl Default for TerrainOptions {
    fn default() -> Self {
        TerrainOptions {
            cells: Cells::Bilinear,
            height_factor: 1.0,
            region: None,
            every: 1,
            eye: None,
            target: None,
            title: "Terrain".to_owned(),
        }
    }
}

/// The scene of a file of heights; `file` is the name that messages give it.
pub fn import(bytes: &[u8], file: &str, options: &TerrainOptions) -> Result<Imported, ImportError> {
    let made = read::read(bytes).and_then(|grid| scene::scene_of(&grid, options));
    made.map_err(ImportError::of(file))
}
