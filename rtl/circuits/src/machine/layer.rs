//! A transparent object of a beam machine: its processor, its material and its own shading.

use super::slot::{Lanes, Place, seen};
use super::{LoadBus, MATERIAL, NORMAL, Objects, all_sources};
use crate::object::Normal;
use crate::raster::{Pixel, Scan, lane_pixel, lane_scans, lanes_latency};
use crate::rows::{PerLane, in_lane};
use crate::shade::{Layer, Point, Shading, ShadingLoad, Surface};
use crate::video::LEVEL;
use imogene_contract::slots::FittedSlot;
use imogene_hdl::{Bits, Bundle, Value, bundle, bundles, module};

bundle! {
    /// The word that says how a transparent object looks.
    Look(width) {
        write: Bits(1), "write it";
        data: Bits(width), "bits 7..0 number of the material, 15..8 its part of what is seen, in 255ths";
    }
}

bundles! {
    /// A transparent object on its way to its colour.
    Transparent {
        /// Pixels, as many clocks before `pixel` as its processor takes.
        scan: Scan as "";
        pixel: Pixel as "point", "pixel of the screen that its processor has seen";
        object: LoadBus as "object", "its words";
        look: Look as "look", "how it looks";
        load: ShadingLoad as "load", "words of the shading";
        take: Option<Bits> as "take", "words are taken over, where they are held";
    }
}

/// What a machine is built for, of which a transparent object is a part.
pub(super) struct Around<'a> {
    pub objects: &'a Objects,
    pub shading: &'a Shading,
}

/// The surface of a transparent object at every pixel of each lane, lit by all sources. Latency that of its processor
/// and of the shading.
///
/// Where words are held, they are so as a whole: the first pixel may wait for a receiver. An object that was not
/// written since the words were last taken over is absent.
pub(super) fn shaded_layer(
    at: &str,
    object: Transparent,
    slot: &FittedSlot,
    machine: &Around,
) -> PerLane<Layer> {
    module("shaded_layer", at, object, |object| {
        let (scan, bus, load) = (object.scan, object.object, object.load);
        let take = object.take;
        let words = machine.objects.of_slot(slot);
        let place = Place {
            at: "processor".into(),
            store: "store".into(),
            bus,
            hold: take.map(|take| (String::new(), take)),
        };
        let count = machine.objects.lanes;
        let lanes = Lanes {
            raster: scan,
            scans: &lane_scans(scan.delayed(lanes_latency(count)), count),
        };
        let stored = place.whole(slot, words.0);
        let seen = seen(slot, (&place, stored), &lanes, words);
        let look = object.look.data.reg_when(object.look.write);
        let look = take.map_or(look, |take| look.reg_when(take));
        let material = look.low(MATERIAL).named("material");
        let weight = look.slice(MATERIAL + LEVEL - 1, MATERIAL).named("weight");
        PerLane::of(count, |lane| {
            let seen = &seen[lane as usize];
            let (valid, depth) = (seen.front.out_valid, seen.front.zf);
            let point = Point {
                valid,
                pixel: lane_pixel(object.pixel, lane, count),
                depth,
                material,
                normal: shaded_normal(seen.normal),
                flags: all_sources(),
            };
            let at = in_lane("shading", lane, count);
            let shaded = machine.shading.shade(&at, point, load);
            let depth = depth.delayed_as("depth_late", machine.shading.latency());
            let surface = Surface::of(depth, &shaded);
            Layer { surface, weight }
        })
    })
}

/// A normal in at most the words of the shading processor, to which its length means nothing.
pub(super) fn shaded_normal(normal: Normal) -> Normal {
    normal.map(|part| part.high(part.width().min(NORMAL)))
}
