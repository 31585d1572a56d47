//! Arguments of `board`.

use super::fit::tables;
use super::frames::FrameRange;
use clap::Args;
use imogene_prepare::lit_sphere::SphereForm;
use std::path::PathBuf;

/// Arguments of `board`.
#[derive(Debug, Args)]
pub struct Board {
    /// Name of the board, as those in boards/.
    pub board: String,
    /// Scene file (TOML).
    pub scene: PathBuf,
    /// Folder of the Verilog, the constraints, the bitstream, the pictures and board.json.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Machine description (TOML) of a beam machine with pins; fitted to the scene if not given.
    #[arg(long, value_name = "FILE.toml")]
    pub machine: Option<PathBuf>,
    /// Video mode of a fitted machine; the first of the board if not given.
    #[arg(long, value_name = "MODE", conflicts_with = "machine")]
    pub mode: Option<String>,
    /// Frames of the scene's animation, counted from 1; all of an animated scene if not given.
    #[arg(long, value_name = "FIRST..LAST")]
    pub animation: Option<FrameRange>,
    /// Frames of the screen to simulate; those of all images, or three of a tile, if not given.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=9_999))]
    pub frames: Option<u16>,
    /// Leave the shading processor out of a fitted machine: every object has the plain colour of its material.
    #[arg(long, conflicts_with = "machine")]
    pub flat: bool,
    /// Shade a fitted machine by tables of the direction of the normal, of so many entries along each side, in the
    /// place of the shading processor: fewer cells, with all lights and the viewer infinitely far. With :nearest the
    /// nearest entry is the colour, with three multipliers.
    #[arg(
        long,
        value_name = "SIDE[:nearest]",
        num_args = 0..=1,
        default_missing_value = "64",
        require_equals = true,
        value_parser = tables,
        conflicts_with_all = ["machine", "flat"]
    )]
    pub lit_sphere: Option<SphereForm>,
    /// Write the sources alone, and run no outside tool.
    #[arg(long)]
    pub sources_only: bool,
    /// Write every bit of the DVI channels to pins.bin and the golden picture to golden.rgb as well, for
    /// scripts/dvi_witness.py.
    #[arg(long, conflicts_with_all = ["sources_only", "no_simulation"])]
    pub samples: bool,
    /// Place and route a tile in cells of 180 nm, and simulate what comes of it; minutes.
    #[arg(long, conflicts_with_all = ["sources_only", "no_bitstream"])]
    pub layout: bool,
    /// Leave out synthesis, place and route and the bitstream, or the cells of a tile.
    #[arg(long, conflicts_with = "sources_only")]
    pub no_bitstream: bool,
    /// Leave out the simulation of the pins.
    #[arg(long, conflicts_with = "sources_only")]
    pub no_simulation: bool,
}
