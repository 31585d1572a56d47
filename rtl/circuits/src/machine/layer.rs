//! A transparent object of a beam machine: its processor, its material and its own shading.

use super::beam_core::shaded_normal;
use super::pixel_count::pixel_count;
use super::slot::{Lanes, Place, processor};
use super::{BeamMachine, LoadBus, MATERIAL, all_sources};
use crate::raster::{Scan, lane_pixel, lane_scans, lanes_latency};
use crate::rows::{PerLane, in_lane};
use crate::shade::{Layer, Point, ShadingLoad, Surface};
use crate::video::LEVEL;
use imogene_contract::slots::FittedSlot;
use imogene_hdl::{Bundle, Value, bundle, module};

bundle! {
    /// The word that says how a transparent object looks.
    Look(width) {
        write: Bits(1), "write it";
        data: Bits(width), "bits 7..0 number of the material, 15..8 its part of what is seen, in 255ths";
    }
}

/// The surface of a transparent object at every pixel of each lane, lit by all sources. Latency that of its processor
/// and of the shading.
pub(super) fn shaded_layer(
    at: &str,
    scan: Scan,
    (bus, look, load): (LoadBus, Look, ShadingLoad),
    slot: &FittedSlot,
    machine: &BeamMachine,
) -> PerLane<Layer> {
    let inputs = (scan, ("object", bus), ("look", look), ("load", load));
    module("shaded_layer", at, inputs, |(scan, bus, look, load)| {
        let words = machine.objects.of_slot(slot);
        let place = Place {
            at: "processor".into(),
            store: "store".into(),
            bus,
            hold: None,
        };
        let stored = place.stored(slot, words.0);
        let count = machine.objects.lanes;
        let lanes = Lanes {
            raster: scan,
            scans: &lane_scans(scan.delayed(lanes_latency(count)), count),
        };
        let (seen, _) = processor(slot, (&place, stored), &lanes, words);
        let material = look.data.low(MATERIAL).reg_when(look.write);
        let weight = look
            .data
            .slice(MATERIAL + LEVEL - 1, MATERIAL)
            .reg_when(look.write);
        let clocks = machine.layer_clocks(slot);
        let pixel = pixel_count("pixel_count", scan, clocks);
        PerLane::of(count, |lane| {
            let seen = &seen[lane as usize];
            let (valid, depth) = (seen.front.out_valid, seen.front.zf);
            let point = Point {
                valid,
                pixel: lane_pixel(pixel, lane, count),
                depth,
                material,
                normal: shaded_normal(seen.normal),
                flags: all_sources(),
            };
            let at = in_lane("shading", lane, count);
            let shaded = machine.shading.shade(&at, point, load);
            let surface = Surface {
                depth: depth.delayed_as("depth_late", machine.shading.latency()),
                red: shaded.red,
                green: shaded.green,
                blue: shaded.blue,
            };
            Layer { surface, weight }
        })
    })
}
