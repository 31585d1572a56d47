//! Zone machine: from the command stream to shaded pixels.

use super::layer::{Around, Look, Transparent, shaded_layer, shaded_normal};
use super::{
    Ahead, Beat, COORDINATE, Coloured, ID, MATERIAL, MEAN_LATENCY, Objects, SHADING, SamplePass,
    Shown, ZoneCore, sample_mean, zone_core,
};
use crate::raster::Pixel;
use crate::rows::numbered;
use crate::shade::{
    BLEND_LATENCY, Layer, Point, Shaded, Shading, ShadingLoad, Surface, transparency_pipeline,
};
use crate::video::{LEVEL, PixelStream, Queue, pixel_fifo};
use imogene_contract::command_stream::OBJECT_ID;
use imogene_contract::slots::FittedSlot;
use imogene_hdl::{Bits, Bundle, Int, Value, join, memory, module, net};

/// Clocks from a pixel that is issued to what the shading is told of it, without transparent objects.
const SEEN: u32 = 3;
/// Bits of the place of a pixel in the queue behind its shading, at least.
const QUEUE: u32 = 6;

/// What a zone machine is built for.
#[derive(Clone, Debug)]
pub struct ZoneMachine {
    /// The part that decides.
    pub core: ZoneCore,
    /// Slots of transparent objects, whose numbers follow those of the others; the first is the farthest.
    pub layers: Vec<FittedSlot>,
    /// Samples of a pixel along each side: 1, 2 or 4.
    pub samples: u32,
    /// Its shading.
    pub shading: Shading,
}

impl ZoneMachine {
    /// Bits of the data of a beat: those of the load bus of its processors, and of a word of the shading processor.
    pub fn bus(&self) -> u32 {
        let layers = self.core.objects.bus_of(&self.layers);
        self.core.bus().max(layers).max(SHADING)
    }

    /// Clocks by which transparent objects know a pixel of a showing pass before its surface is read: each is blended
    /// after the one before, and the surface has three clocks to the shading.
    pub fn ahead(objects: &Objects, layers: &[FittedSlot]) -> Option<u32> {
        let clocks = layers.iter().zip((SEEN..).step_by(BLEND_LATENCY as usize));
        let ahead = clocks.map(|(slot, late)| objects.slot_clocks(slot).saturating_sub(late));
        ahead.max()
    }

    /// Clocks from a pixel of the core to its colour: one reads its material.
    fn shaded(&self) -> u32 {
        1 + self.shading.latency() + BLEND_LATENCY * self.layers.len() as u32
    }

    /// Clocks from a pixel of the core until it is in the queue.
    fn drain(&self) -> u32 {
        self.shaded() + 1 + if self.samples > 1 { MEAN_LATENCY } else { 0 }
    }
}

/// Draws scenes of any number of objects with a few processors, zone by zone, and shades what is visible; with it
/// whether a beat is taken. Beats have data of [`ZoneMachine::bus`] bits.
///
/// With 2 or 4 samples the means of 2 x 2 or 4 x 4 samples leave, after the last pass over a zone. Pixels leave in the
/// order of the zones, line by line in each. While the receiver stalls, the showing pass waits; drawing goes on.
/// `docs/zone-machine.md`.
pub fn zone_machine(
    at: &str,
    beat: Beat,
    ready: Bits,
    machine: &ZoneMachine,
) -> (Bits, PixelStream) {
    let inputs = (("s", beat), ("m_tready", ready));
    module("zone_machine", at, inputs, |(beat, ready)| {
        let room = Bits::forward(1);
        let seen = zone_core("core", beat, room, &machine.core, machine.drain());
        let shaded = shaded(&seen, machine);
        let is_last = seen.sample.bit(1);
        let (shown, started) = match machine.samples {
            1 => (shaded, seen.started),
            _ => (mean(&seen, shaded, machine), seen.started & is_last),
        };
        let queue = Queue {
            started,
            push: shown.valid,
            data: join([shown.place, shown.colour.packed()]),
            last: shown.last,
            m_tready: ready,
        };
        let flight = machine.drain() + 1 + machine.core.ahead.unwrap_or(0);
        let places = (flight + 5).next_power_of_two().ilog2().max(QUEUE);
        let queued = pixel_fifo("queue", queue, places, flight);
        room.drive(match machine.samples {
            1 => queued.room,
            // Samples before the last pass stay with their sums and want no room.
            _ => queued.room | !is_last,
        });
        let pixels = PixelStream {
            tvalid: queued.m_tvalid,
            tdata: queued.m_tdata.low(3 * LEVEL),
            tuser: queued.m_tdata.high(2 * COORDINATE),
            tlast: queued.m_tlast,
        };
        (("s_tready", seen.ready), ("m", pixels))
    })
}

