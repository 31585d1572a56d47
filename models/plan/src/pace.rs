//! Clocks from frame to frame of a machine that streams its pictures, when every frame has new words and the receiver
//! never stalls.

use super::beam::{Result, frame_words};
use super::description::{MachineDescription, MachineKind};
use super::display::zone_plan;
use super::zone::clocks::{ZoneTiming, clocks};
use super::zone::refine::Refinement;
use imogene_contract::shading::{FLAT_LATENCY, LATENCY, table_latency};
use imogene_golden::machine::{accumulator, transparency};
use imogene_prepare::PreparedScene;
use imogene_scene::FramedScene;

/// Clocks of a beam machine from the last pixel of a frame that is issued to the copying of the next words, and from
/// there to the first pixel, beside those of the pipeline and the words themselves.
const TURN: u64 = 9;

/// What the hardware of a machine takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Timing {
    /// Of a beam machine: clocks from a pixel that is issued to its colour.
    pub latency: u32,
    /// Of a zone machine.
    pub zone: ZoneTiming,
}

/// Clocks from the first pixel of a frame to the first of the next.
/// Fails when the machine does not show the scene.
pub fn clocks_per_frame(
    machine: &MachineDescription,
    scene: &FramedScene,
    prepared: &PreparedScene,
    timing: &Timing,
) -> Result<u64> {
    match machine.machine {
        MachineKind::Beam => {
            let words = frame_words(scene, prepared, machine, &machine.fields()[0])?;
            let line = u64::from(scene.width / machine.pixels_per_clock);
            let groups = machine.modules as usize * machine.fields().len();
            let pixels = line * u64::from(scene.height) / groups as u64;
            let pace = u64::from(machine.words().clocks_per_pixel());
            Ok((pixels - 1) * pace + 1 + u64::from(timing.latency) + words.len() as u64 + TURN)
        }
        MachineKind::Zone => {
            let plan = zone_plan(scene, prepared, machine, Refinement::Box)?;
            // The tables of the shading processor are written when the last pixel has left it: one clock reads its
            // material, one takes it to the queue.
            let means = if machine.supersampling > 1 {
                accumulator::LATENCY as u64
            } else {
                0
            };
            let shading = match (machine.lit_sphere, machine.lights) {
                (Some(sphere), _) => table_latency(sphere.places(), sphere.nearest),
                (None, 0) => FLAT_LATENCY,
                (None, _) => LATENCY as u32,
            };
            let shading = u64::from(shading);
            let blends = u64::from(transparency::latency(machine.layers));
            Ok(clocks(&plan, &timing.zone).total + shading + 2 + blends + means)
        }
    }
}
