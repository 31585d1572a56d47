//! Arguments of the commands that show scenes on pins.

use super::fit::tables;
use super::parse::{Choices, FrameRange, choice};
use super::verify::{ENGINES, Waves};
use clap::Args;
use imogene_plan::zone::refine::Refinement;
use imogene_prepare::lit_sphere::SphereForm;
use imogene_verif::engine::Engine;
use std::path::PathBuf;

/// Arguments of `machine`.
#[derive(Debug, Args)]
pub struct Machine {
    /// Scene files; several are shown one after the other.
    #[arg(required = true)]
    pub scenes: Vec<PathBuf>,
    /// Machine description (TOML), as those in machines/.
    #[arg(long, value_name = "FILE.toml")]
    pub machine: PathBuf,
    /// What runs the hardware.
    #[arg(long, value_parser = choice(ENGINES), default_value = "built-in")]
    pub engine: Engine,
    /// Folder of the Verilog, the picture from the pins, the golden picture and summary.json.
    #[arg(long, value_name = "DIR", default_value = "imogene-machine")]
    pub out: PathBuf,
    /// Look through the camera of this name instead of the active one.
    #[arg(long, value_name = "NAME")]
    pub camera: Option<String>,
    /// Show the frames of the scene's animation one after the other, all or those from FIRST to LAST, counted from 1,
    /// instead of the scene as it is written.
    #[arg(long, value_name = "FIRST..LAST", num_args = 0..=1, default_missing_value = "")]
    pub animation: Option<FrameRange>,
    /// Whole frames to see of the last scene, at least 1.
    #[arg(long, default_value_t = 1, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000))]
    pub frames: u32,
    /// Clocks that the host lets pass before each scene.
    #[arg(long, default_value_t = 0, value_name = "CLOCKS", value_parser = clap::value_parser!(u64).range(0..=1_000_000_000))]
    pub late: u64,
    /// The host stalls at random, one clock in three, from this seed.
    #[arg(long, value_name = "SEED")]
    pub stalls: Option<u64>,
    /// Picture of the size of the screen whose pixels that are not black the host puts over every frame, in white; the
    /// machine has `overlay = true`.
    #[arg(long, value_name = "MASK.png")]
    pub overlay: Option<PathBuf>,
    /// Waveforms.
    #[command(flatten)]
    pub waves: Waves,
    /// How the host of a zone machine decides what goes to a zone; the picture is the same.
    #[arg(long, value_parser = choice(REFINEMENTS), default_value = "box")]
    pub refine: Refinement,
    /// Write the Verilog, the clocks and the files of a bench of your own (docs/machines.md), and run nothing.
    #[arg(long, conflicts_with = "vcd")]
    pub emit_only: bool,
    /// Count the clocks of a frame of a zone machine for zones of 8 x 8 to 128 x 128 pixels and 1 to 16 object
    /// processors as well, with a plot.
    #[arg(long)]
    pub growth: bool,
}

#[rustfmt::skip]
const REFINEMENTS: Choices<Refinement> = &[
    (Refinement::Box, "box", "By screen boxes"),
    (Refinement::Bounds, "bounds", "By bounds of what the words say on the zone"),
    (Refinement::Pixels, "pixels", "By drawing the zone in software: the least that can be sent"),
];

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
