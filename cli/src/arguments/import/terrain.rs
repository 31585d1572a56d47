//! Options of `import` for terrain.

use clap::{Args, ValueEnum};
use imogene_import::terrain::Region;

/// Options of terrain.
#[derive(Clone, Debug, Args)]
pub struct TerrainOptions {
    /// What a cell of the grid is drawn as.
    #[arg(long, value_enum, default_value = "bilinear", value_name = "FORM")]
    pub cells: CellForm,
    /// Factor of the heights.
    #[arg(
        long,
        default_value_t = 1.0,
        value_name = "FACTOR",
        allow_hyphen_values = true
    )]
    pub height_factor: f64,
    /// The part of the grid from node (C, R) that is M nodes wide and N nodes deep.
    #[arg(long, value_name = "C,R,M,N", value_parser = region)]
    pub region: Option<Region>,
    /// Take every N-th node.
    #[arg(long, default_value_t = 1, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000))]
    pub every: u32,
    /// The eye: x east and z south of the middle of the terrain, y its height.
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    pub eye_at: Option<[f64; 3]>,
    /// The point that the eye looks at.
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    pub look_at: Option<[f64; 3]>,
}

/// What a cell is drawn as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum CellForm {
    /// Bilinear patches, whatever the eye.
    Bilinear,
    /// Surfaces ruled from edge to edge as the eye sees them: one quotient a pixel and no root.
    Ruled,
    /// Facets where the bilinear patch is flat to half a pixel, else bilinear patches.
    Auto,
}

fn point(text: &str) -> Result<[f64; 3], String> {
    let numbers: Option<Vec<f64>> = text
        .split(',')
        .map(|part| part.trim().parse::<f64>().ok())
        .map(|value| value.filter(|v| v.abs() <= 1e9))
        .collect();
    let point = numbers.and_then(|numbers| numbers.try_into().ok());
    point.ok_or_else(|| "three numbers such as 0,120,300 are expected".to_owned())
}

fn region(text: &str) -> Result<Region, String> {
    let numbers: Option<Vec<usize>> = text
        .split(',')
        .map(|part| part.trim().parse().ok())
        .collect();
    match numbers.as_deref() {
        Some(&[c, r, m, n]) => Ok(Region {
            first: [c, r],
            nodes: [m, n],
        }),
        _ => Err(
            "first column, first row, columns and rows such as 0,0,33,33 are expected".to_owned(),
        ),
    }
}
