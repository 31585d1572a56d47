//! Arguments of `detail`.

use super::Scene;
use clap::Args;
use std::path::PathBuf;

/// Arguments of `detail`.
#[derive(Debug, Args)]
pub struct Detail {
    /// Scene.
    #[command(flatten)]
    pub scene: Scene,
    /// Side of the square zones in pixels, 8 or more.
    #[arg(long, default_value_t = 64, value_name = "N", value_parser = clap::value_parser!(u32).range(8..=4095))]
    pub zone: u32,
    /// Leave out objects at fewer than P pixels, and planes of an object as long as at most P of its pixels change;
    /// with 0 no pixel changes.
    #[arg(long, default_value_t = 0, value_name = "P", value_parser = clap::value_parser!(u64).range(0..=1_000_000))]
    pub pixels: u64,
    /// Folder of the pictures: the scene with what is left of it, and maps of its zones.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}
