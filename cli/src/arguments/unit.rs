//! Arguments of the commands about units: what they are, their Verilog, contracts and packages.

use super::{Widths, depth_word};
use clap::Args;
use imogene_models::machine::fitted::FittedSlot;
use imogene_models::slots::{self, SlotsError};
use imogene_rtl::catalogue::Unit;
use imogene_verif::unit::Parameters;
use std::path::PathBuf;
use std::str::FromStr;

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
    #[arg(long, default_value_t = 24, value_name = "W", value_parser = depth_word)]
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
    #[arg(long, default_value_t = 24, value_name = "W", value_parser = depth_word)]
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
    /// Units, as listed by `imogene units`; all if none is named.
    pub units: Vec<String>,
    /// Output folder.
    #[arg(long)]
    pub out: PathBuf,
    /// Clocks of random stimulus in the vectors of each bench; 0 leaves benches and the target sim out.
    #[arg(long, default_value_t = 500)]
    pub clocks: usize,
}
