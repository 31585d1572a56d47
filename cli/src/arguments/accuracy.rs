//! Arguments of the commands that measure accuracy: of a picture against other ones, and of the words behind it.

use super::parse::{self, depth_word};
use super::scene::{Scene, Size, View, size};
use clap::Args;
use std::path::PathBuf;

/// Arguments of `raytrace`.
#[derive(Debug, Args)]
pub struct Raytrace {
    /// Scene files; of several, those that the preparation refuses are listed as such.
    #[arg(required_unless_present = "random", value_name = "SCENE")]
    pub scenes: Vec<PathBuf>,
    /// Look at N ordinary scenes made at random instead: how many are refused, fail their check, or differ.
    #[arg(long, value_name = "N", conflicts_with_all = ["scenes", "size", "output", "table"])]
    pub random: Option<u64>,
    /// Seed of these scenes.
    #[arg(long, default_value_t = 1, value_name = "SEED", requires = "random")]
    pub seed: u64,
    /// Picture size in pixels; each scene's own if not given.
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<Size>,
    /// Depth word in bits, 8 to 32.
    #[arg(long, default_value_t = 24, value_name = "W", value_parser = depth_word)]
    pub format: u32,
    /// How the scenes are looked at.
    #[command(flatten)]
    pub view: View,
    /// Picture (PNG) of one scene's comparison: the band blue, allowed differences orange, others
    /// red, violet (depths) or yellow (colours).
    #[arg(short, long, value_name = "FILE.png")]
    pub output: Option<PathBuf>,
    /// Folder for such a picture of every scene; of random scenes, for the files of those in which something is found.
    #[arg(long, value_name = "DIR", conflicts_with = "output")]
    pub out: Option<PathBuf>,
    /// Write the table of all scenes (Markdown) to this file.
    #[arg(long, value_name = "FILE.md")]
    pub table: Option<PathBuf>,
}

/// Arguments of `cracks`.
#[derive(Debug, Args)]
pub struct Cracks {
    /// The scene.
    #[command(flatten)]
    pub scene: Scene,
    /// Least distance, in scene units along the view, by which both sides of a crack are nearer [default: two pixels].
    #[arg(long, value_name = "D", value_parser = positive)]
    pub min_distance: Option<f64>,
    /// Greatest width of a crack in pixels, 1 to 8; 1 is the rule as printed.
    #[arg(long, default_value_t = 1, value_name = "PIXELS", value_parser = clap::value_parser!(u8).range(1..=8))]
    pub width: u8,
    /// Picture (PNG) with the flagged pixels in red.
    #[arg(short, long, value_name = "FILE.png")]
    pub output: Option<PathBuf>,
    /// Make about N cracks of each sort instead and show how many are found, from the minimum distance down and up in
    /// powers of two.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub inject: Option<u32>,
    /// Plot (SVG) of recall and precision over the minimum distance.
    #[arg(long, value_name = "FILE.svg", requires = "inject")]
    pub plot: Option<PathBuf>,
    /// Where those are made.
    #[arg(long, default_value_t = 1, value_name = "SEED", requires = "inject")]
    pub seed: u64,
}

/// Arguments of `repair`.
#[derive(Debug, Args)]
pub struct Repair {
    /// The scene, and the words of the first pass.
    #[command(flatten)]
    pub scene: Scene,
    /// Repaired picture (PNG) to write, shaded.
    #[arg(short, long, value_name = "FILE.png")]
    pub output: Option<PathBuf>,
    /// Picture (PNG) of the pixels that were solved exactly, in orange.
    #[arg(long, value_name = "FILE.png")]
    pub map: Option<PathBuf>,
    /// Do not draw the whole exact picture to compare with.
    #[arg(long)]
    pub unchecked: bool,
}

fn positive(text: &str) -> Result<f64, String> {
    let expected = "expected a distance above 0 in scene units, such as 0.01";
    parse::value(text, |v: &f64| v.is_finite() && *v > 0.0, expected)
}

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
