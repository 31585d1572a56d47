//! Arguments of `terrain`.

use clap::Args;
use std::path::PathBuf;

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
