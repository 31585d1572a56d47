//! The part of a beam machine that draws: from the raster to the colour of every pixel.

use super::{
    Lit, MATERIAL, NORMAL, Objects, SHADING, Volumes, WordBus, all_sources, object_array,
    volume_array,
};
use crate::object::Normal;
use crate::raster::Scan;
use crate::shade::{Point, Shaded, ShadingLoad, shading_processor};
use imogene_contract::shading;
use imogene_hdl::{Bits, Bundle, Value, memory, module};

/// Bits of the number of a slot.
const SLOT: u32 = 8;

/// What a beam machine with shading is built for.
#[derive(Clone, Debug)]
pub struct BeamMachine {
    /// Its objects.
    pub objects: Objects,
    /// Its shadow and light volumes, as many as they have numbers of planes; there may be none.
    pub volumes: Volumes,
    /// Its lights.
    pub lights: u64,
    /// Address bits of the words that it keeps for the next frame.
    pub loader_places: u32,
}

impl BeamMachine {
    /// Clocks from a pixel to its colour.
    pub fn latency(&self) -> u32 {
        self.decided() + shading::LATENCY as u32
    }

    /// Bits of its load bus: those of the widest word.
    pub fn bus(&self) -> u32 {
        let words = [self.objects.widths.bus(), self.volumes.widths.bus()];
        words.into_iter().fold(SHADING, u32::max)
    }

    /// Clocks by which the flags of the raster reach the volumes later, for the visible depth to meet them.
    fn volume_start(&self) -> u32 {
        self.objects.clocks() - self.volumes.depth_offset()
    }

    /// Clocks from a pixel to what the shading processor is told of it.
    fn decided(&self) -> u32 {
        if self.volumes.planes.is_empty() {
            // The material is read.
            return self.objects.clocks() + 1;
        }
        self.volume_start() + self.volumes.clocks()
    }
}

/// The colour of every pixel: a processor for each object and each volume, the decider, the shadow stage, the material
/// table, the shading processor. Latency [`BeamMachine::latency`].
///
/// The id of an object is its slot. The words of an object stay until they are written again; a volume takes part if
/// its control word was written between the last two `take`.
pub fn beam_core(
    at: &str,
    scan: Scan,
    (take, load): (Bits, WordBus),
    machine: &BeamMachine,
) -> Shaded {
    let inputs = (scan, ("load", load), ("take", take));
    module("beam_core", at, inputs, |(scan, load, take)| {
        let words = (take, load.objects());
        let (valid, seen) = object_array("objects", scan, words, &machine.objects, false);
        let own_material = load.data.low(MATERIAL);
        let write = (load.material, load.address.low(SLOT), own_material);
        let material = memory("materials", 1 << SLOT, write, seen.id.low(SLOT));
        let flags = match machine.volumes.planes.len() {
            0 => all_sources(),
            _ => {
                let start = machine.volume_start();
                let lit = Lit {
                    depth: seen.depth,
                    flags_in: all_sources(),
                };
                let words = (take, load.volumes());
                volume_array("volumes", scan.delayed(start), lit, words, &machine.volumes).1
            }
        };
        let wait = machine.decided() - machine.objects.clocks();
        let point = Point {
            valid: valid.delayed_as("valid_late", wait),
            pixel: scan.pixel.delayed(machine.decided()),
            depth: seen.depth.delayed_as("depth_late", wait),
            material: material.delayed_as("material_late", wait - 1),
            normal: shaded_normal(seen.normal).delayed(wait),
            flags,
        };
        let words = ShadingLoad {
            valid: load.shading,
            address: load.address,
            data: load.data.low(SHADING),
        };
        shading_processor("shading", point, words, machine.lights)
    })
}

/// A normal in the words of the shading processor, to which its length means nothing.
pub(super) fn shaded_normal(normal: Normal) -> Normal {
    normal.map(|part| part.high(part.width().min(NORMAL)).extend(NORMAL))
}
