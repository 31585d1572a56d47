//! How clocks and beats of a frame grow with the size of the zones and the number of processors.

use super::clocks::{FrameClocks, ZoneTiming, clocks};
use super::error::Result;
use super::plan::ZonePlan;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_prepare::PreparedScene;
use serde::Serialize;

/// Sides of square zones.
pub const ZONE_SIDES: [u32; 5] = [8, 16, 32, 64, 128];
/// Numbers of object processors.
pub const OBJECT_PROCESSORS: [usize; 5] = [1, 2, 4, 8, 16];

/// One machine and its frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Growth {
    /// Side of the zones.
    pub side: u32,
    /// Object processors of all kinds, those of products not counted.
    pub object_processors: usize,
    /// Volume processors.
    pub volume_processors: usize,
    /// Greatest number of parts in one zone.
    pub most_parts: usize,
    /// Parts of all zones: each part counts once for each zone that it touches.
    pub parts: u64,
    /// Volumes of all zones, likewise.
    pub volumes: u64,
    /// Clocks and beats.
    pub clocks: FrameClocks,
}

/// The frames of a scene on machines that differ from `machine` in the side of their square zones and the number of
/// their object processors of each kind; there are as many volume processors as it has.
pub fn growth(
    scene: &PreparedScene,
    machine: &ZoneMachine,
    timing: &ZoneTiming,
    sides: &[u32],
    object_processors: &[usize],
) -> Result<Vec<Growth>> {
    let mut rows = vec![];
    for &side in sides {
        let machine = ZoneMachine {
            zone_width: side,
            zone_height: side,
            ..machine.clone()
        };
        let mut plan = ZonePlan::of(scene, machine)?;
        for &number in object_processors {
            plan.machine = plan.machine.with_processors(number);
            plan.machine.check()?;
            rows.push(Growth::of(&plan, timing));
        }
    }
    Ok(rows)
}

impl Growth {
    fn of(plan: &ZonePlan, timing: &ZoneTiming) -> Growth {
        let parts = plan.zones.iter().map(|zone| zone.all_parts().count());
        let volumes = plan.zones.iter().map(|zone| zone.volumes.len());
        Growth {
            side: plan.machine.zone_width,
            object_processors: plan.machine.alone(),
            volume_processors: plan.machine.volume_processors,
            most_parts: parts.clone().max().unwrap_or(0),
            parts: parts.sum::<usize>() as u64,
            volumes: volumes.sum::<usize>() as u64,
            clocks: clocks(plan, timing),
        }
    }
}
