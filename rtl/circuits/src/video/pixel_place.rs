//! Place of a pixel in a picture.

use crate::raster::Pixel;
use imogene_hdl::{Bits, Value, module, net};

/// The number of a pixel, line by line: `place = y width + x`, of as many bits as both coordinates. Latency 2.
pub fn pixel_place(at: &str, pixel: Pixel, width: Bits) -> Bits {
    let inputs = (pixel, ("width", width));
    module("pixel_place", at, inputs, |(pixel, width)| {
        net! {
            let line_place = (pixel.y * width).reg();
            let kept_x = pixel.x.reg();
        }
        let place = line_place + kept_x.extend(line_place.width());
        ("place", place.reg())
    })
}
