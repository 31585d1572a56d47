//! Options of `import` for terrain.

use clap::Args;

/// Options of terrain.
#[derive(Clone, Debug, Args)]
pub struct TerrainOptions {}
