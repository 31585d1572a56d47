//! Arguments of the commands that simulate.

use super::given::Given;
use super::parse::{Choices, choice};
use super::scene::{SceneWords, Size, View, size};
use super::unit::Shape;
use super::waves::Waves;
use clap::Args;
use imogene_verif::engine::Engine;
use imogene_verif::engine::simulator::Simulator;
use imogene_verif::scene::Fault;

/// What runs the hardware.
#[rustfmt::skip]
pub(super) const ENGINES: Choices<Engine> = &[
    (Engine::BuiltIn, "built-in", "The circuits, compiled in process; needs no outside tool"),
    (Engine::BuiltIn, "rust-hdl", ""),
    (Engine::Verilog(Simulator::Icarus), "icarus", "The emitted Verilog in Icarus Verilog"),
    (Engine::Verilog(Simulator::Verilator), "verilator", "The emitted Verilog in Verilator"),
];

/// Arguments of `cosim`.
#[derive(Debug, Args)]
pub struct Cosim {
    /// It stands first: the parser takes away what the fields behind it have read.
    #[command(flatten)]
    pub given: Given,
    /// Scene file, a unit as listed by `imogene units`, or a named extreme: extremes/NAME, or extremes for all.
    pub subject: String,
    /// What runs the hardware.
    #[arg(long, value_parser = choice(ENGINES), default_value = "built-in")]
    pub engine: Engine,
    /// Run what synthesis makes of a unit instead of the emitted Verilog: ice40-hx8k, ice40-up5k, ecp5-45k, ecp5-85k or
    /// gowin.
    #[arg(long, value_name = "T")]
    pub netlist: Option<String>,
    /// Waveforms.
    #[command(flatten)]
    pub waves: Waves,
    /// Seed of the random stimulus of a unit.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Clocks of random stimulus for a unit.
    #[arg(long, default_value_t = 120_000)]
    pub clocks: usize,
    /// Parameters of a unit; a scene fixes planes and objects itself.
    #[command(flatten)]
    pub shape: Shape,
    /// Picture size of a scene; the scene's own if not given.
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<Size>,
    /// Words of the machine of a scene.
    #[command(flatten)]
    pub words: SceneWords,
    /// How a scene is looked at.
    #[command(flatten)]
    pub view: View,
    /// Object of a scene whose processor is traced.
    #[arg(long, default_value_t = 0, value_name = "OBJECT")]
    pub trace_object: usize,
    /// Flip one bit of one coefficient word in the hardware, to see it found.
    #[arg(long, value_name = "OBJECT:ADDRESS:BIT")]
    pub inject_fault: Option<Fault>,
}

/// Arguments of `speed`.
#[derive(Debug, Args)]
pub struct Speed {
    /// It stands first: the parser takes away what the fields behind it have read.
    #[command(flatten)]
    pub given: Given,
    /// Unit, as listed by `imogene units`, or a scene file of quadrics: the beam machine that draws it, loaded first.
    #[arg(default_value = "quadric_processor")]
    pub unit: String,
    /// Parameters.
    #[command(flatten)]
    pub shape: Shape,
    /// Drive a unit with the random stimulus of `cosim` instead of lines of a frame with constant words.
    #[arg(long)]
    pub random: bool,
    /// Seconds for each engine and each kind of work.
    #[arg(long, default_value_t = 3, value_name = "S", value_parser = clap::value_parser!(u32).range(1..=600))]
    pub seconds: u32,
}
