//! Arguments of `fit` and `trade`.

use super::parse::{self, Choices, choice, name, option};
use super::scene::{Size, size};
use clap::{Args, ValueEnum};
use imogene_plan::description::MachineKind;
use imogene_prepare::lit_sphere::SphereForm;
use imogene_studies::fit::budget::{Budget, CountLimit, DepthLimit};
use imogene_studies::fit::frames::Frames;
use imogene_studies::fit::machine::Pace;
use imogene_studies::fit::omission::LeaveOut;
use imogene_studies::trade::design::Space;
use imogene_studies::trade::run::Shard;
use imogene_verif::engine::Engine;
use imogene_verif::engine::simulator::Simulator;
use std::path::PathBuf;

/// Arguments of `fit`; without a value nothing is asked for.
#[derive(Debug, Default, Args)]
pub struct Fit {
    /// Scene files (TOML); several are the frames of an animation, with the same objects. A scene with images stands
    /// for all of its frames.
    #[arg(required = true)]
    pub scenes: Vec<PathBuf>,
    /// Folder of the Verilog, the contract and the pictures.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Picture size in pixels; the scene's own if not given.
    #[arg(long, value_name = "WxH", value_parser = size)]
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
    #[arg(long, value_name = "C", value_parser = at_least_zero)]
    pub max_colour_error: Option<f64>,
    /// Greatest angle of a normal in degrees, where picture and truth show the same face.
    #[arg(long, value_name = "DEGREES", value_parser = at_least_zero)]
    pub max_normal_error: Option<f64>,
    /// Which machine; if not given, a beam machine for up to 16 processors, and a zone machine for more.
    #[arg(long, value_parser = choice(MACHINES))]
    pub machine: Option<MachineKind>,
    /// Leave out what fewer than so many pixels of every frame show: objects, and cut planes without which fewer pixels
    /// show something else; or with auto what makes the machine smallest within the budget. The machine is fitted to
    /// what is left, for which a scene file is written, and the budget counts the difference.
    #[arg(long, value_name = "PIXELS|auto")]
    pub leave_out: Option<LeaveOut>,
    /// Pixels of a line that a beam machine draws at once, 1, 2 or 4; it streams them.
    #[arg(long, value_name = "N", value_parser = choice(PIXELS))]
    pub pixels_per_clock: Option<u32>,
    /// Frames per second that the machine must reach, at the clock of --min-mhz or at 50 MHz.
    #[arg(long, value_name = "F", value_parser = at_least_zero)]
    pub min_fps: Option<f64>,
    /// Shade by tables of the direction of the normal, of so many entries along each side, in the place of a shading
    /// processor: fewer cells, with all lights and the viewer infinitely far (docs/shading.md). With :nearest the
    /// nearest entry is the colour, with three multipliers. The budget of colours is that of the words.
    #[arg(long, value_name = "SIDE[:nearest]", num_args = 0..=1, default_missing_value = "64", require_equals = true, value_parser = tables)]
    pub lit_sphere: Option<SphereForm>,
    /// Leave out synthesis: no costs, and the machine that should be smallest is taken.
    #[arg(long, conflicts_with_all = ["clock", "min_mhz", "max_cells"])]
    pub no_cost: bool,
    /// Place and route the slowest units as well, for their clock.
    #[arg(long)]
    pub clock: bool,
    /// Clock that the slowest unit must reach on the target.
    #[arg(long, value_name = "MHZ", value_parser = at_least_zero)]
    pub min_mhz: Option<f64>,
    /// Logic cells of the target that the machine may take; without --machine a zone machine is tried where a beam
    /// machine takes more.
    #[arg(long, value_name = "N")]
    pub max_cells: Option<u64>,
    /// Device of the costs: ice40-hx8k, ice40-up5k, ecp5-45k or ecp5-85k.
    #[arg(long, value_name = "T", default_value = "ecp5-45k")]
    pub target: String,
    /// Simulator that checks the hardware on every frame; icarus and verilator run the emitted Verilog.
    #[arg(long, value_parser = choice(ENGINES), default_value = "built-in")]
    pub engine: FitEngine,
}

/// The simulator of a fitted machine, if it is checked.
pub type FitEngine = Option<Engine>;

/// The description of the machine among the files.
pub const MACHINE_FILE: &str = "machine.toml";

const MACHINES: Choices<MachineKind> = &[
    (MachineKind::Beam, "beam", "A processor for each object"),
    (MachineKind::Zone, "zone", "Processors shared zone by zone"),
];

const PIXELS: Choices<u32> = &[
    (1, "1", "A pixel on every clock"),
    (2, "2", "Two neighbours"),
    (4, "4", "Four neighbours"),
];

/// Clock at which frames per second are counted if none is asked for, in MHz.
const CLOCK: f64 = 50.0;

