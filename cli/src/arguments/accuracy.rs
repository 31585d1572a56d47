//! Arguments of the commands that measure accuracy.

use super::parse::depth_word;
use super::scene::{Size, size};
use clap::Args;
use std::path::PathBuf;

/// Arguments of `shading`.
#[derive(Debug, Args)]
pub struct Shading {
    /// Scene files (TOML), on whose pictures lit-sphere shading is compared; without any, the shading processor is, on
    /// random cases.
    #[arg(conflicts_with_all = ["cases", "seed", "sweep"])]
    pub scenes: Vec<PathBuf>,
    /// Of lit-sphere shading, take the nearest entry.
    #[arg(long, requires = "scenes")]
    pub nearest: bool,
    /// Random cases for each set of widths.
    #[arg(long, default_value_t = 1_000_000, value_name = "N", value_parser = clap::value_parser!(u64).range(4096..))]
    pub cases: u64,
    /// Seed of the random cases.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Also with each width shorter by 1 to 4 bits.
    #[arg(long)]
    pub sweep: bool,
}

/// Arguments of `bounds`.
#[derive(Debug, Args)]
pub struct Bounds {
    /// Scene files (TOML); without any, the bounds are tried on random cases.
    pub scenes: Vec<PathBuf>,
    /// Random cases at each format.
    #[arg(
        long,
        default_value_t = 100_000,
        value_name = "N",
        value_parser = clap::value_parser!(u64).range(1..),
        conflicts_with = "scenes"
    )]
    pub cases: u64,
    /// Seed of the random cases.
    #[arg(long, default_value_t = 1, conflicts_with = "scenes")]
    pub seed: u64,
    /// Picture sizes in pixels.
    #[arg(
        long,
        value_name = "WxH",
        value_parser = size,
        value_delimiter = ',',
        default_value = "160x120,320x240,640x480,1024x768",
        requires = "scenes"
    )]
    pub sizes: Vec<Size>,
    /// Depth words in bits.
    #[arg(
        long,
        value_name = "W",
        value_parser = depth_word,
        value_delimiter = ',',
        default_value = "16,20,24",
        requires = "scenes"
    )]
    pub formats: Vec<u32>,
}

/// Arguments of `sweep`.
#[derive(Debug, Args)]
pub struct Sweep {
    /// Sweeps by name, listed in docs/sweeps.md; all of them if none is named.
    pub names: Vec<String>,
    /// Depth word in bits, 8 to 32; the sweep word-length tries them all.
    #[arg(long, default_value_t = 24, value_name = "W", value_parser = depth_word)]
    pub format: u32,
    /// Folder for NAME.svg of each sweep, sweeps.json and sweeps.md; nothing is written without it.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// Arguments of `evaluate`.
#[derive(Debug, Args)]
pub struct Evaluate {
    /// Folder for index.html, evaluation.json, evaluation.md and images/; nothing is written without it.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}
