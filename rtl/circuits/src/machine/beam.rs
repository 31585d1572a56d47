//! The beam machine: one object processor per object, one pixel per clock.

use super::decider::NEAREST;
use super::{Candidate, Load, Objects, Zone, raster_control};
use imogene_hdl::{Bits, module};

/// Bits of the id of an object.
const ID: u32 = 8;

/// A beam machine is built for its objects.
pub type Beam = Objects;

impl Beam {
    /// Clocks from the start of a zone to its first pixel: one of the raster, and those of the objects.
    pub fn latency(&self) -> u32 {
        1 + self.clocks()
    }
}

/// A machine of stores, processors and a decider: the visible object of every pixel of a zone, one pixel a clock.
/// Latency [`Beam::latency`]. Section 7 of `docs/architecture.md`.
pub fn beam(at: &str, zone: Zone, load: Load, machine: &Beam) -> (Bits, Candidate) {
    let inputs = (zone, ("load", load));
    module("beam", at, inputs, |(zone, load)| {
        let raster = raster_control("raster", zone);
        let nearest = machine.nearest(raster.scan, |slot| load.of(slot), ID, None);
        let (valid, nearest) = nearest.alone();
        let valid = ("valid", valid, "this clock carries a pixel");
        (valid, ("", nearest, NEAREST))
    })
}
