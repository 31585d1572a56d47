//! Hardware of any widths, for the commands that need it.

use crate::arguments::{Fitted, option};
use crate::failure::{Failure, Result};
use crate::output;
use imogene_contract::slots;
use imogene_contract::{Request, Unit};
use imogene_golden::widths;
use imogene_plan::description::MachineDescription;
use imogene_rtl::emit::Emitted;
use imogene_rtl::emit::machine::{MachineRequest, emit_machine};
use imogene_synth::Target;
use imogene_synth::fitted::estimate::estimated_costs;
use imogene_synth::fitted::{MachineCost, Parts, machine_costs};
use imogene_verif::display::request::request_for;
use std::collections::BTreeSet;
use std::path::Path;

/// The deciding part of the widths and slots asked for, if any are.
pub fn asked(
    options: &Fitted,
    request: &Request,
    prefix: Option<&str>,
) -> Result<Option<MachineRequest>> {
    let (Some(words), Some(slots)) = (options.widths, &options.slots) else {
        return Ok(None);
    };
    if request.unit != Unit::Beam {
        return Err(Failure::Input(format!(
            "--widths takes the unit beam, not {}: only whole machines are fitted to scenes",
            request.unit.name()
        )));
    }
    let named = option("prefix", prefix);
    let command = format!(
        "imogene emit beam --widths {} --slots {} --rows-per-stage {}{named} --out DIR",
        widths::print(&words),
        slots::print(slots),
        request.rows_per_stage
    );
    Ok(Some(MachineRequest {
        prefix: prefix.unwrap_or_default().to_owned(),
        command,
        ..MachineRequest::fitted(words, request.rows_per_stage as usize, slots.clone())
    }))
}

/// The machine of a description, whatever it is loaded with.
pub fn described(file: &Path, prefix: Option<&str>) -> Result<MachineRequest> {
    let machine = MachineDescription::read(file)?;
    let named = option("prefix", prefix);
    let command = format!("imogene emit --machine {}{named} --out DIR", file.display());
    Ok(MachineRequest {
        prefix: prefix.unwrap_or_default().to_owned(),
        ..request_for(&machine, &[], &command)
    })
}

/// What whole machines cost, estimated from those of `known` ones that have as many rows to a stage.
pub fn estimates(
    known: &[MachineDescription],
    machines: &[MachineDescription],
    target: Target,
) -> Result<Vec<MachineCost>> {
    let alike = |machines: &[MachineDescription], rows: u32| {
        emitted(machines.iter().filter(|m| m.rows_per_stage == rows))
    };
    let rows: BTreeSet<u32> = machines.iter().map(|m| m.rows_per_stage).collect();
    let mut costs = vec![MachineCost::default(); machines.len()];
    for rows in rows {
        let (known, wanted) = (alike(known, rows)?, alike(machines, rows)?);
        let found = estimated_costs(&known, &wanted, Parts::Units, target, &|_, _| ())?;
        let places = costs.iter_mut().zip(machines);
        let places = places.filter(|(_, m)| m.rows_per_stage == rows);
        for ((cost, _), found) in places.zip(found) {
            *cost = found;
        }
    }
    Ok(costs)
}

/// The hardware of whole machines.
pub fn emitted<'a>(
    machines: impl IntoIterator<Item = &'a MachineDescription>,
) -> Result<Vec<Emitted>> {
    let machines = machines.into_iter();
    let emitted = machines.map(|machine| emit_machine(&request_for(machine, &[], "")));
    Ok(emitted.collect::<Result<_, _>>()?)
}

/// What whole machines cost on a target as sums of such parts, in their order; with the clock of their slowest unit if
/// it is asked for.
pub fn costs(
    emitted: &[Emitted],
    parts: Parts,
    target: Target,
    with_clock: bool,
) -> Result<Vec<MachineCost>> {
    let costs = output::during(0, "modules and clocks", |bar| {
        let done = |known, of| {
            bar.set_length(of as u64);
            bar.set_position(known as u64);
        };
        machine_costs(emitted, parts, target, with_clock, &done)
    });
    Ok(costs?)
}
