//! Arguments of every command.

mod detail;
mod evaluate;
mod frames;
mod import;
mod machine;
mod oracle;
mod split;
mod terrain;

use clap::{Args, Parser, Subcommand, ValueEnum};
pub use detail::Detail;
pub use evaluate::Evaluate;
pub use frames::FrameRange;
use imogene_models::fit::budget::{Budget, CountLimit, DepthLimit};
use imogene_models::format::FittedWidths;
use imogene_models::machine::fitted::FittedSlot;
use imogene_models::slots::{self, SlotsError};
use imogene_models::trade::run::Shard;
use imogene_models::widths::{self, WidthsError};
use imogene_rtl::catalogue::Unit;
use imogene_verif::engine::design::Simulator;
use imogene_verif::scene::Fault;
use imogene_verif::unit::Parameters;
pub use import::{CellForm, Import, ImportKind};
pub use machine::{Machine, Refine};
pub use oracle::{Cracks, Repair, Trace};
pub use split::Split;
use std::path::PathBuf;
use std::str::FromStr;
pub use terrain::Terrain;

/// Hardware that draws quadrics, proven against a golden model.
///
/// Exit codes: 0 done and all checks hold, 1 a check failed, 2 bad input or usage.
#[derive(Debug, Parser)]
#[command(version, propagate_version = true)]
pub struct Arguments {
    /// Print one JSON document on standard output and nothing else there.
    #[arg(long, global = true)]
    pub json: bool,
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Draw the teapot with the hardware in simulation, check every clock, and write pictures, Verilog and waveforms.
    Demo(Demo),
    /// List every unit: parameters with legal ranges, latency, sources.
    Units,
    /// List the object processors: what each is made of, its latency, and what the sources count.
    Processors(Processors),
    /// Measure the family of square root networks: error, steps, depth of a test sphere, cost.
    Roots(Roots),
    /// Write the Verilog of one unit or of the whole machine.
    Emit(Emit),
    /// Print the contract of a unit: ports, widths as formulas, latency, ties, error.
    Contract(Contract),
    /// Write every unit as an IP core: Verilog, contract, self-checking bench, FuseSoC core file.
    Package(Package),
    /// Draw a scene with the exact reference, the golden model or the hardware in simulation.
    Render(Render),
    /// Show the integer coefficients of every object as the hardware is loaded with them.
    Prepare(Prepare),
    /// Compare hardware and golden model clock by clock, for a scene or a unit.
    Cosim(Cosim),
    /// Read a molecule, CAD faces or terrain and write them as a scene.
    Import(Import),
    /// Make a grid of heights at random, for `imogene import`.
    Terrain(Terrain),
    /// Show scenes on the pins of a whole machine: Verilog from a machine description, co-simulation of every clock, and the picture from the pins.
    Machine(Machine),
    /// Compare golden pictures with those of an independent ray tracer in interval and exact arithmetic.
    Trace(Trace),
    /// Search a golden picture for cracks, or make cracks and see how many are found.
    Cracks(Cracks),
    /// Draw in short words and solve exactly the pixels that they leave open.
    Repair(Repair),
    /// Measure how fast the engines run a unit: clocks per second alone, with the scoreboard, with waveforms.
    Speed(Speed),
    /// Show what a scene needs: ranges, widths, planes, degenerate objects, proven bounds.
    Check(Check),
    /// Show what of a scene its picture requires: objects, planes, bits, and the zones that each object and volume reaches.
    Detail(Detail),
    /// Draw round objects by facets, by paraboloids and as quadrics, and measure errors, hardware and clocks of each.
    Compare(Compare),
    /// Measure speed, area and accuracy of the machines that can draw a scene: figures, plots and a page.
    Trade(Trade),
    /// Find the smallest machine that draws a scene, or every frame of an animation, within a budget of errors; emit and co-simulate it.
    Fit(Fit),
    /// Try the error bounds on random cases, or show silhouette errors, depth errors and guard bits needed of scenes.
    Bounds(Bounds),
    /// Compare the shading processor with its formula on random and searched cases, and show what each bit of its widths is worth.
    Shading(Shading),
    /// Take one number of a scene to its extreme, step by step: proven bound, observed error and refusals, with plots.
    Sweep(Sweep),
    /// Count the cost tables of the sources again, beside what they print: operations, words, zones, parts, cells, rates.
    Evaluate(Evaluate),
    /// Synthesise a unit with the open tools: LUT, FF, DSP, BRAM, Fmax; or make the resource table, or check against it.
    Synth(Synth),
    /// Synthesise the Verilog of another project beside a unit, with the same scripts, harness and seeds.
    Peers(Peers),
    /// Prove properties of the emitted Verilog, or show that each is refuted on broken designs.
    Prove(Prove),
    /// Score the stimulus of a unit: how many small changes of its netlist it notices.
    Mutate(Mutate),
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
    /// Unit, as listed by `imogene units`, or `all` for those of the published table.
    pub unit: String,
    /// Depth word in bits: 16, 20, 24, 28 or 32.
    #[arg(long, default_value_t = 16, value_name = "W")]
    pub format: u32,
    /// Mutants of a unit at most, at least 1.
    #[arg(long, default_value_t = 1_000, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub mutants: u32,
    /// Write the table of scores to this file.
    #[arg(long, value_name = "FILE.md")]
    pub out: Option<PathBuf>,
}

