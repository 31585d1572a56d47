//! Co-simulation of a machine that is fitted to a scene.

use super::{Bands, CosimError, Options, fitted_to, quadric_words};
use crate::engine::beam::BeamDesign;
use crate::engine::design::DesignError;
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

/// Compiles a machine; a simulator runs what was emitted of it.
///
/// # Errors
///
/// When a tool is missing, or a file cannot be written.
pub fn compile(
    engine: Engine,
    machine: &FittedMachine,
    emitted: &Emitted,
) -> Result<BeamDesign, DesignError> {
    let outputs = MachineOutputs::signals(&machine.widths);
    match engine {
        Engine::BuiltIn => BeamDesign::built_in(&request(machine, ""), outputs, vec![]),
        Engine::Verilog(simulator) => BeamDesign::emitted(simulator, emitted, outputs),
    }
}

/// Runs a scene through a machine, and compares with the golden machine; `scene` was prepared in the machine's words.
///
/// # Errors
///
/// When an object is not drawn by a quadric processor.
pub fn run(
    scene: &PreparedScene,
    machine: &FittedMachine,
    options: &Options,
    design: &BeamDesign,
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
    Ok(bands.run(design, pixel_done))
}
