//! The figures of a synthesis by which designs are compared.

use crate::report::SynthReport;
use serde::{Deserialize, Serialize};

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