/// Arguments of `processors`.
#[derive(Debug, Args)]
pub struct Processors {
    /// Write the list as a page (Markdown) to this file.
    #[arg(long, value_name = "FILE.md")]
    pub out: Option<PathBuf>,
}

/// Arguments of `roots`.
#[derive(Debug, Args)]
pub struct Roots {
    /// Depth word in bits, that is the root's: 16, 20, 24, 28 or 32.
    #[arg(long, default_value_t = 24, value_name = "W")]
    pub format: u32,
}

/// Arguments of `demo`.
#[derive(Debug, Args)]
pub struct Demo {
    /// Output folder.
    #[arg(long, default_value = "out/demo")]
    pub out: PathBuf,
}

/// Parameters of a unit or machine.
#[derive(Clone, Copy, Debug, Args)]
pub struct Shape {
    /// Depth word in bits: 16, 20, 24, 28 or 32.
    #[arg(long, default_value_t = 24, value_name = "W")]
    pub format: u32,
    /// Cut planes of an object, 0 to 12; faces of a polyhedron, 1 to 12 [default: 3; 4 of patches and volumes, 6 of polyhedra].
    #[arg(long, value_name = "N")]
    pub planes: Option<usize>,
    /// Rows of the root network per register stage, 1 to W.
    #[arg(long, default_value_t = 1, value_name = "R")]
    pub rows_per_stage: usize,
    /// Object slots of a machine, inputs of a decider or volumes of a shadow stage, 1 to 256; processors on a card of card_decider.
    #[arg(long, default_value_t = 4, value_name = "M")]
    pub objects: usize,
    /// Digits that square_root_rows and square_root_leading keep, 1 to W [default: W / 2].
    #[arg(long, value_name = "D")]
    pub digits: Option<usize>,
    /// Corrections of square_root_linear (default 2) and square_root_quadratic (default 1), 0 to 2.
    #[arg(long, value_name = "C")]
    pub corrections: Option<usize>,
    /// Sides of a facet, 3 or 4, of a non-planar facet 1 to 4 [default: 3].
    #[arg(long, value_name = "E")]
    pub sides: Option<usize>,
    /// Video mode of video_timing: 0 is 160 x 120 for simulation, 1 640 x 480, 2 1280 x 720, 3 1920 x 1080 [default: 0].
    #[arg(long, value_name = "MODE")]
    pub mode: Option<usize>,
    /// Cards of card_decider, 1 to 64, with as many processors each as --objects says [default: 2].
    #[arg(long, value_name = "K")]
    pub cards: Option<usize>,
    /// Layers of transparency_pipeline, 1 to 8 [default: 2].
    #[arg(long, value_name = "T")]
    pub layers: Option<usize>,
    /// Products of csg_decider, 1 to 16 [default: 2].
    #[arg(long, value_name = "G")]
    pub products: Option<usize>,
    /// Objects intersected in each product of csg_decider, 1 to 8 [default: 2].
    #[arg(long, value_name = "I")]
    pub intersected: Option<usize>,
    /// Objects taken away in each product of csg_decider, 0 to 8 [default: 2].
    #[arg(long, value_name = "J")]
    pub subtracted: Option<usize>,
    /// Lights of the shading processor, 1 to 4 [default: 1].
    #[arg(long, value_name = "L")]
    pub lights: Option<usize>,
}

