//! Samples of a zone, pass after pass, to pixels.

use crate::video::{Colour, PassPixel, accumulator};
use imogene_hdl::{Bits, Value, bundle, bundles, module, net};

/// Clocks from a sample of the last pass to its pixel.
pub const MEAN_LATENCY: u32 = 4;

bundle! {
    /// Passes that samples are of.
    SamplePass() {
        first_pass: Bits(1), "it is of the first pass over the zone";
        last_pass: Bits(1), "it is of the last pass";
        pass_ends: Bits(1), "it is the last of its pass";
    }
}

bundles! {
    /// A pixel with its colour.
    #[derive(Copy)]
    Coloured {
        valid: Bits as "valid", "it comes";
        colour: Colour as "", "its colour";
        place: Bits as "place", "its place on the screen: line in the upper half, column in the lower one";
        last: Bits as "last", "it is the last of the frame";
    }
}

/// Means of `samples x samples`, 2 or 4, of every pixel of a zone of at most `2^places` pixels. Passes follow each
/// other, each in the order of the pixels; what leaves comes with the last one. Rounded to the nearest, halves up.
///
/// Latency 4, from the sample of the last pass. `docs/zone-machine.md`; section 3.2.2.
///
/// # Panics
///
/// Where there are not 2 or 4 samples.
pub fn sample_mean(
    at: &str,
    pass: SamplePass,
    sample: Coloured,
    samples: u32,
    places: u32,
) -> Coloured {
    assert!(matches!(samples, 2 | 4), "2 x 2 or 4 x 4 samples");
    module("sample_mean", at, (pass, sample), |(pass, sample)| {
        net! {
            let count = Bits::register(places);
            let next = count + Bits::new(1, places);
        }
        let next = pass.pass_ends.select(Bits::new(0, places), next);
        count.load_when(sample.valid, next);
        let pixel = PassPixel {
            fine: Bits::new(u64::from(samples == 4), 1),
            valid: sample.valid,
            address: count,
            first_pass: pass.first_pass,
            last_pass: pass.last_pass,
        };
        let mean = accumulator("sums", pixel, sample.colour, places);
        let mean = Coloured {
            valid: mean.valid,
            colour: mean.colour,
            place: sample.place.delayed_as("place_late", MEAN_LATENCY),
            last: sample.last.delayed_as("last_late", MEAN_LATENCY),
        };
        ("out", mean)
    })
}
