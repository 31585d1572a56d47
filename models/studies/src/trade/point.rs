//! What is known of a point; the keys are stable.

use super::design::Design;
use imogene_analysis::metrics::Metrics;
use imogene_analysis::metrics::toggles::Toggles;
use imogene_contract::MachineWords;
use imogene_plan::description::MachineDescription;
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
    /// Block memories.
    pub bram: u64,
    /// Logic cells.
    pub cells: u64,
    /// Clock of the slowest unit, placed and routed; none if it was not asked for.
    pub fmax_mhz: Option<f64>,
    /// True if it is estimated from machines that were synthesised.
    pub is_estimated: bool,
}

/// How costs are found.
#[derive(Clone, Copy, Debug)]
pub enum Pricing<'a> {
    /// From these machines, which were synthesised.
    Estimated(&'a [MachineDescription]),
    /// By synthesis.
    Synthesised,
    /// By synthesis, place and route, with a clock.
    Routed,
}

/// Where costs come from: those of machines in their order; or why there are none and how to get them.
pub type CostsOf<'a> =
    &'a (dyn Fn(&[MachineDescription], Pricing) -> Result<Vec<Cost>, String> + Sync);

/// One point of the design space.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// Its name.
    pub id: String,
    /// The hardware: `beam_stream` or `zone_machine`.
    pub unit: String,
    /// What was asked for.
    pub design: Design,
    /// Every width of the machine; `None` if the scene cannot be prepared for it.
    pub format: Option<MachineWords>,
    /// Why the scene cannot be prepared for it.
    pub refused: Option<String>,
    /// The machine.
    pub machine: Option<MachineDescription>,
    /// Its file, in the folder of the results.
    pub machine_file: Option<String>,
    /// Clocks of a beam machine from a pixel that is begun to its colour.
    pub latency: Option<u32>,
    /// Clocks from frame to frame, every frame with new words.
    pub clocks_per_frame: Option<u64>,
    /// How far what is drawn is from the truth.
    pub errors: Option<Metrics>,
    /// How far the picture is from the ideal one, in percent of the whole scale.
    pub picture_error: Option<f64>,
    /// The energy proxy.
    pub toggles: Option<Toggles>,
    /// What it takes: what synthesis says, of points that are not on the front of speed what is estimated.
    pub cost: Option<Cost>,
    /// What is estimated.
    pub cost_estimated: Option<Cost>,
    /// What synthesis says, if it was asked.
    pub cost_synthesised: Option<Cost>,
    /// Why there is no cost, and how to get it.
    pub cost_refused: Option<String>,
    /// Clock in MHz: the one placed and routed if there is one, else the estimated one.
    pub mhz: Option<f64>,
    /// The clock that is estimated.
    pub mhz_estimated: Option<f64>,
    /// Frames per second at that clock.
    pub frames_per_second: Option<f64>,
    /// Pixels shown per second at that clock.
    pub pixels_per_second: Option<f64>,
    /// File of the picture, in the folder of the results.
    pub picture: Option<String>,
    /// File of the error map.
    pub map: Option<String>,
    /// The command that draws the picture and compares it with the hardware, or shows the refusal.
    pub command: String,
    /// The command that writes the Verilog of the machine.
    pub emit: Option<String>,
}
