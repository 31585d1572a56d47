//! The result of a synthesis, and the figures by which designs are compared.

use crate::yosys::CellCounts;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The slowest path from a register to a register.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CriticalPath {
    /// Cell the path starts at.
    pub from: String,
    /// Cell the path ends at.
    pub to: String,
    /// Delay in cells, set-up included, in nanoseconds.
    pub logic_ns: f64,
    /// Delay in wires, in nanoseconds.
    pub routing_ns: f64,
}

/// One run of place and route.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SeedResult {
    /// Seed.
    pub seed: usize,
    /// Register-to-register clock in MHz.
    pub fmax_mhz: f64,
    /// The path that limits it.
    pub critical_path: Option<CriticalPath>,
}

/// The result of a synthesis; the keys of its JSON are stable.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SynthReport {
    /// Unit.
    pub unit: String,
    /// Target.
    pub target: String,
    /// Depth word and parameters of the unit, by option of the command line.
    pub parameters: BTreeMap<String, usize>,
    /// Latency in clocks.
    pub latency: usize,
    /// Look-up tables of logic; none for transistors.
    pub lut: Option<u64>,
    /// Flip-flops.
    pub ff: Option<u64>,
    /// Carry cells of the family.
    pub carry: Option<u64>,
    /// Multiplier cells.
    pub dsp: Option<u64>,
    /// Block memories.
    pub bram: Option<u64>,
    /// Logic cells after packing: look-up tables, carry chains and what packing adds; none where nothing is packed.
    pub logic_cells: Option<u64>,
    /// Transistors in static CMOS gates, for the target `transistors` alone.
    pub transistors: Option<u64>,
    /// Median over the seeds of the register-to-register clock in MHz, unit in its register harness.
    pub fmax_mhz: Option<f64>,
    /// What keeps the unit in its harness from fitting the device.
    pub does_not_fit: Option<String>,
    /// Every run of place and route.
    pub seeds: Vec<SeedResult>,
    /// Clock asked for in MHz.
    pub goal_mhz: Option<u32>,
    /// Cells of the unit by type, as Yosys counts them.
    pub cells: CellCounts,
    /// Tools and versions.
    pub tools: BTreeMap<String, String>,
    /// Digest of the Verilog.
    pub verilog: String,
    /// Seconds the tools took when the figures were made.
    pub seconds: f64,
}

impl SynthReport {
    /// The run whose clock is the median.
    pub fn median_seed(&self) -> Option<&SeedResult> {
        let mut runs = self.seeds.iter();
        runs.find(|run| Some(run.fmax_mhz) == self.fmax_mhz)
    }
}

/// Median clock in MHz; the lower one of an even number, so that it is always a clock that was reached.
pub fn median(seeds: &[SeedResult]) -> Option<f64> {
    let mut clocks: Vec<f64> = seeds.iter().map(|run| run.fmax_mhz).collect();
    clocks.sort_by(f64::total_cmp);
    clocks.get(clocks.len().checked_sub(1)? / 2).copied()
}

/// Rounds a measure. The tools work in single precision, so the digits behind are none of theirs; and a short number is
/// the same after it was written and read.
pub(crate) fn thousandths(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}

/// Resources and clock of one design on one target; a figure that the target does not have is none.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Figures {
    /// Look-up tables of logic.
    pub lut: Option<u64>,
    /// Flip-flops.
    pub ff: Option<u64>,
    /// Carry cells of the family.
    pub carry: Option<u64>,
    /// Multiplier cells.
    pub dsp: Option<u64>,
    /// Block memories.
    pub bram: Option<u64>,
    /// Logic cells after packing.
    pub cells: Option<u64>,
    /// Transistors in static CMOS gates.
    pub transistors: Option<u64>,
    /// Median over the seeds of the register-to-register clock in MHz.
    pub fmax_mhz: Option<f64>,
    /// What keeps the design in its harness from fitting the device.
    pub does_not_fit: Option<String>,
}

impl Figures {
    /// The counts with their names, in the order they are shown.
    pub fn counts(&self) -> [(&'static str, Option<u64>); 7] {
        [
            ("LUT", self.lut),
            ("FF", self.ff),
            ("carry", self.carry),
            ("DSP", self.dsp),
            ("BRAM", self.bram),
            ("cells", self.cells),
            ("transistors", self.transistors),
        ]
    }
}

impl From<&SynthReport> for Figures {
    fn from(report: &SynthReport) -> Self {
        Self {
            lut: report.lut,
            ff: report.ff,
            carry: report.carry,
            dsp: report.dsp,
            bram: report.bram,
            cells: report.logic_cells,
            transistors: report.transistors,
            fmax_mhz: report.fmax_mhz,
            does_not_fit: report.does_not_fit.clone(),
        }
    }
}
