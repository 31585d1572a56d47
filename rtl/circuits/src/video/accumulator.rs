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
        address: Bits(places), "which pixel; the same one comes again after 4 clocks at the earliest";
        first_pass: Bits(1), "the pixel is of the first pass";
        last_pass: Bits(1), "the pixel is of the last pass";
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
/// A pixel comes once in a pass, in any order; its address comes again after 4 clocks at the earliest. Latency 4.
/// Chaillou 1991, III.1.5 and IV.4.7.2.
pub fn accumulator(at: &str, pixel: PassPixel, colour: Colour, places: u32) -> Mean {
    let inputs = (pixel, ("", colour, "pixel"));
    module("accumulator", at, inputs, |(pixel, colour)| {
        let (late, late_colour) = (pixel.delayed(2), colour.delayed(2));
        net! {
            let written = late.valid.reg();
            let written_address = late.address.reg();
        }
        // A memory for each channel: in memories of so many words parts have words of few bits.
        let means = [0, 1, 2].map(|channel| {
            let value = late_colour.parts()[channel];
            let at = ["red", "green", "blue"][channel];
            let sum = Bits::forward(SUM);
            let write = (written, written_address.low(places), sum);
            let name = format!("{at}_store");
            let stored = memory(&name, 1 << places, write, pixel.address.low(places));
            let earlier = stored.reg().named(&format!("{at}_earlier"));
            let added = pass_sum(at, value, earlier, late.first_pass);
            sum.drive(added.reg());
            mean_of(at, sum, late.fine.reg())
        });
        let mean = Mean {
            valid: (late.valid & late.last_pass).delay(2),
            address: written_address.reg(),
            colour: Colour::of(means).registered(),
        };
        ("out", mean)
    })
}

/// The sum of a level and of the passes before. Without registers.
fn pass_sum(at: &str, value: Bits, earlier: Bits, first: Bits) -> Bits {
    let inputs = ports!(value, earlier, first);
    module("pass_sum", at, inputs, |(value, earlier, first)| {
        net! { let wide = value.extend(SUM); }
        ("sum", first.select(wide, earlier + wide))
    })
}

/// The mean that a sum is of 16 or of 4 levels. Without registers.
fn mean_of(at: &str, sum: Bits, fine: Bits) -> Bits {
    let at = format!("{at}_mean");
    module("pass_mean", &at, ports!(sum, fine), |(sum, fine)| {
        net! {
            let fine_sum = sum + Bits::new(8, SUM);
            let coarse_sum = sum + Bits::new(2, SUM);
        }
        let mean = fine.select(fine_sum.slice(11, 4), coarse_sum.slice(9, 2));
        ("mean", mean)
    })
}
