//! The beam machine: one object processor per object, one pixel per clock.

use super::{Candidate, LoadBus, Zone, coefficient_store, decider, raster_control};
use crate::object::{Network, Shape, Visible, Widths, Words, quadric_processor};
use crate::raster::{Flags, Pixel};
use imogene_hdl::{Bits, Bundle, Value, bundle, module};

bundle! {
    /// The load bus of a machine.
    Load(width) {
        valid: Bits(1), "write a word";
        object: Bits(8), "slot of the object";
        address: Bits(8), "address of the word in its store";
        data: Bits(width), "the word";
    }
}

/// A place for an object.
#[derive(Clone, Copy, Debug)]
pub struct Slot {
    /// Cut planes.
    pub planes: usize,
    /// It has half B, which objects of the class front need.
    pub two_volumes: bool,
}

/// What a beam machine is built for.
#[derive(Clone, Debug)]
pub struct Beam {
    /// Bits of a depth word.
    pub depth: u32,
    /// Bits of the words of an object.
    pub widths: Widths,
    /// The root of an object.
    pub root: Network,
    /// Slots, at least one.
    pub slots: Vec<Slot>,
}

impl Slot {
    /// Clocks of its processor beyond those of one without planes and half B.
    fn more(&self) -> u32 {
        self.planes as u32 + u32::from(self.two_volumes)
    }
}

impl Beam {
    /// Clocks from the start of a zone to its first pixel: one of the raster, the longest processor, the decider.
    pub fn latency(&self) -> u32 {
        let longest = self.slots.iter().map(Slot::more).max();
        1 + self.root.latency() + 6 + longest.unwrap_or(0) + levels(self.slots.len())
    }
}

/// Levels of a tree of so many inputs.
fn levels(inputs: usize) -> u32 {
    inputs.next_power_of_two().ilog2()
}

/// A machine of stores, processors and a decider: the visible object of every pixel of a zone, one pixel a clock.
///
/// Processors with fewer stages begin later, so that all answer together. Latency [`Beam::latency`].
/// Section 7 of `docs/architecture.md`.
pub fn beam(at: &str, zone: Zone, load: Load, machine: &Beam) -> (Bits, Candidate) {
    let ((_, valid), front) = module("beam", at, (zone, ("load", load)), |(zone, (_, load))| {
        let raster = raster_control("raster", zone);
        let longest = machine.slots.iter().map(Slot::more).max().unwrap_or(0);
        let mut late: Vec<(Flags, Pixel)> = vec![(raster.flags, raster.pixel)];
        let least = machine.slots.iter().map(Slot::more).min().unwrap_or(0);
        for _ in least..longest {
            late.push(late[late.len() - 1].delayed(1));
        }
        let slots = || machine.slots.iter().enumerate();
        let words: Vec<Words> = slots()
            .map(|(index, slot)| {
                let bus = LoadBus {
                    write: load.valid & load.object.is(index as u64),
                    address: load.address,
                    data: load.data,
                };
                coefficient_store(
                    &format!("stores_{index}"),
                    bus,
                    machine.widths,
                    slot.planes as u64,
                )
            })
            .collect();
        let visible: Vec<Visible> = slots()
            .zip(words)
            .map(|((index, slot), words)| {
                let (flags, pixel) = late[(longest - slot.more()) as usize];
                let shape = Shape {
                    depth: machine.depth,
                    root: machine.root,
                    two_volumes: slot.two_volumes,
                };
                quadric_processor(&format!("processors_{index}"), flags, pixel, words, shape)
            })
            .collect();
        let candidate = |(index, visible): (usize, &Visible)| Candidate {
            depth: visible.front.zf,
            id: Bits::new(index as u64, 8),
            number: visible.front.number,
            normal: visible.normal,
        };
        let candidates = visible.iter().enumerate().map(candidate).collect();
        let valid = visible[0].front.out_valid;
        let valid = valid.delayed_as("valid_late", levels(machine.slots.len()));
        (("valid", valid), decider("decider", candidates))
    });
    (valid, front)
}
