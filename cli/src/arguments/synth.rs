//! Arguments of the commands that synthesise.

use super::parse;
use super::unit::{Fitted, Shape};
use clap::Args;
use imogene_synth::Cache;
use std::path::PathBuf;

/// Arguments of `synth`.
#[derive(Debug, Args)]
pub struct Synth {
    /// Unit, as listed by `imogene units`.
    #[arg(required_unless_present_any = ["table", "check", "machine"])]
    pub unit: Option<String>,
    /// Whole machine in the place of a unit, as those in machines/, placed and routed as one.
    #[arg(long, value_name = "FILE.toml", conflicts_with_all = ["unit", "table", "check", "widths", "format", "parameters"])]
    pub machine: Option<PathBuf>,
    /// Device: ice40-hx8k, ice40-up5k, ecp5-45k, ecp5-85k, xilinx7, gowin, or transistors.
    #[arg(long, value_name = "T", required_unless_present_any = ["table", "check"])]
    pub target: Option<String>,
    /// Seeds of place and route; 0 measures no clock.
    #[arg(long, default_value_t = 3, value_name = "N", conflicts_with = "widths")]
    pub seeds: usize,
    /// Parameters.
    #[command(flatten)]
    pub shape: Shape,
    /// Widths and slots instead.
    #[command(flatten)]
    pub fitted: Fitted,
    /// Synthesise even what is kept, or stands in the table, of the same Verilog and tools.
    #[arg(long, conflicts_with = "widths")]
    pub fresh: bool,
    /// Make the resource table of the documentation instead, its figures as JSON and its picture; it fixes units,
    /// targets and seeds. Rows of the same Verilog and tools keep their figures.
    #[arg(long, conflicts_with_all = ["unit", "target", "seeds", "widths", "format", "parameters"])]
    pub table: bool,
    /// File of the table; its figures go beside it as .json, its picture into images/.
    #[arg(
        long,
        value_name = "FILE.md",
        conflicts_with_all = ["unit", "check"],
        default_value = "docs/resources.md"
    )]
    pub out: PathBuf,
    /// Synthesise the rows of the table again, or those of UNIT or --target; exit code 1 if one got worse than the
    /// baseline.
    #[arg(long, conflicts_with_all = ["table", "seeds", "format", "parameters", "widths"])]
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

impl Synth {
    /// Whether kept results count.
    pub fn cache(&self) -> Cache {
        match self.fresh {
            true => Cache::Renew,
            false => Cache::Use,
        }
    }
}

fn percent(text: &str) -> Result<f64, String> {
    parse::at_least_zero(text, "expected a percentage, 0 or more, such as 2.5")
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
    #[arg(long, value_name = "NAME=VALUE", value_parser = parameter)]
    pub parameter: Vec<(String, String)>,
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

fn parameter(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((name, value)) if !name.is_empty() && !value.is_empty() => {
            Ok((name.to_owned(), value.to_owned()))
        }
        _ => Err("expected NAME=VALUE, such as WIDTH=24".to_owned()),
    }
}