impl Shape {
    /// The planes asked for, or the default of the unit of this name.
    pub fn planes_of(&self, unit: &str) -> usize {
        let default = Unit::from_name(unit).map_or(3, Unit::default_planes);
        self.planes.unwrap_or(default)
    }

    /// The same for a co-simulation of the unit of this name.
    pub fn parameters(&self, unit: &str) -> Parameters {
        Parameters {
            depth_word: self.format,
            planes: self.planes_of(unit),
            rows_per_stage: self.rows_per_stage,
            objects: self.objects,
            digits: self.digits,
            corrections: self.corrections,
            sides: self.sides,
            mode: self.mode,
            cards: self.cards,
            layers: self.layers,
            products: self.products,
            intersected: self.intersected,
            subtracted: self.subtracted,
            lights: self.lights,
        }
    }
}

/// Arguments of `emit`.
#[derive(Debug, Args)]
pub struct Emit {
    /// Unit, as listed by `imogene units`.
    pub unit: String,
    /// Parameters.
    #[command(flatten)]
    pub shape: Shape,
    /// Output folder.
    #[arg(long)]
    pub out: PathBuf,
    /// One file for each module, and UNIT.f that lists them, instead of the one file UNIT.v.
    #[arg(long)]
    pub split: bool,
    /// Put NAME before the names of all modules and files, so that several configurations of a unit fit in one design.
    #[arg(long, value_name = "NAME")]
    pub prefix: Option<String>,
    /// Widths of a machine that is fitted to a scene, instead of --format; with --slots, for the unit beam alone.
    #[arg(long, value_name = "LIST", requires = "slots", conflicts_with_all = ["format", "planes", "objects"])]
    pub widths: Option<Widths>,
    /// Slots of that machine: the planes of each, with a v for those with half B, such as 3,0,2v.
    #[arg(long, value_name = "LIST", requires = "widths")]
    pub slots: Option<Slots>,
}

/// Slots of a fitted machine.
#[derive(Clone, Debug)]
pub struct Slots(pub Vec<FittedSlot>);

impl FromStr for Slots {
    type Err = SlotsError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        slots::parse(text).map(Slots)
    }
}

/// Arguments of `contract`.
#[derive(Debug, Args)]
pub struct Contract {
    /// Unit, as listed by `imogene units`.
    pub unit: String,
    /// Parameters.
    #[command(flatten)]
    pub shape: Shape,
    /// File to write instead of printing.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// Arguments of `package`.
#[derive(Debug, Args)]
pub struct Package {
    /// Output folder.
    #[arg(long)]
    pub out: PathBuf,
    /// Clocks of random stimulus in the vectors of each bench; 0 leaves benches and the target sim out.
    #[arg(long, default_value_t = 500)]
    pub clocks: usize,
}

/// Which model draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Model {
    /// The exact reference in big integers.
    Exact,
    /// The golden integer model.
    Golden,
    /// The hardware in simulation.
    Rtl,
}

/// A scene, its size and the format it is prepared for.
#[derive(Clone, Debug, Args)]
pub struct Scene {
    /// Scene file (TOML).
    pub scene: PathBuf,
    /// Picture size in pixels; the scene's own if not given.
    #[arg(long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Depth word in bits: 16, 20, 24, 28 or 32.
    #[arg(long, default_value_t = 24, value_name = "W")]
    pub format: u32,
    /// Guard bits of f1 and f2 below their last bits, 0 to 16 each.
    #[arg(long, default_value = "0:0", value_name = "G1:G2")]
    pub guards: Guards,
    /// Every width of a machine that is fitted to a scene, instead of --format and --guards: depth=20,root=18,plane=30,normal=16,g1=2,g2=4,dropped=0; what
    /// is left out follows from the depth.
    #[arg(long, value_name = "LIST", conflicts_with_all = ["format", "guards"])]
    pub widths: Option<Widths>,
    /// Look through the camera of this name instead of the active one.
    #[arg(long, value_name = "NAME")]
    pub camera: Option<String>,
    /// One frame of the scene's animation, counted from 1, instead of the scene as it is written.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub frame: Option<u32>,
}

/// Widths of a fitted machine as written on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Widths(pub FittedWidths);

impl FromStr for Widths {
    type Err = WidthsError;

