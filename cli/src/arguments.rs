//! Arguments of every command.

mod accuracy;
mod fit;
mod given;
mod import;
mod machine;
mod parse;
mod scene;
mod synth;
mod unit;
mod verify;

pub use accuracy::{Bounds, Cracks, Evaluate, Raytrace, Repair, Shading, Sweep};
use clap::{Parser, Subcommand};
pub use fit::{Fit, MACHINE_FILE, Trade, TradeEngine, lit_sphere};
pub use given::Given;
pub use import::{Deviation, Import, Terrain, kind_name};
pub use machine::{Board, Machine};
pub use parse::{FrameRange, option, pair};
pub use scene::{
    Check, Detail, LookOptions, Model, New, Primitives, Render, Scene, SceneWords, Size, Split,
    View,
};
pub use synth::{Peers, Synth};
pub use unit::{Contract, Demo, Emit, Fitted, Package, Parameters, Processors, Roots, Shape};
pub use verify::{Cosim, Mutate, Prove, Speed, Waves};

/// Hardware that draws quadrics, proven against a golden model.
///
/// Exit codes: 0 done and all checks hold, 1 a check failed, 2 bad input or usage.
#[derive(Debug, Parser)]
#[command(version, propagate_version = true)]
pub struct Arguments {
    /// Print one JSON document on standard output and nothing else there.
    #[arg(long, global = true, help_heading = "Any command")]
    pub json: bool,
    /// Refuse a scene if one of its objects cannot be drawn, with exit code 2, in the place of leaving the object out.
    #[arg(
        long,
        global = true,
        help_heading = "Any command",
        conflicts_with = "allow_missing"
    )]
    pub strict: bool,
    /// End with exit code 0 though an object that cannot be drawn is left out.
    #[arg(long, global = true, help_heading = "Any command")]
    pub allow_missing: bool,
    /// Most memory to take, such as 512M or 2G, for scenes of very many objects [default: what the machine has].
    #[arg(long, global = true, help_heading = "Any command", value_name = "SIZE", value_parser = bytes)]
    pub max_memory: Option<u64>,
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// A size in bytes, more than 0, with a unit of 1024, 1024^2 or 1024^3 of them or none.
pub fn bytes(text: &str) -> Result<u64, String> {
    let (digits, unit) = match text.char_indices().last() {
        Some((at, letter)) if letter.is_ascii_alphabetic() => (&text[..at], letter),
        _ => (text, ' '),
    };
    let power = " KMG".find(unit.to_ascii_uppercase());
    let number: Option<u64> = digits.parse().ok().filter(|number| *number > 0);
    let parts = number.zip(power);
    let bytes = parts.and_then(|(number, power)| number.checked_mul(1 << (10 * power)));
    bytes.ok_or_else(|| "a number of bytes is expected, such as 512M or 2G".to_owned())
}

/// What to do about objects that cannot be drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Policy {
    /// Refuse the scene.
    Strict,
    /// Warn, and fail at the end.
    Warn,
    /// Warn.
    Allow,
}

impl Arguments {
    /// What to do about objects that cannot be drawn.
    pub fn policy(&self) -> Policy {
        match (self.strict, self.allow_missing) {
            (true, _) => Policy::Strict,
            (_, true) => Policy::Allow,
            _ => Policy::Warn,
        }
    }
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Draw the teapot with the hardware in simulation, check every clock, and write pictures, Verilog and waveforms.
    Demo(Demo),
    /// Write a commented scene file that draws at once.
    New(New),
    /// Draw a scene: with the golden model, the exact reference or the hardware in simulation.
    Render(Render),
    /// Turn a molecule, CAD faces, a STEP file or terrain into a scene.
    Import(Import),
    /// Make a grid of heights at random, for `imogene import`.
    Terrain(Terrain),
    /// Judge a scene before it is drawn: whether it fits, its proven error bounds, the bits and planes it needs.
    Check(Check),
    /// Print the integer words that the hardware is loaded with for a scene.
    Prepare(Scene),
    /// Find what a scene's picture does not need: hidden objects, planes without effect, empty zones.
    Detail(Detail),
    /// Compare the golden pictures of scenes with those of an independent ray tracer.
    #[command(alias = "trace")]
    Raytrace(Raytrace),
    /// Search the golden picture of a scene for cracks, or make cracks and see how many are found.
    Cracks(Cracks),
    /// Draw a scene in short words and solve exactly the pixels that they leave open.
    Repair(Repair),
    /// List every unit: parameters with legal ranges, latency, sources.
    Units,
    /// List the object processors: what each is made of, its latency, and what the sources count.
    Processors(Processors),
    /// Print the contract of a unit: ports, widths as formulas, latency, ties, error.
    Contract(Contract),
    /// Write the Verilog of a unit or of a whole machine.
    Emit(Emit),
    /// Write every unit as an IP core: Verilog, contract, self-checking bench, FuseSoC core file.
    Package(Package),
    /// Show scenes on the pins of a whole machine with a screen, compared on every clock: Verilog, picture from the
    /// pins.
    Machine(Machine),
    /// Make a board that shows a scene: top level, constraints, bitstream, and the picture that its pins show.
    Board(Board),
    /// Synthesise a unit or a whole machine with the open tools: LUT, FF, DSP, BRAM, Fmax; or make the resource table,
    /// or check against it.
    Synth(Synth),
    /// Synthesise the Verilog of another project beside a unit, with the same scripts, harness and seeds.
    Peers(Peers),
    /// Compare hardware and golden model clock by clock, for a scene, a unit or a named extreme; with waveforms.
    Cosim(Cosim),
    /// Prove properties of the emitted Verilog, or show that each is refuted on broken designs.
    Prove(Prove),
    /// Score the stimulus of a unit: how many small changes of its circuit it notices.
    Mutate(Mutate),
    /// Measure how fast the simulators run a unit: clocks per second alone, with the scoreboard, with waveforms.
    Speed(Speed),
    /// Find the smallest machine that draws a scene within a budget of errors; emit it, and show the scene on its pins.
    Fit(Fit),
    /// Measure every machine of a design space on one scene: speed, area and accuracy as figures, plots and a page.
    Trade(Trade),
    /// Try the error bounds on random cases, or show errors and guard bits of scenes at several sizes and formats.
    Bounds(Bounds),
    /// Take one number of a scene to its extreme, step by step: proven bound, observed error, refusals, plots.
    Sweep(Sweep),
    /// Measure what the three ways to draw round objects cost: facets, paraboloids, quadrics.
    #[command(alias = "compare")]
    Primitives(Primitives),
    /// Measure the family of square root networks: error, steps, depth of a test sphere, cost.
    Roots(Roots),
    /// Measure the error of the shading processor against its formula.
    Shading(Shading),
    /// Count the cost tables of the two theses again, beside what they print.
    Evaluate(Evaluate),
}
