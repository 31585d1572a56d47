//! Zone machine with a frame store and the pins of a screen.

use super::{Beat, COORDINATE, ZoneMachine, zone_machine};
use crate::video::{
    Asked, Colour, FRAME_LATENCY, LEVEL, Output, OverlayBus, Pins, frame_store, video_output,
};
use imogene_hdl::{Bits, Value, bundles, module};

bundles! {
    /// What leaves a zone machine with a screen.
    ZoneScreen {
        ready: Bits as "s_tready", "the beat is taken";
        swapped: Bits as "swapped", "a new frame is shown from the next picture on";
        /// Pins of the screen.
        pins: Pins as "";
    }
}

/// A zone machine whose pixels are kept in one of two frames while the other is shown.
///
/// The frames change places in the vertical blanking after the last pixel of a frame came in; until then the old one is
/// shown again. `docs/machines.md`.
pub fn zone_display(
    at: &str,
    beat: Beat,
    bus: OverlayBus,
    machine: &ZoneMachine,
    output: &Output,
) -> ZoneScreen {
    let inputs = (("s", beat), ("overlay", bus));
    module("zone_display", at, inputs, |(beat, bus)| {
        let (line, frame) = (output.mode.line, output.mode.frame);
        let places = (line.active * frame.active).next_power_of_two().ilog2();
        let taken = Bits::forward(1);
        let (ready, pixels) = zone_machine("machine", beat, taken, machine);
        let colour = Bits::forward(3 * LEVEL);
        let picture = Colour::unpacked(colour);
        let (wanted, pins) = video_output("screen", picture, bus, output, FRAME_LATENCY);
        let asked = Asked {
            width: Bits::new(line.active, COORDINATE),
            retrace: wanted.retrace,
            need: wanted.need,
            x: wanted.pixel.x,
            y: wanted.pixel.y,
        };
        let shown = frame_store("frames", pixels, asked, places);
        taken.drive(shown.s_tready);
        colour.drive(shown.colour.packed());
        ZoneScreen {
            ready,
            swapped: shown.swapped,
            pins,
        }
    })
}
