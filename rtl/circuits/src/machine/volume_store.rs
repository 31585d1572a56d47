//! Words of a shadow or light volume.

use super::LoadBus;
use crate::object::{Bounds, HalfSpace, VolumeWords, Widths};
use crate::raster::Linear;
use imogene_contract::volume::{BOX_COLUMNS, CONTROL, MARGIN, PLANE_WORDS, PLANES};
use imogene_hdl::{Bits, Bundle, Value, bundles, module, net};

bundles! {
    /// The words of a volume, and how it takes part.
    StoredVolume {
        /// Words of its processor.
        words: VolumeWords as "";
        margin: Bits as "margin", "counts that a point has to lie behind the beginning";
        is_light: Bits as "is_light", "it is a light volume: outside is dark";
        source: Bits as "source", "the source it belongs to";
        is_present: Bits as "is_present", "its control word was written between the last two `take`";
    }
}

/// Keeps the words of a volume; those used after the first pixel are taken over at the beginning of a pass, so that the
/// next volume may be loaded while this one is asked. What f1, f2 and planes begin with acts as it is loaded.
pub fn volume_store(
    at: &str,
    take: Bits,
    bus: LoadBus,
    (depth, widths): (u32, Widths),
    planes: u64,
) -> StoredVolume {
    let inputs = (("take", take), bus);
    module("volume_store", at, inputs, |(take, bus)| {
        net! { let is_new = bus.is_new(CONTROL, take); }
        let linear = |words: Linear| words.with_steps(words.steps().registered_when(take));
        let plane = |index: u64| {
            let plane = bus.half_space(PLANES + PLANE_WORDS * index, widths.plane);
            HalfSpace {
                kind: plane.kind.reg_when(take),
                linear: linear(plane.linear),
            }
        };
        let box_x0 = bus.bits(BOX_COLUMNS, 11, 0);
        let f2 = bus.quadratic(3, widths.quadratic);
        let bounds = Bounds {
            screen_box: bus.screen_box(BOX_COLUMNS, box_x0).registered_when(take),
            planes: (0..planes).map(plane).collect(),
        };
        let control = |high: u32, low: u32| bus.bits(CONTROL, high, low).reg_when(take);
        StoredVolume {
            words: VolumeWords {
                f1: linear(bus.linear(0, widths.linear)),
                f2: f2.with_steps(f2.steps().registered_when(take)),
                bounds,
                object_class: control(1, 0),
                depth_shift: control(5, 2),
            },
            margin: bus.bits(MARGIN, depth - 1, 0).reg_when(take),
            is_light: control(6, 6),
            source: control(10, 7),
            is_present: is_new.reg_when(take),
        }
    })
}
