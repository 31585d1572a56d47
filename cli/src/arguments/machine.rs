//! Arguments of `machine`.

use super::cosim::ENGINES;
use super::frames::FrameRange;
use super::parse::{Choices, choice};
use super::waves::Waves;
use clap::Args;
use imogene_plan::zone::refine::Refinement;
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