    fn from_str(text: &str) -> Result<Widths, WidthsError> {
        widths::parse(text).map(Widths)
    }
}

/// Arguments of `render`.
#[derive(Debug, Args)]
pub struct Render {
    /// Scene.
    #[command(flatten)]
    pub scene: Scene,
    /// Round the coefficients anew for each zone of so many columns and lines, 8 or more (model golden).
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(8..=4096))]
    pub zone: Option<u32>,
    /// Workers of a divided screen.
    #[command(flatten)]
    pub split: Split,
    /// Which model draws.
    #[arg(long, value_enum, default_value_t = Model::Golden)]
    pub model: Model,
    /// Picture file (PNG); with --frames the folder of the pictures.
    #[arg(short = 'o', long = "output", value_name = "FILE.png")]
    pub output: PathBuf,
    /// Draw the frames of the scene's animation, all or those from FIRST to LAST, counted from 1: frame-0001.png and so on, animation.png and frames.json in the
    /// folder of --output.
    #[arg(long, value_name = "FIRST..LAST", num_args = 0..=1, default_missing_value = "",
          conflicts_with_all = ["zone", "depth", "ids", "normals", "frame"])]
    pub frames: Option<FrameRange>,
    /// Depth words as a NumPy array (int64, background = 2^(W-1) - 1).
    #[arg(long, value_name = "FILE.npy")]
    pub depth: Option<PathBuf>,
    /// Object indices as a NumPy array (int32, background = -1).
    #[arg(long, value_name = "FILE.npy")]
    pub ids: Option<PathBuf>,
    /// Normals as a NumPy array (int16, three components).
    #[arg(long, value_name = "FILE.npy")]
    pub normals: Option<PathBuf>,
    /// Rows of the root network per register stage (model rtl).
    #[arg(long, default_value_t = 1, value_name = "R")]
    pub rows_per_stage: usize,
}

/// Arguments of `prepare`.
#[derive(Debug, Args)]
pub struct Prepare {
    /// Scene.
    #[command(flatten)]
    pub scene: Scene,
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub struct Check {
    /// Scene.
    #[command(flatten)]
    pub scene: Scene,
}

/// Arguments of `compare`.
#[derive(Debug, Args)]
pub struct Compare {
    /// Folder for comparison.png, comparison.json and comparison.md; nothing is written without it.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Picture size in pixels.
    #[arg(long, value_name = "WxH", default_value = "320x240")]
    pub size: Size,
}

/// Arguments of `trade`.
#[derive(Debug, Args)]
pub struct Trade {
    /// Scene file (TOML).
    pub scene: PathBuf,
    /// Folder of the results; a run that was interrupted goes on where it stopped.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Picture size in pixels; the scene's own if not given.
    #[arg(long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Device of the costs: ice40-hx8k, ice40-up5k, ecp5-45k or ecp5-85k.
    #[arg(long, value_name = "T", default_value = "ecp5-45k")]
    pub target: String,
    /// Place and route the slowest units of the machines as well, for clock and pixels per second: minutes more, the first time.
    #[arg(long)]
    pub clock: bool,
    /// Synthesise nothing: errors, clocks and toggles alone. A later run without it adds the costs.
    #[arg(long, conflicts_with = "clock")]
    pub no_cost: bool,
    /// Which points: a dozen or some two hundred and fifty.
    #[arg(long, value_enum, default_value_t = Points::Full)]
    pub points: Points,
    /// Measure part K of N of the points alone, and sum up nothing.
    #[arg(long, value_name = "K/N")]
    pub shard: Option<ShardArgument>,
    /// What runs the points: this program on all cores, or jobs of a HyperQueue server.
    #[arg(long, value_enum, default_value_t = TradeEngine::Local, conflicts_with = "shard")]
    pub engine: TradeEngine,
    /// Server folder of a running HyperQueue server; one with workers of its own is started if not given (engine hq).
    #[arg(long, value_name = "DIR")]
    pub server: Option<PathBuf>,
    /// Workers of that server, of one core each, and a quarter of the parts that the points are divided into (engine hq).
    #[arg(long, default_value_t = 2, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    pub workers: u16,
}

/// What runs the points of a trade.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TradeEngine {
    /// This program.
    Local,
    /// HyperQueue.
    Hq,
}

