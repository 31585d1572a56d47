//! Options of `import` for terrain, and the arguments of `terrain`.

use crate::arguments::parse::{Choices, choice};
use clap::Args;
use imogene_import::terrain::{Cells, Region};
use std::path::PathBuf;

/// Options of terrain.
#[derive(Clone, Debug, Args)]
pub struct TerrainOptions {
    /// What a cell of the grid is drawn as.
    #[arg(long, value_parser = choice(CELLS), default_value = "bilinear", value_name = "FORM")]
    pub cells: Cells,
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

/// Arguments of `terrain`.
#[derive(Debug, Args)]
pub struct Terrain {
    /// File of heights to write.
    #[arg(short, long, value_name = "FILE.heights")]
    pub output: PathBuf,
    /// Levels of recursion: 2^N + 1 nodes a side, N from 1 to 10.
    #[arg(long, default_value_t = 6, value_name = "N")]
    pub levels: u32,
    /// The exponent h from 0 (rough) to 1 (smooth): each level is displaced by 2^-h of the one before.
    #[arg(long, default_value_t = 0.8, value_name = "H")]
    pub roughness: f64,
    /// Deviation of the corners of the grid, in units of height.
    #[arg(long, default_value_t = 100.0, value_name = "UNITS")]
    pub relief: f64,
    /// Distance of two nodes.
    #[arg(long, default_value_t = 10.0, value_name = "UNITS")]
    pub node_distance: f64,
    /// Seed of the random numbers.
    #[arg(long, default_value_t = 1, value_name = "SEED")]
    pub seed: u64,
}

#[rustfmt::skip]
const CELLS: Choices<Cells> = &[
    (Cells::Bilinear, "bilinear", "Bilinear patches, whatever the eye"),
    (Cells::Ruled, "ruled", "Surfaces ruled from edge to edge as the eye sees them: one quotient a pixel and no root"),
    (Cells::Auto, "auto", "Facets where the bilinear patch is flat to half a pixel, else bilinear patches"),
];

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
