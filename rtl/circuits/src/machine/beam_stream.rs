//! Beam machine that streams its picture.

use super::{BeamMachine, Beat, beam_core, frame_loader};
use crate::rows::{PerLane, numbered};
use crate::shade::Shaded;
use crate::video::{
    Group, Merged, ModuleStream, Queue, Queued, Scanned, colours_of_pairs, frame_scan, line_merger,
    pixel_fifo,
};
use imogene_hdl::{Bits, Value, bundles, join, module};

/// Address bits of the queue of pixels at least.
const QUEUE: u32 = 8;

bundles! {
    /// What a machine that streams says.
    Streamed {
        s_tready: Bits as "s_tready", "the word is taken";
        m_tvalid: Bits as "m_tvalid", "a pixel is there";
        m_tdata: PerLane<Bits> as "m_tdata", "its colour: red in 23..16, green in 15..8, blue in 7..0";
        m_tuser: Bits as "m_tuser", "it is the first of a frame";
        m_tlast: Bits as "m_tlast", "it is the last of a line";
        swapped: Bits as "swapped", "the words of a new frame are at work";
        refused: Bits as "refused", "a frame had more words than the loader keeps";
    }
}

/// Draws frame after frame of `width` by `height` pixels over AXI4-Stream, as fast as the receiver takes them and roots
/// are found: the objects of a beam machine, without a screen's timing. `last` comes with the last word of a frame.
/// Several pixels at once are neighbours, pixel 0 the leftmost; they divide the width.
///
/// Several graphics modules run side by side, on the same clocks: each has all that a beam machine has for its objects
/// and draws every n-th line, where there are n. One loader, one scan and one queue serve them all, and their lines
/// leave one behind the other, with as many pixels on a clock as all of them draw.
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
        let lanes = machine.objects.lanes;
        let modules = machine.modules;
        let groups = (size.0 / u64::from(lanes), size.1 / u64::from(modules));
        let (pace, drain) = (machine.objects.words.clocks_per_pixel(), latency + 2);
        let frames = frame_scan("scan", (room, is_busy), groups, pace, drain.into());
        let kept = (machine.loader_places, modules);
        let loaded = frame_loader("loader", beat, last, (frames.retrace, 0), kept);
        is_busy.drive(loaded.is_busy);
        let core = |at: &str, load| beam_core(at, frames.scan, (loaded.take, load), machine);
        let shaded = match loaded.chosen {
            None => core("core", loaded.load),
            Some(chosen) => PerLane(
                numbered("cores", 0..modules)
                    .flat_map(|(at, index)| {
                        core(&at, loaded.load.when(chosen.slice(index, index))).0
                    })
                    .collect(),
            ),
        };
        let takes = Bits::forward(1);
        let (queued, pixels) = queues(&frames, &shaded, takes, latency);
        room.drive(queued.room);
        let leaving = Merged {
            s_tready: ready,
            m_tvalid: queued.m_tvalid,
            m_tdata: pixels,
            m_tuser: queued.m_tdata.top(),
            m_tlast: queued.m_tlast,
        };
        let leaving = match modules {
            1 => leaving,
            modules => merged(
                leaving,
                ready,
                Group {
                    modules,
                    words: groups.0 / u64::from(modules),
                },
            ),
        };
        takes.drive(leaving.s_tready);
        Streamed {
            s_tready: loaded.s_tready,
            m_tvalid: leaving.m_tvalid,
            m_tdata: leaving.m_tdata,
            m_tuser: leaving.m_tuser,
            m_tlast: leaving.m_tlast,
            swapped: loaded.take,
            refused: loaded.refused,
        }
    })
}

/// The lines of all modules, one behind the other.
fn merged(lines: Merged, ready: Bits, group: Group) -> Merged {
    let lines = ModuleStream {
        tvalid: lines.m_tvalid,
        tdata: lines.m_tdata,
        tuser: lines.m_tuser,
        tlast: lines.m_tlast,
    };
    line_merger("merger", lines, ready, group)
}

/// Queues of two pixels each, all at the same place, long enough for pixels on every clock; and the pixels that leave.
fn queues(
    frames: &Scanned,
    shaded: &PerLane<Shaded>,
    ready: Bits,
    latency: u32,
) -> (Queued, PerLane<Bits>) {
    let is_first = frames.scan.flags.start.delayed_as("start_late", latency);
    let line_ends = frames.line_ends.delayed_as("line_ends_late", latency);
    let places = (latency + 6).next_power_of_two().ilog2().max(QUEUE);
    let pairs = shaded.0.chunks(2).enumerate().map(|(index, pair)| {
        let colours = pair.iter().rev().map(|shaded| shaded.colour().packed());
        let queue = Queue {
            started: frames.issue,
            push: pair[0].out_valid,
            data: colours.fold(is_first, |word, colour| join([word, colour])),
            last: line_ends,
            m_tready: ready,
        };
        let at = match index {
            0 => "queue".to_owned(),
            _ => format!("queue_{index}"),
        };
        pixel_fifo(&at, queue, places, latency + 1)
    });
    let queues: Vec<Queued> = pairs.collect();
    let words: Vec<Bits> = queues.iter().map(|queue| queue.m_tdata).collect();
    let pixels = colours_of_pairs(&words, shaded.0.len() as u32);
    (queues[0], pixels)
}