/// Arguments of `fit`.
#[derive(Debug, Args)]
pub struct Fit {
    /// Scene files (TOML); several are the frames of an animation, with the same objects. A scene with images stands for all of its frames.
    #[arg(required = true)]
    pub scenes: Vec<PathBuf>,
    /// Folder of the Verilog, the contract and the pictures.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Picture size in pixels; the scene's own if not given.
    #[arg(long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Greatest depth error: words of the base format, D / (2^23 - 1), such as 1, or pixels of depth such as 0.5px.
    #[arg(long, value_name = "LIMIT")]
    pub max_depth_error: Option<DepthLimit>,
    /// Pixels that are seen in picture or truth alone: a number such as 0, or a part of the picture such as 0.1%.
    #[arg(long, value_name = "N")]
    pub max_silhouette_errors: Option<CountLimit>,
    /// Pixels that show another object or face: a number or a part of the picture.
    #[arg(long, value_name = "N")]
    pub max_face_errors: Option<CountLimit>,
    /// Greatest difference of a colour channel, in 1/255, where picture and truth show the same face.
    #[arg(long, value_name = "C")]
    pub max_colour_error: Option<f64>,
    /// Greatest angle of a normal in degrees, where picture and truth show the same face.
    #[arg(long, value_name = "DEGREES")]
    pub max_normal_error: Option<f64>,
    /// Place and route the slowest units as well, for their clock.
    #[arg(long)]
    pub clock: bool,
    /// Clock that the slowest unit must reach on the target.
    #[arg(long, value_name = "MHZ")]
    pub min_mhz: Option<f64>,
    /// Device of the costs: ice40-hx8k, ice40-up5k, ecp5-45k or ecp5-85k.
    #[arg(long, value_name = "T", default_value = "ecp5-45k")]
    pub target: String,
    /// Simulator that checks the emitted Verilog on every frame.
    #[arg(long, value_enum, default_value_t = FitEngine::Verilator)]
    pub engine: FitEngine,
}

/// Simulators of fitted machines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FitEngine {
    /// Verilator.
    Verilator,
    /// Icarus Verilog.
    Icarus,
    /// The Verilog is written unchecked.
    None,
}

impl Fit {
    /// What is allowed.
    pub fn budget(&self) -> Budget {
        Budget {
            depth: self.max_depth_error,
            silhouette: self.max_silhouette_errors,
            faces: self.max_face_errors,
            colour: self.max_colour_error,
            normal: self.max_normal_error,
        }
    }

    /// The command line that does the same.
    pub fn reproduce(&self, budget: &Budget) -> String {
        let scenes: Vec<String> = self
            .scenes
            .iter()
            .map(|s| s.display().to_string())
            .collect();
        let mut command = format!("imogene fit {}", scenes.join(" "));
        if let Some(size) = self.size {
            command += &format!(" --size {}x{}", size.width, size.height);
        }
        command += &budget.options();
        if let Some(mhz) = self.min_mhz {
            command += &format!(" --min-mhz {mhz}");
        }
        if self.clock {
            command += " --clock";
        }
        command + &format!(" --target {} --out {}", self.target, self.out.display())
    }
}

/// Points of the design space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Points {
    /// A dozen.
    Quick,
    /// All.
    Full,
}

/// A part of the points as written on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShardArgument(pub Shard);

impl FromStr for ShardArgument {
    type Err = String;

    fn from_str(text: &str) -> Result<ShardArgument, String> {
        let parse = |part: &str| part.parse::<usize>().ok();
        text.split_once('/')
            .and_then(|(number, of)| Some((parse(number)?, parse(of)?)))
            .filter(|(number, of)| (1..=*of).contains(number))
            .map(|(number, of)| ShardArgument(Shard { number, of }))
            .ok_or_else(|| "expected K/N with K from 1 to N, such as 2/8".to_string())
    }
}

/// Arguments of `shading`.
#[derive(Debug, Args)]
pub struct Shading {
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
        value_delimiter = ',',
        default_value = "160x120,320x240,640x480,1024x768",
        requires = "scenes"
    )]
    pub sizes: Vec<Size>,
    /// Depth words in bits.
    #[arg(
        long,
        value_name = "W",
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
    /// Depth word in bits: 16, 20, 24, 28 or 32; the sweep word-length tries them all.
    #[arg(long, default_value_t = 24, value_name = "W")]
    pub format: u32,
    /// Folder for NAME.svg of each sweep, sweeps.json and sweeps.md; nothing is written without it.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// What runs the hardware.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum EngineName {
    /// The built-in simulator; needs no outside tool.
    RustHdl,
    /// The emitted Verilog in Icarus Verilog.
    Icarus,
    /// The emitted Verilog in Verilator.
    Verilator,
}

