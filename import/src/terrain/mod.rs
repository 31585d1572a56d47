//! Terrain: a grid of heights as quadric cells (thesis of Coquillart, sections 2.2 to 2.5), and heights made at random
//! (section 4.2).

mod cell;
mod exact;
mod form;
mod grid;
mod map;
mod objects;
mod options;
pub mod random_field;
mod read;
mod ruled;
mod scene;
mod store;
mod text;
mod write;

pub use crate::kind::is_grid_keyword;
pub use cell::Cells;
pub use grid::{HeightGrid, MAX_NODES};
pub use options::{Region, TerrainOptions};
pub use read::read;
pub use scene::{MAX_CELLS, scene_of};
pub use write::heights_text;

use crate::{Imported, Result};

/// The scene of a file of heights; `file` is the name that messages give it.
pub fn import(bytes: &[u8], file: &str, options: &TerrainOptions) -> Result<Imported> {
    let grid = read(bytes, file)?;
    scene_of(&grid, file, options)
}
