//! Arguments of the commands that judge the emitted Verilog.

use super::parse::depth_word;
use super::unit::Parameters;
use clap::Args;
use std::path::PathBuf;

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
    #[arg(long, value_name = "FILE.toml", conflicts_with_all = ["format", "parameters", "netlist", "clocks", "out"])]
    pub machine: Option<PathBuf>,
    /// Depth words in bits, 8 to 32, with commas between.
    #[arg(long, default_value = "16", value_name = "W,...", value_delimiter = ',', value_parser = depth_word)]
    pub format: Vec<u32>,
    /// Parameters, of units that have them.
    #[command(flatten)]
    pub others: Parameters,
    /// Mutants of the emitted Verilog by Yosys, of each unit at most this many, in the place of every mutant of the
    /// circuit; `all` are ten units.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub netlist: Option<u32>,
    /// Stimuli that a mutant is run on at most; a proof is tried after 150. [default: 20000, with --netlist 150, runs
    /// of a machine 8]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    pub stimuli: Option<u64>,
    /// Clocks of each of them, about; the raster of a screen runs over two frames at least.
    #[arg(long, default_value_t = 150, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000_000))]
    pub clocks: u32,
    /// Write the table of scores to this file.
    #[arg(long, value_name = "FILE.md")]
    pub out: Option<PathBuf>,
}