/// The pixels of a core with their colours. The material of an object is a clock later than the object.
fn shaded(seen: &Shown, machine: &ZoneMachine) -> Coloured {
    let (load, surface, place) = (seen.load, seen.surface, seen.pixel);
    net! {
        let object = load.address.low(ID);
        let number = load.data.low(MATERIAL);
        let material = memory("materials", 1 << ID, (load.material, object, number), surface.id);
    }
    // The processors count pixels, the shading processor samples.
    let sample = |place: Bits, low: u32| match machine.samples {
        1 => place,
        samples => place.left(samples.ilog2()) | seen.sample.slice(low + 1, low).extend(COORDINATE),
    };
    let pixel = Pixel::of([sample(place.x, 2), sample(place.y, 4)]);
    net! {
        // Between pixels the words of the last one stay, so that what reads no material stands still. A gate behind the
        // memory of materials would be on the slowest path.
        let valid_late = seen.valid.reg();
        let depth_late = surface.depth.reg_when(seen.valid);
        let flags_late = seen.flags.reg_when(seen.valid);
    }
    let point = Point {
        valid: valid_late,
        pixel: pixel.registered_when(seen.valid),
        depth: depth_late,
        material,
        normal: shaded_normal(surface.normal).registered_when(seen.valid),
        flags: flags_late,
    };
    // Words come long before the pixels of their pass, and their wires are the longest of the machine.
    let load = ShadingLoad {
        valid: load.shading,
        address: load.address,
        data: load.data.low(SHADING),
    }
    .registered();
    let (pixel, depth) = (point.pixel, point.depth);
    let shaded = machine.shading.shade("shading", point, load);
    let late = machine.shaded();
    let shaded = match &seen.ahead {
        None => shaded,
        Some(ahead) => blended(ahead, (pixel, load), (depth, shaded), machine),
    };
    Coloured {
        valid: shaded.out_valid,
        colour: shaded.colour(),
        place: join([place.y, place.x]).delayed_as("place_late", late),
        last: seen.frame_ends.delayed_as("last_late", late),
    }
}

/// Transparent objects over the surfaces, whose depths are known with their pixels, before their colours.
fn blended(
    ahead: &Ahead,
    (mut pixel, load): (Pixel, ShadingLoad),
    (depth, shaded): (Int, Shaded),
    machine: &ZoneMachine,
) -> Shaded {
    let objects = &machine.core.objects;
    let around = Around {
        objects,
        shading: &machine.shading,
    };
    let buses = ahead.load.objects();
    let first = objects.slots.len() as u64;
    let slots = numbered("layers", &machine.layers).enumerate();
    let layers = slots.map(|(index, (at, slot))| {
        if index > 0 {
            pixel = pixel.delayed(BLEND_LATENCY);
        }
        let bus = buses.of(first + index as u64).registered();
        let start = SEEN + machine.core.ahead.unwrap_or(0) + BLEND_LATENCY * index as u32;
        let object = Transparent {
            scan: ahead.scan.delayed(start - objects.slot_clocks(slot)),
            pixel,
            object: bus,
            look: Look {
                write: bus.writes(OBJECT_ID.into()),
                data: bus.data.slice(ID + MATERIAL + LEVEL - 1, ID),
            },
            load,
            take: Some(ahead.take),
        };
        shaded_layer(&at, object, slot, &around).alone()
    });
    let layers: Vec<Layer> = layers.collect();
    let depth = depth.delayed_as("shaded_depth", machine.shading.latency());
    let surface = Surface::of(depth, &shaded);
    let wait = BLEND_LATENCY * machine.layers.len() as u32;
    let blended = transparency_pipeline("blends", surface, layers);
    blended.shaded(shaded.out_valid.delayed_as("valid_late", wait))
}

/// The pixels of the last pass, each with the mean of its samples.
fn mean(seen: &Shown, shaded: Coloured, machine: &ZoneMachine) -> Coloured {
    let late = |name: &str, flag: Bits| flag.delayed_as(name, machine.shaded());
    let pass = SamplePass {
        first_pass: late("first_pass_late", seen.sample.bit(0)),
        last_pass: late("last_pass_late", seen.sample.bit(1)),
        pass_ends: late("pass_ends_late", seen.pass_ends),
    };
    sample_mean("means", pass, shaded, machine.samples, machine.core.places)
}
