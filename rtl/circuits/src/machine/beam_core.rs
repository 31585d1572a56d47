//! The part of a beam machine that draws: from the raster to the colour of every pixel.

use super::layer::{Look, shaded_layer};
use super::pixel_count::pixel_count;
use super::{
    Lit, MATERIAL, NORMAL, Objects, SHADING, Volumes, WordBus, all_sources, object_array,
    volume_array,
};
use crate::object::Normal;
use crate::raster::Scan;
use crate::rows::numbered;
use crate::shade::{
    BLEND_LATENCY, Point, Shaded, Shading, ShadingLoad, Surface, transparency_pipeline,
};
use crate::video::LEVEL;
use imogene_contract::slots::FittedSlot;
use imogene_hdl::{Bits, Bundle, Int, Value, memory, module};

/// Bits of the number of a slot.
const SLOT: u32 = 8;

/// What a beam machine with shading is built for.
#[derive(Clone, Debug)]
pub struct BeamMachine {
    /// Its objects that are not transparent.
    pub objects: Objects,
    /// Slots of transparent objects, whose numbers follow; the first is the farthest.
    pub layers: Vec<FittedSlot>,
    /// Its shadow and light volumes, as many as they have numbers of planes; there may be none.
    pub volumes: Volumes,
    /// Its shading.
    pub shading: Shading,
    /// Address bits of the words that it keeps for the next frame.
    pub loader_places: u32,
}

impl BeamMachine {
    /// Clocks from a pixel to its colour.
    pub fn latency(&self) -> u32 {
        self.surfaces() + self.shading.latency() + BLEND_LATENCY * self.layers.len() as u32
    }

    /// Clocks from a pixel to what the shading processor of the surfaces is told of it: the layers, each a blend
    /// after the one before, are not later.
    fn surfaces(&self) -> u32 {
        let layers = (0..).step_by(BLEND_LATENCY as usize).zip(&self.layers);
        let needed = layers.map(|(late, slot)| self.objects.slot_clocks(slot).saturating_sub(late));
        needed.fold(self.decided(), u32::max)
    }

    /// Bits of its load bus: those of the widest word.
    pub fn bus(&self) -> u32 {
        let words = [self.objects.bus(), self.volumes.widths.bus()];
        words.into_iter().fold(SHADING, u32::max)
    }

    /// Clocks from a pixel to its nearest surface: not before volumes want its depth.
    fn nearest(&self) -> u32 {
        let clocks = self.objects.clocks();
        match self.volumes.planes.is_empty() {
            true => clocks,
            false => clocks.max(self.volumes.depth_offset()),
        }
    }

    /// Clocks by which the flags of the raster reach the volumes later, for the visible depth to meet them.
    fn volume_start(&self) -> u32 {
        self.nearest() - self.volumes.depth_offset()
    }

    /// Clocks from a pixel to what the shading processor is told of it.
    fn decided(&self) -> u32 {
        if self.volumes.planes.is_empty() {
            // The material is read.
            return self.nearest() + 1;
        }
        self.volume_start() + self.volumes.clocks()
    }
}

/// The colour of every pixel: a processor for each object and each volume, the decider, the shadow stage, the material
/// table, the shading processor, the blends of transparent objects. Latency [`BeamMachine::latency`].
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
        let words = ShadingLoad {
            valid: load.shading,
            address: load.address,
            data: load.data.low(SHADING),
        };
        let start = scan.delayed(machine.surfaces() - machine.decided());
        let (depth, seen) = shaded_surface(start, (take, load, words), machine);
        if machine.layers.is_empty() {
            return seen;
        }
        let depth = depth.delayed_as("shaded_depth", machine.shading.latency());
        blended(scan, (load, words), (depth, seen), machine)
    })
}

/// Transparent objects over the surfaces.
fn blended(
    scan: Scan,
    (load, words): (WordBus, ShadingLoad),
    (depth, seen): (Int, Shaded),
    machine: &BeamMachine,
) -> Shaded {
    let first = machine.objects.slots.len() as u64;
    let objects = load.objects();
    let slots = numbered("layers", &machine.layers).enumerate();
    let layers = slots.map(|(index, (at, slot))| {
        let own = first + index as u64;
        let look = Look {
            write: load.material & load.address.low(SLOT).is(own),
            data: load.data.low(MATERIAL + LEVEL),
        };
        let clocks = machine.objects.slot_clocks(slot);
        let scan = scan.delayed(machine.surfaces() + BLEND_LATENCY * index as u32 - clocks);
        shaded_layer(&at, scan, (objects.of(own), look, words), slot, machine)
    });
    let layers: Vec<_> = layers.collect();
    let wait = BLEND_LATENCY * layers.len() as u32;
    let surface = Surface {
        depth,
        red: seen.red,
        green: seen.green,
        blue: seen.blue,
    };
    let blended = transparency_pipeline("blends", surface, layers);
    Shaded {
        out_valid: seen.out_valid.delayed_as("valid_late", wait),
        red: blended.red,
        green: blended.green,
        blue: blended.blue,
    }
}

/// The depth of the surface that is seen, and behind it its colour.
fn shaded_surface(
    scan: Scan,
    (take, load, shading): (Bits, WordBus, ShadingLoad),
    machine: &BeamMachine,
) -> (Int, Shaded) {
    let words = (take, load.objects());
    let start = machine.nearest() - machine.objects.clocks();
    let (valid, seen) = object_array(
        "objects",
        scan.delayed(start),
        words,
        &machine.objects,
        false,
    );
    let own_material = load.data.low(MATERIAL);
    let write = (load.material, load.address.low(SLOT), own_material);
    let material = memory("materials", 1 << SLOT, write, seen.id.low(SLOT));
    let wait = machine.decided() - machine.nearest();
    let valid = valid.delayed_as("valid_late", wait);
    let depth = seen.depth.delayed_as("depth_late", wait);
    let material = material.delayed_as("material_late", wait - 1);
    let has_shadows = machine.shading.asks_sources() && !machine.volumes.planes.is_empty();
    let flags = match has_shadows {
        false => all_sources(),
        true => {
            let start = machine.volume_start();
            let lit = Lit {
                depth: seen.depth,
                flags_in: all_sources(),
            };
            let words = (take, load.volumes());
            volume_array("volumes", scan.delayed(start), lit, words, &machine.volumes).1
        }
    };
    let point = Point {
        valid,
        pixel: pixel_count("pixel_count", scan, machine.decided()),
        depth,
        material,
        normal: shaded_normal(seen.normal).delayed(wait),
        flags,
    };
    (depth, machine.shading.shade("shading", point, shading))
}

/// A normal in at most the words of the shading processor, to which its length means nothing.
pub(super) fn shaded_normal(normal: Normal) -> Normal {
    normal.map(|part| part.high(part.width().min(NORMAL)))
}