impl EngineName {
    /// The simulator of Verilog that it is, if it is one.
    pub fn simulator(self) -> Option<Simulator> {
        match self {
            EngineName::RustHdl => None,
            EngineName::Icarus => Some(Simulator::Icarus),
            EngineName::Verilator => Some(Simulator::Verilator),
        }
    }
}

/// Arguments of `cosim`.
#[derive(Debug, Args)]
pub struct Cosim {
    /// Scene file, a unit as listed by `imogene units`, or a named extreme: extremes/NAME, or extremes for all.
    pub subject: String,
    /// What runs the hardware.
    #[arg(long, value_enum, default_value_t = EngineName::RustHdl)]
    pub engine: EngineName,
    /// Run what synthesis makes of a unit instead of the emitted Verilog: ice40-hx8k, ice40-up5k, ecp5-45k or ecp5-85k.
    #[arg(long, value_name = "T")]
    pub netlist: Option<String>,
    /// Waveforms of hardware and golden model (VCD), with a GTKWave save file beside it.
    #[arg(long, value_name = "FILE.vcd")]
    pub vcd: Option<PathBuf>,
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
    #[arg(long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Object of a scene whose processor is traced.
    #[arg(long, default_value_t = 0, value_name = "OBJECT")]
    pub trace_object: usize,
    /// Flip one bit of one coefficient word in the hardware, to see it found.
    #[arg(long, value_name = "OBJECT:ADDRESS:BIT")]
    pub inject_fault: Option<FaultArgument>,
}

/// Arguments of `speed`.
#[derive(Debug, Args)]
pub struct Speed {
    /// Unit, as listed by `imogene units`.
    #[arg(default_value = "quadric_processor")]
    pub unit: String,
    /// Parameters.
    #[command(flatten)]
    pub shape: Shape,
    /// Drive it with the random stimulus of `cosim` instead of a frame of constant words.
    #[arg(long)]
    pub random: bool,
    /// Seconds for each engine and each kind of work.
    #[arg(long, default_value_t = 3, value_name = "S", value_parser = clap::value_parser!(u32).range(1..=600))]
    pub seconds: u32,
}

/// Arguments of `synth`.
#[derive(Debug, Args)]
pub struct Synth {
    /// Unit, as listed by `imogene units`.
    #[arg(required_unless_present_any = ["table", "check"])]
    pub unit: Option<String>,
    /// Device: ice40-hx8k, ice40-up5k, ecp5-45k, ecp5-85k, xilinx7, gowin, or transistors.
    #[arg(long, value_name = "T", required_unless_present_any = ["table", "check"])]
    pub target: Option<String>,
    /// Seeds of place and route; 0 measures no clock.
    #[arg(long, default_value_t = 3, value_name = "N")]
    pub seeds: usize,
    /// Parameters.
    #[command(flatten)]
    pub shape: Shape,
    /// Synthesise even what is kept of the same Verilog and tools.
    #[arg(long, conflicts_with = "table")]
    pub fresh: bool,
    /// Make the resource table of the documentation instead, its figures as JSON and its picture; it fixes units, targets and seeds.
    #[arg(long, conflicts_with_all = ["unit", "target", "seeds"])]
    pub table: bool,
    /// File of the table; its figures go beside it as .json, its picture into images/.
    #[arg(
        long,
        value_name = "FILE.md",
        conflicts_with_all = ["unit", "check"],
        default_value = "docs/resources.md"
    )]
    pub out: PathBuf,
    /// Synthesise the rows of the table again, or those of UNIT or --target; exit code 1 if one got worse than the baseline.
    #[arg(
        long,
        conflicts_with_all = ["table", "seeds", "format", "planes", "rows_per_stage", "objects", "digits", "corrections"]
    )]
    pub check: bool,
    /// File to check against.
    #[arg(
        long,
        value_name = "FILE.json",
        requires = "check",
        default_value = "docs/resources.json"
    )]
    pub baseline: PathBuf,
    /// Percent of the baseline that a resource may grow.
    #[arg(long, value_name = "PERCENT", requires = "check", default_value_t = 2.0, value_parser = percent)]
    pub tolerance: f64,
    /// Percent of the baseline that Fmax may fall.
    #[arg(long, value_name = "PERCENT", requires = "check", default_value_t = 10.0, value_parser = percent)]
    pub clock_tolerance: f64,
    /// Check resources alone, without place and route.
    #[arg(long, requires = "check")]
    pub no_clock: bool,
}

