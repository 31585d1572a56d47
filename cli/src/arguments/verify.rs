//! Arguments of the commands that compare the hardware with the golden model, or prove it.

use super::given::Given;
use super::parse::{Choices, choice, depth_word};
use super::scene::{SceneWords, Size, View, size};
use super::unit::{Parameters, Shape};
use clap::Args;
use imogene_verif::engine::Engine;
use imogene_verif::engine::simulator::Simulator;
use imogene_verif::scene::Fault;
use imogene_verif::waveform::file::save_path;
use imogene_verif::waveform::{Place, WaveformRequest, WindowStart};
use std::path::PathBuf;

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

/// Which waveforms of a run are written.
#[derive(Clone, Debug, Args)]
pub struct Waves {
    /// Waveforms of hardware and golden model, with a GTKWave save file beside them: FST if the name ends in .fst, and
    /// VCD otherwise.
    #[arg(long, value_name = "FILE.vcd|FILE.fst")]
    pub vcd: Option<PathBuf>,
    /// Where they begin in the picture: X,Y of a pixel, line:Y, frame:N (a machine's frames count from 1; without one,
    /// the first that shows a scene), or frame:N,X,Y or frame:N,line:Y. If not given: of a scene the middle line of the
    /// traced object, of a machine with a screen the first clock.
    #[arg(long, value_name = "PLACE", requires = "vcd")]
    pub vcd_from: Option<Place>,
    /// Clocks of the waveforms; those around the first mismatch come in addition.
    #[arg(long, default_value_t = 2_000, value_name = "N", requires = "vcd")]
    pub vcd_clocks: u64,
    /// Keep waveforms around the first mismatch alone.
    #[arg(long, requires = "vcd", conflicts_with_all = ["vcd_from", "vcd_clocks"])]
    pub vcd_at_mismatch: bool,
    /// Nets inside the machine as well, by their paths in the Verilog, such as processors_0.quadric.near_sum; the path
    /// of an instance is all nets in it and below, and all is every net. The built-in engine shows them.
    #[arg(long, value_name = "PATH,..", requires = "vcd", value_delimiter = ',')]
    pub vcd_nets: Vec<String>,
}

impl Waves {
    /// What a run is asked for.
    pub fn request(&self) -> Option<WaveformRequest> {
        self.vcd.as_ref().map(|_| WaveformRequest {
            from: match (self.vcd_from, self.vcd_at_mismatch) {
                (_, true) => WindowStart::Mismatch,
                (Some(place), _) => WindowStart::At(place),
                (None, _) => WindowStart::Usual,
            },
            clocks: self.vcd_clocks,
            nets: self.vcd_nets.clone(),
        })
    }

    /// The files that may be written.
    pub fn files(&self) -> Vec<PathBuf> {
        let files = |path: &PathBuf| [path.clone(), save_path(path)];
        self.vcd.iter().flat_map(files).collect()
    }
}

/// Arguments of `prove`.
#[derive(Debug, Args)]
pub struct Prove {
    /// A proof, the beginning of the names of several such as `pe1`, or `all`.
    #[arg(default_value = "all")]
    pub name: String,
    /// The proofs at every width and every count as well.
    #[arg(long)]
    pub full: bool,
    /// Run the broken designs of the proofs instead; each must be refuted.
    #[arg(long)]
    pub mutants: bool,
}

/// Arguments of `mutate`.
#[derive(Debug, Args)]
pub struct Mutate {
    /// Units, as listed by `imogene units`, with commas between, or `all`; with --machine the scenes that it shows one
    /// after the other.
    #[arg(value_delimiter = ',', required = true)]
    pub unit: Vec<String>,
    /// Mutants of what this machine is made of beside its units.
    #[arg(long, value_name = "FILE.toml", conflicts_with_all = ["format", "parameters", "netlist", "clocks", "out", "word_bits"])]
    pub machine: Option<PathBuf>,
    /// Depth words in bits, 8 to 32, with commas between.
    #[arg(long, default_value = "16", value_name = "W,...", value_delimiter = ',', value_parser = depth_word)]
    pub format: Vec<u32>,
    /// Parameters, of units that have them.
    #[command(flatten)]
    pub others: Parameters,
    /// Mutants of the emitted Verilog by Yosys, of each unit at most this many, in the place of every mutant of the
    /// circuit; `all` are ten units.
    #[arg(long, value_name = "N", conflicts_with_all = ["effort", "word_bits"], value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub netlist: Option<u32>,
    /// Stimuli that a mutant is run on at most; a proof is tried after 150. [default: 20000, with --netlist 150, runs
    /// of a machine 8]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    pub stimuli: Option<u64>,
    /// Clocks of each of them, about; the raster of a screen runs over two frames at least.
    #[arg(long, default_value_t = 150, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000_000))]
    pub clocks: u32,
    /// Conflicts after which the solver gives a mutant up, which survives then.
    #[arg(long, default_value_t = 10_000, value_name = "N", value_parser = clap::value_parser!(u64).range(10..=10_000_000))]
    pub effort: u64,
    /// All words of so many bits are run in the end, for what can differ for these alone, of a unit with one input.
    #[arg(long, default_value_t = 24, value_name = "BITS", value_parser = clap::value_parser!(u32).range(24..=32))]
    pub word_bits: u32,
    /// Write the table of scores to this file.
    #[arg(long, value_name = "FILE.md")]
    pub out: Option<PathBuf>,
}
