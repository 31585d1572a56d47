//! Arguments of every command.

mod accuracy;
mod cosim;
mod detail;
mod evaluate;
mod fit;
mod frames;
mod import;
mod machine;
mod oracle;
mod proof;
mod scene;
mod split;
mod synth;
mod terrain;
mod trade;
mod unit;

use crate::missing::Policy;
pub use accuracy::{Bounds, Shading, Sweep};
use clap::{Parser, Subcommand};
pub use cosim::{Cosim, EngineName, Speed};
pub use detail::Detail;
pub use evaluate::Evaluate;
pub use fit::{Fit, FitEngine};
pub use frames::FrameRange;
pub use import::{CellForm, Import, ImportKind};
pub use machine::{Machine, Refine};
pub use oracle::{Cracks, Repair, Trace};
pub use proof::{Mutate, Prove};
pub use scene::{Check, Compare, Guards, Model, Prepare, Render, Scene, Size, View, Widths};
pub use split::Split;
pub use synth::{Parameter, Peers, Synth};
pub use terrain::Terrain;
pub use trade::{Points, Trade, TradeEngine};
pub use unit::{Contract, Demo, Emit, Package, Processors, Roots, Shape};

/// Hardware that draws quadrics, proven against a golden model.
///
/// Exit codes: 0 done and all checks hold, 1 a check failed, 2 bad input or usage.
#[derive(Debug, Parser)]
#[command(version, propagate_version = true)]
pub struct Arguments {
    /// Print one JSON document on standard output and nothing else there.
    #[arg(long, global = true)]
    pub json: bool,
    /// Refuse a scene if one of its objects cannot be drawn, with exit code 2, in the place of leaving the object out.
    #[arg(long, global = true, conflicts_with = "allow_missing")]
    pub strict: bool,
    /// End with exit code 0 though an object that cannot be drawn is left out.
    #[arg(long, global = true)]
    pub allow_missing: bool,
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
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