#[rustfmt::skip]
const ENGINES: Choices<FitEngine> = &[
    (Some(Engine::BuiltIn), "built-in", "The simulator of the circuits, in process; needs no outside tool"),
    (Some(Engine::Verilog(Simulator::Verilator)), "verilator", "Verilator"),
    (Some(Engine::Verilog(Simulator::Icarus)), "icarus", "Icarus Verilog"),
    (None, "none", "The Verilog is written unchecked"),
];

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

    /// Which machine: a beam machine for several pixels per clock.
    pub fn kind(&self) -> Option<MachineKind> {
        let several = self.pixels_per_clock.filter(|pixels| *pixels > 1);
        self.machine.or(several.map(|_| MachineKind::Beam))
    }

    /// How fast the machine must be.
    pub fn pace(&self) -> Option<Pace> {
        self.min_fps.map(|frames| Pace {
            frames,
            mhz: self.min_mhz.unwrap_or(CLOCK),
        })
    }

    /// The command line that shows the scenes on the machine.
    pub fn command(&self, frames: &Frames, written: &[PathBuf]) -> String {
        let (scenes, animation) = match written {
            [] if frames.all.len() > self.scenes.len() => (&self.scenes[..], " --animation"),
            [] => (&self.scenes[..], ""),
            written => (written, ""),
        };
        let scenes = listed(scenes);
        let machine = self.out.join(MACHINE_FILE);
        format!(
            "imogene machine {scenes}{animation} --machine {} --out DIR",
            machine.display()
        )
    }

    /// The command line that does the same.
    pub fn reproduce(&self, budget: &Budget) -> String {
        let size = self.size.map(|(width, height)| format!("{width}x{height}"));
        let machine = self.machine.map(|kind| name(MACHINES, kind));
        let flag = |is_given: bool, flag: &str| if is_given { flag } else { "" }.to_owned();
        [
            format!("imogene fit {}", listed(&self.scenes)),
            option("size", size),
            budget.options(),
            option("machine", machine),
            lit_sphere(self.lit_sphere),
            option("leave-out", self.leave_out),
            option("pixels-per-clock", self.pixels_per_clock),
            option("min-fps", self.min_fps),
            flag(self.no_cost, " --no-cost"),
            option("min-mhz", self.min_mhz),
            flag(self.clock, " --clock"),
            option("max-cells", self.max_cells),
            option("target", Some(&self.target)),
            option("out", Some(self.out.display())),
        ]
        .concat()
    }
}

fn listed(paths: &[PathBuf]) -> String {
    let paths = paths.iter().map(|path| path.display().to_string());
    paths.collect::<Vec<_>>().join(" ")
}

/// Entries along each side of a table, and whether the nearest one is the colour.
pub fn tables(text: &str) -> Result<SphereForm, String> {
    let forms =
        (4..=7).flat_map(|places| [false, true].map(|nearest| SphereForm { places, nearest }));
    let found = forms.into_iter().find(|form| form.to_string() == text);
    found.ok_or_else(|| "expected 16, 32, 64 or 128, or one of them with :nearest".to_owned())
}

/// The option of such tables, with a blank before it; nothing without any.
pub fn lit_sphere(tables: Option<SphereForm>) -> String {
    tables.map_or(String::new(), |form| format!(" --lit-sphere={form}"))
}

fn at_least_zero(text: &str) -> Result<f64, String> {
    parse::at_least_zero(text, "expected a number, 0 or more, such as 0.5")
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
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<Size>,
    /// Device of the costs: ice40-hx8k, ice40-up5k, ecp5-45k or ecp5-85k.
    #[arg(long, value_name = "T", default_value = "ecp5-85k")]
    pub target: String,
    /// Place and route the slowest units of the machines on the front of speed, area and accuracy, instead of
    /// estimating their clocks: many minutes more, the first time.
    #[arg(long)]
    pub clock: bool,
    /// Synthesise nothing: errors, clocks per frame, estimated speed and toggles alone. A later run without it adds the
    /// costs.
    #[arg(long, conflicts_with = "clock")]
    pub no_cost: bool,
    /// Which points: some twenty or more than five hundred.
    #[arg(long, value_parser = choice(SPACES), default_value = "full")]
    pub points: Space,
    /// Measure part K of N of the points alone, and sum up nothing.
    #[arg(long, value_name = "K/N", value_parser = shard)]
    pub shard: Option<Shard>,
    /// What runs the points: this program on all cores, or jobs of a HyperQueue server.
    #[arg(long, value_enum, default_value_t = TradeEngine::Local, conflicts_with = "shard")]
    pub engine: TradeEngine,
    /// Server folder of a running HyperQueue server; one with workers of its own is started if not given (engine hq).
    #[arg(long, value_name = "DIR")]
    pub server: Option<PathBuf>,
    /// Workers of that server, of one core each, and a quarter of the parts that the points are divided into (engine
    /// hq).
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

/// Points of the design space.
const SPACES: Choices<Space> = &[
    (Space::Quick, "quick", "Some twenty"),
    (Space::Full, "full", "All"),
    (
        Space::Roots,
        "roots",
        "Every form of the root at two depth words",
    ),
];

impl Trade {
    /// The name of the points.
    pub fn points(&self) -> &'static str {
        name(SPACES, self.points)
    }
}

fn shard(text: &str) -> Result<Shard, String> {
    let shard = parse::pair::<usize>(text, '/').map(|(number, of)| Shard { number, of });
    let shard = shard.filter(|shard| (1..=shard.of).contains(&shard.number));
    shard.ok_or_else(|| "expected K/N with K from 1 to N, such as 2/8".to_string())
}
