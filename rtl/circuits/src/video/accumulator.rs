//! Mean of several passes over a picture.

use super::{Colour, LEVEL};
use imogene_hdl::{Bits, Bundle, Value, bundle, bundles, memory, module, net, ports};

/// Bits of the sum of 16 levels.
const SUM: u32 = LEVEL + 4;

bundle! {
    /// How a pixel is added.
    PassPixel(places) {
        fine: Bits(1), "16 passes, not 4; read with the pixels of the last pass";
        valid: Bits(1), "this clock carries a pixel";
        address: Bits(places), "which pixel; the same one comes again after 3 clocks at the earliest";
        first_pass: Bits(1), "the pixel is of the first pass";
        last_pass: Bits(1), "the pixel is of the last pass";
    }

    /// A level of a pixel after a pass.
    Pass() {
        sum: Bits(SUM), "sum of the passes";
        mean: Bits(LEVEL), "their mean";
    }
}

bundles! {
    /// A pixel of the last pass.
    Mean {
        valid: Bits as "valid", "a pixel of the last pass leaves";
        address: Bits as "address", "which pixel";
        colour: Colour as "", "mean colour of the pixel";
    }
}

/// Adds the colours of 4 or 16 passes in a memory of `2^places` pixels, and gives their mean in the last pass,
/// rounded to the nearest, halves up. Other bits of an address are ignored.
///
/// A pixel comes once in a pass, in any order; its address comes again after 3 clocks at the earliest. Latency 3.
/// Chaillou 1991, III.1.5 and IV.4.7.2.
pub fn accumulator(at: &str, pixel: PassPixel, colour: Colour, places: u32) -> Mean {
    let inputs = (pixel, ("", colour, "pixel"));
    module("accumulator", at, inputs, |(pixel, colour)| {
        let (late, late_colour) = (pixel.delayed(2), colour.delayed(2));
        let sum = Bits::forward(3 * SUM);
        let write = (late.valid, late.address.low(places), sum);
        net! {
            let stored = memory("store", 1 << places, write, pixel.address.low(places));
            let earlier = stored.reg();
        }
        let earlier = Colour::unpacked(earlier).parts();
        let passes = [0, 1, 2].map(|channel| {
            let value = late_colour.parts()[channel];
            let at = ["red", "green", "blue"][channel];
            pass_sum(at, value, earlier[channel], (late.first_pass, late.fine))
        });
        sum.drive(Colour::of(passes.map(|pass| pass.sum)).packed());
        let mean = Mean {
            valid: (late.valid & late.last_pass).reg(),
            address: late.address.reg(),
            colour: Colour::of(passes.map(|pass| pass.mean)).registered(),
        };
        ("out", mean)
    })
}

/// The sum of a level and of the passes before, and the mean that it would be of 16 or of 4 levels. Without registers.
fn pass_sum(at: &str, value: Bits, earlier: Bits, (first, fine): (Bits, Bits)) -> Pass {
    let inputs = ports!(value, earlier, first, fine);
    module("pass_sum", at, inputs, |(value, earlier, first, fine)| {
        net! {
            let wide = value.extend(SUM);
            let sum = first.select(wide, earlier + wide);
            let fine_sum = sum + Bits::new(8, SUM);
            let coarse_sum = sum + Bits::new(2, SUM);
        }
        let mean = fine.select(fine_sum.slice(11, 4), coarse_sum.slice(9, 2));
        Pass { sum, mean }
    })
}
