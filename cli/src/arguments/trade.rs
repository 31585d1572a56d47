//! Arguments of `trade`.

use super::parse::{self, Choices, choice, name};
use super::scene::{Size, size};
use clap::{Args, ValueEnum};
use imogene_studies::trade::design::Space;
use imogene_studies::trade::run::Shard;
use std::path::PathBuf;

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
