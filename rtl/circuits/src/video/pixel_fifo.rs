//! Queue between a pipeline that cannot stall and a receiver that can.

use imogene_hdl::{Bits, Value, bundle, join, memory, module, net};

bundle! {
    /// What comes to a queue.
    Queue(width) {
        started: Bits(1), "a pixel goes into the pipeline; only with room";
        push: Bits(1), "a pixel leaves the pipeline";
        data: Bits(width), "the pixel that leaves the pipeline";
        last: Bits(1), "the pixel that leaves the pipeline ends its packet";
        m_tready: Bits(1), "the receiver takes the oldest pixel";
    }

    /// What leaves it.
    Queued(width) {
        room: Bits(1), "a pixel that is started now finds a place";
        m_tvalid: Bits(1), "a pixel is there; it stays until it is taken";
        m_tdata: Bits(width), "the oldest pixel";
        m_tlast: Bits(1), "the oldest pixel ends its packet";
    }
}

/// Keeps `2^places` pixels of a pipeline of at most `flight` clocks in order until an AXI4-Stream receiver takes
/// them, and says when the pipeline may be given another one.
///
/// A pixel that is started has its place until it is taken, so what is pushed always finds one. One pixel per clock
/// without a stall. Latency 3 from a push to the output, where nothing waits before it: to the store, out of it, and to
/// a register behind it. Section 8 of the architecture.
///
/// # Panics
///
/// When the queue is too short to keep the pipeline full.
pub fn pixel_fifo(at: &str, queue: Queue, places: u32, flight: u32) -> Queued {
    assert!(
        1 << places >= flight + 5,
        "a queue of 2^{places} pixels behind {flight} clocks: accepted are {} at least",
        flight + 5
    );
    module("pixel_fifo", at, queue, |queue| {
        let count = || Bits::register(places + 1);
        let one = Bits::new(1, places + 1);
        net! {
            let read = count();
            let written = count();
            let promised = count();
            let is_read = Bits::register(1);
            let is_there = Bits::register(1);
            let taken = is_there & queue.m_tready;
            let moves = is_read & (queue.m_tready | !is_there);
            let next_read = moves.select(read + one, read);
        }
        read.load(next_read);
        // A word that is written in this clock cannot be read in it.
        is_read.load(!next_read.equals(written));
        is_there.load_when(moves | taken, moves);
        written.load_when(queue.push, written + one);
        let change = queue.started.select(promised + one, promised - one);
        promised.load_when(queue.started ^ taken, change);
        let word = join([queue.last, queue.data]);
        let write = (queue.push, written.low(places), word);
        net! {
            let stored = memory("store", 1 << places, write, next_read.low(places));
            let oldest = stored.reg_when(moves);
        }
        Queued {
            // No more than `2^places` are promised, so one bit tells whether all are.
            room: !promised.top(),
            m_tvalid: is_there,
            m_tdata: oldest.low(queue.data.width()),
            m_tlast: oldest.top(),
        }
    })
}
