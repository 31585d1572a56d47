//! Co-simulation of a machine that is fitted to a scene.

use super::{Bands, CosimError, Options, fitted_to, quadric_words};
use crate::engine::beam::BeamDesign;
use crate::engine::design::{DesignError, Simulator};
use crate::engine::{Engine, MachineOutputs, slots_of};
use crate::report::Report;
use imogene_golden::machine::fitted::FittedMachine;
use imogene_golden::machine::frame::Frame;
use imogene_prepare::PreparedScene;
use imogene_rtl::emit::Emitted;
use imogene_rtl::emit::machine::MachineRequest;

/// The request for the hardware of a machine; `command` is stated in the header of its Verilog.
pub fn request(machine: &FittedMachine, command: &str) -> MachineRequest {
    let (words, slots) = (machine.widths, slots_of(&machine.slots));
    MachineRequest {
        command: command.to_owned(),
        ..MachineRequest::fitted(words, machine.rows_per_stage as usize, slots)
    }
}

/// Compiles the emitted Verilog of a machine for a simulator.
///
/// # Errors
///
/// When a tool is missing, or a file cannot be written.
pub fn compile(
    simulator: Simulator,
    machine: &FittedMachine,
    emitted: &Emitted,
) -> Result<BeamDesign, DesignError> {
    BeamDesign::of(simulator, emitted, MachineOutputs::signals(&machine.widths))
}

/// Runs a scene through machines that `engine` makes, and compares with the golden machine; `scene` was prepared in the
/// machine's words.
///
/// # Errors
///
/// When an object is not drawn by a quadric processor, or a trace cannot be written.
pub fn run<E: Engine>(
    scene: &PreparedScene,
    machine: &FittedMachine,
    options: &Options,
    engine: impl Fn() -> E + Sync,
    pixel_done: impl Fn() + Sync,
) -> Result<(Report, Frame), CosimError> {
    let words = quadric_words(scene)?;
    let planes: Vec<usize> = machine.slots.iter().map(|s| s.planes as usize).collect();
    let bands = Bands {
        scene,
        words: fitted_to(&words, &planes),
        outputs: MachineOutputs::signals(&machine.widths),
        latency: machine.latency(&scene.format) as usize,
        options,
    };
    bands.run(engine, pixel_done)
}
