//! The machine of a point, which streams its pictures as fast as they are taken.

use super::design::{Design, Zones};
use crate::fit::machine::smallest;
use imogene_contract::MachineWords;
use imogene_plan::description::{MachineDescription, MachineKind, Output, ZoneSize};
use imogene_plan::needs::{enough, narrowed};
use imogene_prepare::PreparedScene;
use imogene_scene::FramedScene;

/// The smallest machine of these words and this form that shows the scene; or why there is none.
pub fn machine(
    design: &Design,
    widths: &MachineWords,
    scene: &FramedScene,
    prepared: &PreparedScene,
) -> Result<MachineDescription, String> {
    let samples = design.accuracy.supersampling;
    let size = (scene.width / samples, scene.height / samples);
    let frames = std::slice::from_ref(prepared);
    let beam = MachineDescription {
        output: Output::Stream,
        ..smallest(widths, frames, design.rows_per_stage, size)
    };
    let beam = match design.accuracy.tables() {
        None => beam,
        Some(form) => beam.lit_by_tables(form),
    };
    let asked = match design.zones {
        Some(Zones { processors, side }) => MachineDescription {
            machine: MachineKind::Zone,
            objects: processors,
            slots: None,
            zone: Some(ZoneSize {
                width: side,
                height: side,
            }),
            supersampling: samples,
            ..beam
        },
        None if design.accuracy.catalogue => MachineDescription {
            slots: None,
            ..beam
        },
        None => beam,
    };
    let scenes = [(scene, prepared)];
    let found = enough(&asked, &scenes).map_err(|e| e.to_string())?;
    if found.machine != asked.machine {
        return Err("more objects or volumes than a beam machine has processors".into());
    }
    let has_own = found.machine == MachineKind::Beam && !design.accuracy.catalogue;
    let found = match has_own {
        true => narrowed(&found, &scenes).map_err(|e| e.to_string())?,
        false => found,
    };
    found.check("its machine").map_err(|e| e.to_string())?;
    Ok(found)
}
