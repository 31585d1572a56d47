//! The part of a beam machine that draws: from the raster to the colour of every pixel.

use super::layer::{Around, Look, Transparent, shaded_layer, shaded_normal};
use super::pixel_count::pixel_count;
use super::{
    Lit, MATERIAL, Objects, SHADING, Surface, Volumes, WordBus, all_sources, object_array,
    volume_array,
};
use crate::raster::{COORDINATE, Pixel, Scan, lane_pixel, lanes_latency};
use crate::rows::{PerLane, in_lane, numbered};
use crate::shade::{
    self, BLEND_LATENCY, Point, Shaded, Shading, ShadingLoad, transparency_pipeline,
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
    /// Graphics modules, a power of two: of n modules each draws every n-th line.
    pub modules: u32,
    /// The lines of a module or field are `2^(1 + n)` apart; 0 where they are not apart.
    pub line_shift: u32,
}

impl BeamMachine {
    /// The pixel that a shading processor is told of: what counts lines by two counts them by so many.
    pub(super) fn shaded_pixel(&self, scan: Scan, clocks: u32, at: &str) -> Pixel {
        let pixel = pixel_count(at, scan, clocks);
        Pixel {
            y: pixel.y.left(self.line_shift).low(COORDINATE),
            ..pixel
        }
    }

    /// Clocks from a pixel to its colour.
    pub fn latency(&self) -> u32 {
        self.surfaces() + self.shading.latency() + BLEND_LATENCY * self.layers.len() as u32
    }

    /// Clocks from a pixel to what the shading processor of the surfaces is told of it: the layers, each a blend
    /// after the one before, are not later.
    fn surfaces(&self) -> u32 {
        let layers = (0..).step_by(BLEND_LATENCY as usize).zip(&self.layers);
        let needed = layers.map(|(late, slot)| self.layer_clocks(slot).saturating_sub(late));
        needed.fold(self.decided(), u32::max)
    }

    /// Clocks from the flags of a pixel to what is seen of a transparent object.
    pub(super) fn layer_clocks(&self, slot: &FittedSlot) -> u32 {
        lanes_latency(self.objects.lanes) + self.objects.slot_clocks(slot)
    }

