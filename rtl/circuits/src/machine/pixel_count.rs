//! The place of a pixel behind a pipeline.

use crate::raster::{COORDINATE, Flags, Pixel, Scan};
use imogene_hdl::{Bits, Bundle, Value, module, net};

/// The place of a pixel so many clocks later, one at least. It follows from the flags alone, which are fewer bits to
/// delay: it is counted anew.
pub(super) fn pixel_count(at: &str, scan: Scan, clocks: u32) -> Pixel {
    let flags: Flags = scan.flags.delayed(clocks - 1);
    module("pixel_count", at, flags, |flags| {
        let word = |value: u64| Bits::new(value, COORDINATE);
        let (x, y) = (Bits::register(COORDINATE), Bits::register(COORDINATE));
        let line = flags.line.expect("the flags of a raster");
        net! {
            let begins = flags.first();
            let next_x = begins.select(word(0), x + word(1));
            let next_y = flags.start.select(word(0), y + line.extend(COORDINATE));
        }
        x.load_when(flags.valid, next_x);
        y.load_when(flags.valid, next_y);
        Pixel { x, y }
    })
}
