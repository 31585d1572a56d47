//! Arguments of the commands that judge the emitted Verilog.

use super::depth_word;
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
    /// Unit, as listed by `imogene units`, or `all` for those of the published table.
    pub unit: String,
    /// Depth word in bits, 8 to 32.
    #[arg(long, default_value_t = 16, value_name = "W", value_parser = depth_word)]
    pub format: u32,
    /// Mutants of a unit at most, at least 1.
    #[arg(long, default_value_t = 1_000, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub mutants: u32,
    /// Write the table of scores to this file.
    #[arg(long, value_name = "FILE.md")]
    pub out: Option<PathBuf>,
}
