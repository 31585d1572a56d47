//! `imogene import` of terrain.

use crate::arguments::Import;
use crate::failure::Failure;
use imogene_import::Imported;
use imogene_import::terrain::{TerrainOptions, import as import_terrain};

/// The scene of a file.
pub fn import(bytes: &[u8], options: &Import) -> Result<Imported, Failure> {
    let asked = &options.terrain;
    let factor = asked.height_factor;
    if !(factor != 0.0 && factor.abs() <= 1e6) {
        return Err(Failure::Input(format!(
            "a height factor of {factor}; any number but 0 up to 1000000 is accepted"
        )));
    }
    let file = options.file.display().to_string();
    let title = options.file.file_stem().map(|name| name.to_string_lossy());
    let terrain = TerrainOptions {
        cells: asked.cells,
        height_factor: factor,
        region: asked.region,
        every: asked.every as usize,
        eye: asked.eye_at,
        target: asked.look_at,
        title: title.map_or("Terrain".to_owned(), |name| name.into_owned()),
    };
    import_terrain(bytes, &file, &terrain).map_err(Failure::from)
}