fn percent(text: &str) -> Result<f64, String> {
    let value = text.parse::<f64>().ok();
    value
        .filter(|value| value.is_finite() && *value >= 0.0)
        .ok_or_else(|| "expected a percentage, 0 or more, such as 2.5".to_string())
}

/// Arguments of `peers`.
#[derive(Debug, Args)]
pub struct Peers {
    /// Verilog file of the peer, .v, or .sv for SystemVerilog; several in the order they are read.
    #[arg(long, value_name = "FILE", required = true)]
    pub rtl: Vec<PathBuf>,
    /// Its top module.
    #[arg(long, value_name = "NAME")]
    pub top: String,
    /// Its clock port [default: clk or clock].
    #[arg(long, value_name = "PORT")]
    pub clock: Option<String>,
    /// Folder of files it includes; may be given several times.
    #[arg(long, value_name = "DIR")]
    pub include: Vec<PathBuf>,
    /// A parameter of its top module; may be given several times.
    #[arg(long, value_name = "NAME=VALUE")]
    pub parameter: Vec<Parameter>,
    /// Unit to measure beside it, as listed by `imogene units`.
    #[arg(long, value_name = "UNIT")]
    pub against: String,
    /// Parameters of the unit.
    #[command(flatten)]
    pub shape: Shape,
    /// Device: ice40-hx8k, ice40-up5k, ecp5-45k, ecp5-85k, xilinx7, gowin, or transistors.
    #[arg(long, value_name = "T")]
    pub target: String,
    /// Seeds of place and route; 0 measures no clock.
    #[arg(long, default_value_t = 3, value_name = "N")]
    pub seeds: usize,
}

/// A parameter of a module and its value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter(pub String, pub String);

impl FromStr for Parameter {
    type Err = String;

    fn from_str(text: &str) -> Result<Parameter, String> {
        text.split_once('=')
            .filter(|(name, value)| !name.is_empty() && !value.is_empty())
            .map(|(name, value)| Parameter(name.to_owned(), value.to_owned()))
            .ok_or_else(|| "expected NAME=VALUE, such as WIDTH=24".to_string())
    }
}

/// A picture size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Pixels per line.
    pub width: u32,
    /// Lines.
    pub height: u32,
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Size, String> {
        let parse = |part: &str| part.parse::<u32>().ok();
        text.split_once('x')
            .and_then(|(w, h)| Some((parse(w)?, parse(h)?)))
            .map(|(width, height)| Size { width, height })
            .ok_or_else(|| "expected WIDTHxHEIGHT in pixels, such as 320x240".to_string())
    }
}

/// Guard bits of f1 and f2.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Guards {
    /// Of f1.
    pub linear: u32,
    /// Of f2.
    pub quadratic: u32,
}

impl FromStr for Guards {
    type Err = String;

    fn from_str(text: &str) -> Result<Guards, String> {
        let parse = |part: &str| part.parse::<u32>().ok();
        text.split_once(':')
            .and_then(|(linear, quadratic)| Some((parse(linear)?, parse(quadratic)?)))
            .map(|(linear, quadratic)| Guards { linear, quadratic })
            .ok_or_else(|| "expected G1:G2, two numbers of bits, such as 2:4".to_string())
    }
}

/// A fault as written on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FaultArgument(pub Fault);

impl FromStr for FaultArgument {
    type Err = String;

    fn from_str(text: &str) -> Result<FaultArgument, String> {
        let numbers: Option<Vec<u8>> = text.split(':').map(|part| part.parse().ok()).collect();
        match numbers.as_deref() {
            Some(&[object, address, bit]) => Ok(FaultArgument(Fault {
                object,
                address,
                bit,
            })),
            _ => Err("expected OBJECT:ADDRESS:BIT, three numbers below 256, such as 0:2:5".into()),
        }
    }
}
