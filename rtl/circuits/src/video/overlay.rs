//! Plane of one bit per pixel over the picture.

use super::{COORDINATE, Colour, LEVEL, pixel_place};
use crate::raster::Pixel;
use imogene_hdl::{Bits, Bundle, Value, bundle, memory, module, net};

/// Bits of a word of the plane.
const WORD: u32 = 32;
/// Clocks until the bit of a pixel is there.
const READ: u32 = 5;
/// Clocks from a pixel to itself with the plane over it.
pub const OVERLAY_LATENCY: u32 = READ + 1;

bundle! {
    /// A plane of one bit per pixel.
    BitPlane(places) {
        write: Bits(1), "the host writes 32 pixels";
        write_address: Bits(places), "which word: that of the pixels 32 times the address and on";
        write_data: Bits(WORD), "the word, its first pixel in bit 0";
        enable: Bits(1), "the plane is shown; read 5 clocks after the pixel";
        colour: Bits(3 * LEVEL),
            "colour of the set pixels: red in bits 23..16, green in 15..8, blue in 7..0; read 5 clocks after the pixel";
        width: Bits(COORDINATE), "pixels of a line";
    }
}

/// Puts a plane of one bit per pixel over a picture that comes pixel by pixel, each with its flag `valid`.
///
/// Pixel `n = y width + x` is bit `n mod 32` of word `n / 32`, modulo the words of the plane. `enable` and `colour`
/// are read 5 clocks after the pixel. A word written at clock t is seen by the pixels of t - 2 and later. All bits
/// are 0 at power-up. Latency 6. Chaillou 1991, IV.4.7.1.
pub fn overlay(
    at: &str,
    plane: BitPlane,
    (valid, pixel, colour): (Bits, Pixel, Colour),
) -> (Bits, Colour) {
    let valid = ("valid", valid, "this clock carries a pixel");
    let inputs = (plane, valid, ("", (pixel, colour), "pixel"));
    module("overlay", at, inputs, |(plane, valid, (pixel, colour))| {
        let places = plane.write_address.width();
        let place = pixel_place("read_place", pixel, plane.width);
        let write = (plane.write, plane.write_address, plane.write_data);
        net! {
            let read_address = place.slice(places + 4, 5);
            let stored = memory("plane", 1 << places, write, read_address).reg();
            let is_new = (plane.write & plane.write_address.equals(read_address)).delay(2);
            let new_word = plane.write_data.delay(2);
            let word = is_new.select(new_word, stored);
            let bit_place = place.low(5).delay(2);
            let shifted = word.right_by(bit_place);
            let is_set = shifted.bit(0).reg();
            let covered = plane.enable & is_set;
        }
        let seen = covered.select(Colour::unpacked(plane.colour), colour.delayed(READ));
        let valid = valid.delayed_as("valid_late", OVERLAY_LATENCY);
        let valid = ("valid", valid, "valid, with the colour of its pixel");
        ("out", (valid, ("", seen.registered(), "result")))
    })
}
