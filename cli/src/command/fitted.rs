//! Hardware of any widths, for the commands that need it.

use crate::arguments::Fitted;
use crate::failure::Failure;
use crate::output;
use imogene_contract::{Request, Unit};
use imogene_golden::machine::fitted::FittedMachine;
use imogene_rtl::emit::Emitted;
use imogene_rtl::emit::machine::{MachineRequest, emit_machine};
use imogene_synth::Target;
use imogene_synth::fitted::{MachineCost, machine_costs};
use imogene_verif::scene::request;

/// The machine of the widths and slots asked for, if any are.
pub fn asked(options: &Fitted, request: &Request) -> Result<Option<FittedMachine>, Failure> {
    let (Some(widths), Some(slots)) = (options.widths, &options.slots) else {
        return Ok(None);
    };
    if request.unit != Unit::Beam {
        return Err(Failure::Input(format!(
            "--widths takes the unit beam, not {}: only whole machines are fitted to scenes",
            request.unit.name()
        )));
    }
    Ok(Some(FittedMachine {
        widths,
        rows_per_stage: request.rows_per_stage,
        slots: slots.clone(),
    }))
}

pub fn emit(machine: &FittedMachine, prefix: Option<&str>) -> Result<Emitted, Failure> {
    emit_machine(&request_of(machine, prefix)).map_err(Failure::from)
}

fn request_of(machine: &FittedMachine, prefix: Option<&str>) -> MachineRequest {
    let prefix = prefix.unwrap_or_default();
    let mut command = machine.command();
    if !prefix.is_empty() {
        command = command.replace(" --out", &format!(" --prefix {prefix} --out"));
    }
    MachineRequest {
        prefix: prefix.to_owned(),
        ..request(machine, &command)
    }
}

/// What machines cost on a target, in their order; with the clock of their slowest unit if it is asked for.
pub fn costs(
    machines: &[FittedMachine],
    target: Target,
    with_clock: bool,
) -> Result<Vec<MachineCost>, Failure> {
    let emitted: Result<Vec<Emitted>, Failure> = machines.iter().map(|m| emit(m, None)).collect();
    costs_of(&emitted?, target, with_clock)
}

/// The same of emitted machines.
pub fn costs_of(
    emitted: &[Emitted],
    target: Target,
    with_clock: bool,
) -> Result<Vec<MachineCost>, Failure> {
    let bar = output::progress(0, "modules in synthesis");
    let done = |known, of| {
        bar.set_length(of as u64);
        bar.set_position(known as u64);
    };
    let costs = machine_costs(emitted, target, with_clock, &done).map_err(Failure::from);
    bar.finish_and_clear();
    costs
}
