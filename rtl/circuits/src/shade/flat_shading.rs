//! Colours without lights.

use super::shading_processor::{Shaded, ShadingLoad, part};
use crate::video::{Colour, LEVEL};
use imogene_contract::shading::{
    BACKGROUND, FLAT_LATENCY, LIGHT, MATERIAL, MATERIAL_WORDS, MOST_MATERIALS,
};
use imogene_contract::words::far_end;
use imogene_hdl::{Bits, Int, Value, bundles, memory, module, net};

bundles! {
    /// What is seen of an object without lights.
    FlatPoint {
        valid: Bits as "valid", "this clock carries a pixel";
        depth: Int as "depth", "depth; 2^(W-1) - 1 is the background";
        material: Bits as "material", "number of the material";
    }
}

/// What the shading processor gives without a light: the ambient level of the material of every pixel, rounded, or the
/// background. One pixel per clock.
///
/// Latency 5: a memory gives its word late in a clock, so that a register stands before and one behind it. The words
/// and their addresses are those of the shading processor; all but the background and the ambient levels mean nothing
/// here.
pub fn flat_shading(at: &str, point: FlatPoint, load: ShadingLoad) -> Shaded {
    let inputs = (point, ("load", load));
    module("flat_shading", at, inputs, |(point, load)| {
        let view = part(load, 0, LIGHT, 3 * LEVEL);
        let bus = part(load, MATERIAL, MATERIAL_WORDS * MOST_MATERIALS, 32);
        net! { let material = point.material.reg(); }
        let word = |index: u64, width: u32| {
            let write = bus.write & bus.address.low(2).is(index);
            let (name, entry) = (format!("materials_{index}"), bus.address.slice(9, 2));
            let write = (write, entry, bus.data.low(width));
            memory(&name, MOST_MATERIALS as usize, write, material).reg()
        };
        net! {
            let red_green = word(0, 32);
            let blue = word(1, 16);
            let is_far = point.depth.is(far_end(point.depth.width()) as u64).delay(FLAT_LATENCY - 1);
        }
        let ambient = [red_green.low(16), red_green.slice(31, 16), blue];
        let background = Colour::of(
            [0, 1, 2].map(|level| view.bits(BACKGROUND, (level + 1) * LEVEL - 1, level * LEVEL)),
        );
        let levels = ["red", "green", "blue"].map(|name| name.to_owned() + "_level");
        let own = [0, 1, 2].map(|channel| rounded(ambient[channel]).reg().named(&levels[channel]));
        let [red, green, blue] = is_far.select(background, Colour::of(own)).parts();
        Shaded {
            out_valid: point.valid.delayed_as("valid_late", FLAT_LATENCY),
            red: red.reg(),
            green: green.reg(),
            blue: blue.reg(),
        }
    })
}

/// A level of 8 bits behind the point, rounded, halves up; the brightest one where it is more.
fn rounded(level: Bits) -> Bits {
    net! { let sum = level.extend(17) + Bits::new(1 << 7, 17); }
    let brightest = Bits::new((1 << LEVEL) - 1, LEVEL);
    sum.top().select(brightest, sum.slice(15, 8))
}
