//! Terrain: a grid of heights as quadric cells (thesis of Coquillart, sections 2.2 to 2.5), and heights made at random
//! (section 4.2).

mod cell;
pub mod exact;
mod form;
mod grid;
mod map;
mod options;
pub mod random_field;
mod read;
pub mod ruled;
mod scene;

pub use cell::{Cells, Piece};
pub use grid::{Corners, twist};
pub use options::{Region, TerrainOptions};
pub use random_field::heights_text;

use crate::error::ImportError;
use crate::kit::Imported;

/// The scene of a file of heights; `file` is the name that messages give it.
pub fn import(bytes: &[u8], file: &str, options: &TerrainOptions) -> Result<Imported, ImportError> {
    let made = read::read(bytes).and_then(|grid| scene::scene_of(&grid, options));
    made.map_err(ImportError::of(file))
}
