//! What is known of a point; the keys are stable.

use super::design::Design;
use imogene_analysis::metrics::Metrics;
use imogene_analysis::metrics::toggles::Toggles;
use imogene_contract::MachineWords;
use imogene_golden::machine::fitted::FittedMachine;
use serde::{Deserialize, Serialize};

/// What synthesis says of a machine.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cost {
    /// Look-up tables.
    pub lut: u64,
    /// Flip-flops.
    pub ff: u64,
    /// Multiplier blocks.
    pub dsp: u64,
    /// Logic cells.
    pub cells: u64,
    /// Greatest clock; none if it was not asked for.
    pub fmax_mhz: Option<f64>,
}

/// Where costs come from: those of machines in their order, or why there are none and how to get them.
pub type CostsOf<'a> = &'a (dyn Fn(&[FittedMachine]) -> Result<Vec<Cost>, String> + Sync);

/// One point of the design space.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// Its name.
    pub id: String,
    /// The hardware: `fitted_beam`, or `beam` for one of the catalogue.
    pub unit: String,
    /// What was asked for.
    pub design: Design,
    /// Every width of the machine; `None` if the scene cannot be prepared for it.
    pub format: Option<MachineWords>,
    /// Why the scene cannot be prepared for it.
    pub refused: Option<String>,
    /// The machine.
    pub machine: Option<FittedMachine>,
    /// Clocks from `go` to the first pixel.
    pub latency: Option<u32>,
    /// Clocks of an image.
    pub clocks_per_frame: Option<u64>,
    /// How far the picture is from the truth.
    pub errors: Option<Metrics>,
    /// The energy proxy.
    pub toggles: Option<Toggles>,
    /// What synthesis says.
    pub cost: Option<Cost>,
    /// Why there is no cost, and how to get it.
    pub cost_refused: Option<String>,
    /// Pixels of images per second at the greatest clock.
    pub pixels_per_second: Option<f64>,
    /// File of the picture, in the folder of the results.
    pub picture: Option<String>,
    /// File of the error map.
    pub map: Option<String>,
    /// The command that draws the picture, or shows the refusal.
    pub command: String,
    /// The command that writes the Verilog of the machine.
    pub emit: Option<String>,
}

impl Point {
    /// True if the picture has no silhouette error.
    pub fn is_silhouette_exact(&self) -> bool {
        self.errors.as_ref().is_some_and(|e| e.silhouette == 0)
    }
}
