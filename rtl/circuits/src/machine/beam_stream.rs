//! Beam machine that streams its picture.

use super::{BeamMachine, Beat, beam_core, frame_loader};
use crate::video::{LEVEL, Queue, frame_scan, pixel_fifo};
use imogene_hdl::{Bits, Value, bundle, join, module};

/// Address bits of the queue of pixels at least.
const QUEUE: u32 = 8;

bundle! {
    /// What a machine that streams says.
    Streamed() {
        s_tready: Bits(1), "the word is taken";
        m_tvalid: Bits(1), "a pixel is there";
        m_tdata: Bits(3 * LEVEL), "its colour: red in 23..16, green in 15..8, blue in 7..0";
        m_tuser: Bits(1), "it is the first of a frame";
        m_tlast: Bits(1), "it is the last of a line";
        swapped: Bits(1), "the words of a new frame are at work";
        refused: Bits(1), "a frame had more words than the loader keeps";
    }
}

/// Draws frame after frame of `width` by `height` pixels over AXI4-Stream, as fast as the receiver takes them: the
/// objects of a beam machine, without a screen's timing. `last` comes with the last word of a frame.
///
/// Between two frames the pipeline runs empty, and the words of a new frame are copied if its last one has come.
/// `docs/machines.md`.
pub fn beam_stream(
    at: &str,
    (beat, last): (Beat, Bits),
    ready: Bits,
    machine: &BeamMachine,
    size: (u64, u64),
) -> Streamed {
    let inputs = (("s", beat), ("s_tlast", last), ("m_tready", ready));
    module("beam_stream", at, inputs, |(beat, last, ready)| {
        let latency = machine.latency();
        let [room, is_busy] = [(); 2].map(|()| Bits::forward(1));
        let frames = frame_scan("scan", (room, is_busy), size, u64::from(latency) + 2);
        let loaded = frame_loader("loader", beat, last, frames.retrace, machine.loader_places);
        is_busy.drive(loaded.is_busy);
        let words = (loaded.take, loaded.load);
        let shaded = beam_core("core", frames.scan, words, machine);
        let is_first = frames.scan.flags.start.delayed_as("start_late", latency);
        let queue = Queue {
            started: frames.issue,
            push: shaded.out_valid,
            data: join([is_first, shaded.red, shaded.green, shaded.blue]),
            last: frames.line_ends.delayed_as("line_ends_late", latency),
            m_tready: ready,
        };
        // The queue is long enough for a pixel on every clock.
        let places = (latency + 6).next_power_of_two().ilog2().max(QUEUE);
        let queued = pixel_fifo("queue", queue, places, latency + 1);
        room.drive(queued.room);
        Streamed {
            s_tready: loaded.s_tready,
            m_tvalid: queued.m_tvalid,
            m_tdata: queued.m_tdata.low(3 * LEVEL),
            m_tuser: queued.m_tdata.top(),
            m_tlast: queued.m_tlast,
            swapped: loaded.take,
            refused: loaded.refused,
        }
    })
}
