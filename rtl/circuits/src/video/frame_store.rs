//! Two frames: one is shown while the other arrives.

use super::{COORDINATE, Colour, LEVEL, pixel_place};
use crate::raster::Pixel;
use imogene_hdl::{Bits, Value, bundle, bundles, memory, module, net};

/// Clocks from a pixel that is asked for to its colour.
pub const FRAME_LATENCY: u32 = 5;

bundle! {
    /// A pixel over AXI4-Stream.
    PixelStream() {
        tvalid: Bits(1), "a pixel comes in";
        tdata: Bits(3 * LEVEL), "its colour: red in bits 23..16, green in 15..8, blue in 7..0";
        tuser: Bits(2 * COORDINATE), "its place: line in bits 23..12, column in 11..0";
        tlast: Bits(1), "last pixel of the frame";
    }

    /// What the screen asks for.
    Asked() {
        width: Bits(COORDINATE), "pixels of a line";
        retrace: Bits(1), "first clock of the vertical blanking: a whole frame takes its place on the screen";
        need: Bits(1), "a pixel to show";
        x: Bits(COORDINATE), "its column";
        y: Bits(COORDINATE), "its line";
    }
}

bundles! {
    /// What a frame store says.
    Shown {
        s_tready: Bits as "s_tready",
            "the pixel is taken; low from the last pixel of a frame until the frames change places";
        valid: Bits as "valid", "need, with the colour of its pixel";
        colour: Colour as "", "pixel to show";
        swapped: Bits as "swapped", "another frame is shown from now on";
    }
}

/// Shows the last whole frame that came in over AXI4-Stream; another one takes its place in the vertical blanking.
///
/// A frame has at most `2^places` pixels, which come in any order. After the last one `s_tready` is low until the next
/// `retrace`, where the frames change places; a `retrace` before it changes nothing. At power-up both frames are black.
/// Latency 5. Section 9 of the architecture.
pub fn frame_store(at: &str, arrival: PixelStream, asked: Asked, places: u32) -> Shown {
    let inputs = (("s", arrival), asked);
    module("frame_store", at, inputs, |(arrival, asked)| {
        net! {
            let second_is_shown = Bits::register(1);
            let is_whole = Bits::register(1);
            let taken = arrival.tvalid & !is_whole;
            let swaps = asked.retrace & is_whole;
        }
        let is_last = taken & arrival.tlast;
        is_whole.load_when(is_last | swaps, is_last);
        second_is_shown.load_when(swaps, !second_is_shown);
        let from = Pixel::of([
            arrival.tuser.low(COORDINATE),
            arrival.tuser.high(COORDINATE),
        ]);
        let to = Pixel::of([asked.x, asked.y]);
        let write_place = pixel_place("write_place", from, asked.width);
        let read_place = pixel_place("read_place", to, asked.width);
        let late_data = arrival.tdata.delayed_as("late_data", 2);
        // The bank goes with the pixel: the frames may change places while the last pixel is on its way.
        let late_taken = taken.delayed_as("late_taken", 2);
        let late_bank = second_is_shown.delayed_as("late_bank", 2);
        net! {
            let write_address = write_place.low(places);
            let read_address = read_place.low(places);
            let writes_first = late_taken & late_bank;
            let writes_second = late_taken & !late_bank;
            let first = memory("first_bank", 1 << places, (writes_first, write_address, late_data), read_address).reg();
            let second = memory("second_bank", 1 << places, (writes_second, write_address, late_data), read_address).reg();
            let shows_second = late_bank.delay(2);
            let colour = shows_second.select(second, first).reg();
        }
        Shown {
            s_tready: !is_whole,
            valid: asked.need.delayed_as("late_need", FRAME_LATENCY),
            colour: Colour::unpacked(colour),
            swapped: swaps.reg(),
        }
    })
}
