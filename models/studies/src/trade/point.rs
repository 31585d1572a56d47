//! What a trade is asked for, what is known of a point, and the files of finished points; the keys are stable.

use super::design::Design;
use super::view::Views;
use crate::kit::picture::{WriteError, write_whole};
use imogene_analysis::metrics::Metrics;
use imogene_analysis::metrics::toggles::Toggles;
use imogene_contract::MachineWords;
use imogene_plan::description::MachineDescription;
use imogene_plan::pace::Timing;
use imogene_scene::SceneFile;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

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

/// What is to be measured.
pub struct Request<'a> {
    /// The scene.
    pub file: &'a SceneFile,
    /// As the commands name it.
    pub name: &'a str,
    /// Picture size.
    pub size: (u32, u32),
    /// Device of the costs.
    pub target: &'a str,
    /// The points.
    pub designs: Vec<Design>,
    /// Folder of the results.
    pub out: &'a Path,
    /// Version of the program, which the results name.
    pub version: &'a str,
    /// What tells this program from any other that might measure something else.
    pub program: &'a str,
    /// Where costs come from.
    pub costs: CostsOf<'a>,
    /// Whether the clocks of the points on the front of speed are to be placed and routed.
    pub with_clock: bool,
    /// What the hardware of a machine takes.
    pub timing: &'a (dyn Fn(&MachineDescription) -> Timing + Sync),
    /// Called with the number of points that are finished, from any thread.
    pub done: &'a (dyn Fn(u64) + Sync),
}

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

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Key {
    /// Digest of the scene.
    pub scene: String,
    /// The scene as the commands name it.
    pub name: String,
    pub size: (u32, u32),
    /// Device of the costs.
    pub target: String,
    pub program: String,
}

#[derive(Serialize, Deserialize)]
struct Kept {
    key: Key,
    point: Point,
}

/// A request with its scene at all sizes, and the folder of its results: a file for each point, whole or not there,
/// taken again only by the same run.
pub(super) struct Run<'a> {
    pub request: &'a Request<'a>,
    pub views: Views,
    /// What its results must belong to.
    pub key: Key,
}

impl Run<'_> {
    /// The file of a point.
    pub fn path(&self, id: &str) -> PathBuf {
        self.request.out.join("points").join(format!("{id}.json"))
    }

    /// A point that is finished and belongs to this run.
    pub fn take(&self, id: &str) -> Option<Point> {
        let bytes = std::fs::read(self.path(id)).ok()?;
        let kept: Kept = serde_json::from_slice(&bytes).ok()?;
        let point = kept.point;
        let files = [&point.picture, &point.map, &point.machine_file].into_iter();
        let is_there = |name: &String| self.request.out.join(name).is_file();
        let is_whole = files.flatten().all(is_there);
        (kept.key == self.key && point.id == id && is_whole).then_some(point)
    }

    /// Writes the file of a point.
    pub fn keep(&self, point: &Point) -> Result<(), WriteError> {
        let kept = Kept {
            key: self.key.clone(),
            point: point.clone(),
        };
        write_whole(&self.path(&point.id), |out| {
            serde_json::to_writer_pretty(&mut *out, &kept)?;
            out.write_all(b"\n")
        })
    }
}
