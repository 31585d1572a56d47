//! Transparent objects before the visible surface.

use super::{LEVEL, Shaded};
use crate::rows::numbered;
use imogene_hdl::{Bits, Int, Value, bundle, bundles, join, module, net, ports};

bundle! {
    /// A surface at a pixel, or what is seen there.
    Surface(depth) {
        depth: Int(depth), "depth; 2^(W-1) - 1 where it is absent";
        red: Bits(LEVEL), "red";
        green: Bits(LEVEL), "green";
        blue: Bits(LEVEL), "blue";
    }
}

impl Surface {
    /// One at a depth, in the colour that it has been given.
    pub(crate) fn of(depth: Int, shaded: &Shaded) -> Surface {
        Surface {
            depth,
            red: shaded.red,
            green: shaded.green,
            blue: shaded.blue,
        }
    }

    /// Its colour, on the clocks of pixels.
    pub(crate) fn shaded(self, out_valid: Bits) -> Shaded {
        Shaded {
            out_valid,
            red: self.red,
            green: self.green,
            blue: self.blue,
        }
    }
}

/// Clocks of a stage.
pub const BLEND_LATENCY: u32 = 4;

/// What comes to a stage, and what leaves it.
const BEFORE: &str = "opaque surface, in the colour seen so far";
const BEHIND: &str = "opaque surface, in the colour that is seen";

bundles! {
    /// A transparent object.
    Layer(depth: u32) {
        /// Its surface.
        surface: Surface(depth) as "";
        weight: Bits(LEVEL) as "weight", "its part of what is seen, in 255ths; 255 is opaque";
    }
}

/// Blends transparent objects over a pixel, one stage for each, the first one first.
///
/// Layer i is taken `4 i` clocks after the pixel: its processor starts later. The host sorts: on no pixel may a layer
/// be farther than one of a smaller index, unless it is absent or hidden there. Latency `4 T` for T layers. Chaillou
/// 1991, IV.3.3.
pub fn transparency_pipeline(at: &str, pixel: Surface, layers: Vec<Layer>) -> Surface {
    let meaning = "layer #, 4 times # clocks after the pixel";
    let inputs = (("pixel", pixel, BEFORE), ("layer", layers, meaning));
    module("transparency_pipeline", at, inputs, |(pixel, layers)| {
        let stages = numbered("stages", layers);
        let seen = stages.fold(pixel, |pixel, (at, layer)| {
            transparency_stage(&at, pixel, layer)
        });
        ("", seen, BEHIND)
    })
}

/// Blends the colour of a transparent object with that of the pixel, if the object is nearer than the opaque surface.
///
/// The depth handed on is that of the opaque surface: of transparent objects that come farthest first each is nearer
/// than the last one blended, so only the opaque surface can hide it. An object at the depth of the surface is
/// hidden, as is an absent one. Latency 4. Chaillou 1991, IV.3.3.
pub fn transparency_stage(at: &str, pixel: Surface, layer: Layer) -> Surface {
    let layer = ("layer", layer, "transparent object");
    let inputs = (("pixel", pixel, BEFORE), layer);
    module("transparency_stage", at, inputs, |(pixel, layer)| {
        let Layer { surface, weight } = layer;
        net! { let is_nearer = surface.depth.less(pixel.depth).reg(); }
        let weight = weight.delayed_as("weight_late", 1);
        let blend = |name: &str, front: Bits, behind: Bits| {
            colour_blend(&format!("blend_{name}"), front, behind, (weight, is_nearer))
        };
        let seen = Surface {
            depth: pixel.depth.delayed_as("depth_late", BLEND_LATENCY),
            red: blend("red", surface.red, pixel.red),
            green: blend("green", surface.green, pixel.green),
            blue: blend("blue", surface.blue, pixel.blue),
        };
        ("", seen, BEHIND)
    })
}

/// `round((t front + (255 - t) behind) / 255)` with the weight t, or `behind` where the front one is not seen.
///
/// The sum is `255 behind + t (front - behind)`: one product. It is 65025 at most, and `(n + floor(n / 256)) / 256`
/// with `n = sum + 128` rounds its 255th part exactly; there are no ties, since 255 is odd. Weight and `is_seen` come a
/// clock later. Latency 4: difference, product, sum, rounding.
fn colour_blend(at: &str, front: Bits, behind: Bits, (weight, is_seen): (Bits, Bits)) -> Bits {
    let inputs = ports!(front, behind, weight, is_seen);
    module("colour_blend", at, inputs, |ports| {
        let (front, behind, weight, is_seen) = ports;
        let wide = |level: Bits| level.extend(LEVEL + 1);
        net! {
            let difference = (wide(front) - wide(behind)).int().reg();
            let kept_behind = behind.reg();
            let kept_product = (difference * wide(weight).int()).reg();
            // 255 times the level behind, and 128.
            let raised = join([kept_behind, Bits::new(128, LEVEL)]);
            let base = (raised - kept_behind.extend(2 * LEVEL)).reg();
            // The sum is never negative and has 16 bits: what the product has above them cancels.
            let sum = (base + kept_product.low(2 * LEVEL).bits()).reg();
            let quotient = sum.slice(2 * LEVEL - 1, LEVEL).extend(2 * LEVEL);
            let rounded = sum + quotient;
            let late_behind = kept_behind.delay(2);
            let late_is_seen = is_seen.delay(2);
        }
        let blend = rounded.slice(2 * LEVEL - 1, LEVEL);
        ("blend", late_is_seen.select(blend, late_behind).reg())
    })
}
