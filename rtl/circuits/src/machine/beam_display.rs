//! Beam machine with its loader, shading and the pins of a screen.

use super::{BeamMachine, Beat, beam_core, frame_loader};
use crate::raster::{Flags, Scan};
use crate::video::{Colour, LEVEL, Output, OverlayBus, Pins, video_output};
use imogene_hdl::{Bits, Value, bundles, module};

bundles! {
    /// What a machine with a screen says.
    Display {
        s_tready: Bits as "s_tready", "the word is taken";
        swapped: Bits as "swapped", "the words of a new frame are at work";
        refused: Bits as "refused", "a frame had more words than the loader keeps";
        /// Pins of its screen.
        pins: Pins as "";
    }
}

/// Draws every pixel on the clock on which the screen wants it, without a frame memory. `last` comes with the last word
/// of a frame. The bus of the overlay is ignored where there is none.
///
/// The words of an object stay until they are written again; a volume takes part in a frame if its control word is
/// among the words of the frame. `docs/machines.md`.
pub fn beam_display(
    at: &str,
    (beat, last): (Beat, Bits),
    overlay: OverlayBus,
    machine: &BeamMachine,
    output: &Output,
) -> Display {
    let inputs = (("s", beat), ("s_tlast", last), ("overlay", overlay));
    module("beam_display", at, inputs, |(beat, last, overlay)| {
        let colour = Colour::of([(); 3].map(|()| Bits::forward(LEVEL)));
        let (wanted, pins) = video_output("screen", colour, overlay, output, machine.latency());
        // All words are at work before the first pixel is asked for.
        let blanking = output.mode.retrace() - output.lead(machine.latency());
        let patience = blanking.saturating_sub((1 << machine.loader_places) + 8);
        let loaded = frame_loader(
            "loader",
            beat,
            last,
            (wanted.retrace, patience),
            (machine.loader_places, 1),
        );
        let flags = Flags {
            valid: wanted.need,
            start: wanted.start,
            line: Some(wanted.line),
        };
        let (pixel, words) = (wanted.pixel, (loaded.take, loaded.load));
        let shaded = beam_core("core", Scan { flags, pixel }, words, machine).alone();
        for (forward, level) in colour.parts().into_iter().zip(shaded.colour().parts()) {
            forward.drive(level);
        }
        Display {
            s_tready: loaded.s_tready,
            swapped: loaded.take,
            refused: loaded.refused,
            pins,
        }
    })
}
