//! What a trade is asked for.

use super::design::Design;
use super::point::CostsOf;
use imogene_plan::description::MachineDescription;
use imogene_plan::pace::Timing;
use imogene_scene::SceneFile;
use std::path::Path;

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