    /// Fewest clocks of a line: the words of lanes change when the next one begins, and all processors have to have
    /// begun before.
    pub fn least_line(&self) -> u32 {
        if self.objects.lanes == 1 {
            return 1;
        }
        let slots = self.objects.slots.iter().chain(&self.layers);
        let slots = slots.map(|slot| self.layer_clocks(slot));
        let volumes = self.volumes.planes.iter();
        let volumes = volumes.map(|_| self.volumes.flags_offset());
        slots.chain(volumes).max().expect("a slot")
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

/// The colour of every pixel of each lane: a processor for each object and each volume, the decider, the shadow stage,
/// the material table, the shading processor, the blends of transparent objects. Latency [`BeamMachine::latency`].
///
/// The id of an object is its slot. The words of an object stay until they are written again; a volume takes part if
/// its control word was written between the last two `take`.
pub fn beam_core(
    at: &str,
    scan: Scan,
    (take, load): (Bits, WordBus),
    machine: &BeamMachine,
) -> PerLane<Shaded> {
    let inputs = (scan, ("load", load), ("take", take));
    module("beam_core", at, inputs, |(scan, load, take)| {
        let words = ShadingLoad {
            valid: load.shading,
            address: load.address,
            data: load.data.low(SHADING),
        };
        let start = scan.delayed(machine.surfaces() - machine.decided());
        let seen = shaded_surface(start, (take, load, words), machine);
        if machine.layers.is_empty() {
            return seen.map(|(_, seen)| seen);
        }
        let late = |depth: Int| depth.delayed_as("shaded_depth", machine.shading.latency());
        let seen = seen.map(|(depth, seen)| (late(depth), seen));
        blended(scan, (load, words), seen, machine)
    })
}

/// Transparent objects over the surfaces.
fn blended(
    scan: Scan,
    (load, words): (WordBus, ShadingLoad),
    seen: PerLane<(Int, Shaded)>,
    machine: &BeamMachine,
) -> PerLane<Shaded> {
    let first = machine.objects.slots.len() as u64;
    let objects = load.objects();
    let around = Around {
        objects: &machine.objects,
        shading: &machine.shading,
    };
    let mut pixel = machine.shaded_pixel(scan, machine.surfaces(), "layer_pixels");
    let slots = numbered("layers", &machine.layers).enumerate();
    let layers = slots.map(|(index, (at, slot))| {
        let own = first + index as u64;
        if index > 0 {
            pixel = pixel.delayed(BLEND_LATENCY);
        }
        let start = machine.surfaces() + BLEND_LATENCY * index as u32;
        let object = Transparent {
            scan: scan.delayed(start - machine.layer_clocks(slot)),
            pixel,
            object: objects.of(own),
            look: Look {
                write: load.material & load.address.low(SLOT).is(own),
                data: load.data.low(MATERIAL + LEVEL),
            },
            load: words,
            take: None,
        };
        shaded_layer(&at, object, slot, &around)
    });
    let layers: Vec<_> = layers.collect();
    let wait = BLEND_LATENCY * layers.len() as u32;
    let lanes = machine.objects.lanes;
    PerLane::of(lanes, |lane| {
        let (depth, seen) = &seen.0[lane as usize];
        let layers = layers.iter().map(|layer| layer.0[lane as usize].clone());
        let at = in_lane("blends", lane, lanes);
        let surface = shade::Surface::of(*depth, seen);
        let blended = transparency_pipeline(&at, surface, layers.collect());
        blended.shaded(seen.out_valid.delayed_as("valid_late", wait))
    })
}

/// In each lane the depth of the surface that is seen, and behind it its colour.
fn shaded_surface(
    scan: Scan,
    (take, load, shading): (Bits, WordBus, ShadingLoad),
    machine: &BeamMachine,
) -> PerLane<(Int, Shaded)> {
    let words = (take, load.objects());
    let start = machine.nearest() - machine.objects.clocks();
    let late = scan.delayed(start);
    let seen = object_array("objects", late, words, &machine.objects, false);
    let flags = flags(scan, take, load, &seen, machine);
    let own_material = load.data.low(MATERIAL);
    let write = (load.material, load.address.low(SLOT), own_material);
    let wait = machine.decided() - machine.nearest();
    let pixel = machine.shaded_pixel(scan, machine.decided(), "pixel_count");
    let lanes = machine.objects.lanes;
    PerLane::of(lanes, |lane| {
        let (valid, seen) = seen.0[lane as usize];
        let at = |part: &str| in_lane(part, lane, lanes);
        let material = memory(&at("materials"), 1 << SLOT, write, seen.id.low(SLOT));
        let depth = seen.depth.delayed_as("depth_late", wait);
        let point = Point {
            valid: valid.delayed_as("valid_late", wait),
            pixel: lane_pixel(pixel, lane, lanes),
            depth,
            material: material.delayed_as("material_late", wait - 1),
            normal: shaded_normal(seen.normal).delayed(wait),
            flags: flags[lane as usize],
        };
        (depth, machine.shading.shade(&at("shading"), point, shading))
    })
}

/// The flags of the sources that reach what is seen in each lane.
fn flags(
    scan: Scan,
    take: Bits,
    load: WordBus,
    seen: &PerLane<(Bits, Surface)>,
    machine: &BeamMachine,
) -> Vec<Bits> {
    let has_shadows = machine.shading.asks_sources() && !machine.volumes.planes.is_empty();
    if !has_shadows {
        return seen.0.iter().map(|_| all_sources()).collect();
    }
    let lit = seen.0.iter().map(|(_, seen)| Lit {
        depth: seen.depth,
        flags_in: all_sources(),
    });
    let words = (take, load.volumes());
    let scan = scan.delayed(machine.volume_start());
    let lit = PerLane(lit.collect());
    let lit = volume_array("volumes", scan, lit, words, &machine.volumes);
    lit.0.into_iter().map(|(_, flags)| flags).collect()
}
