//! Queue between a pipeline that cannot stall and a receiver that can.

use crate::kernel::*;
use crate::unit::block_memory::BlockMemory;

/// Keeps the pixels of a pipeline in order until an AXI4-Stream receiver takes them, and says when the pipeline may be given another one.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `started` | in | a pixel goes into the pipeline; only with `room` |
/// | `push`, `data`, `last` | in | a pixel leaves the pipeline; `D` bits |
/// | `room` | out | a pixel that is started now finds a place |
/// | `m_tvalid`, `m_tdata`, `m_tlast` | out | the oldest pixel |
/// | `m_tready` | in | the receiver takes it |
///
/// `C = A + 1`, `E = D + 1`, `E` at most 64. A pixel that is started has its place until it is taken, so what is pushed always finds one. A pixel pushed at
/// clock t is on the output at t + 2 at the earliest. One pixel per clock without a stall if `2^A` is at least the clocks in the pipeline and 4.
pub struct PixelFifo<const A: usize, const C: usize, const D: usize, const E: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// A pixel goes into the pipeline.
    pub started: Signal<In, Bit>,
    /// A pixel leaves the pipeline.
    pub push: Signal<In, Bit>,
    /// The pixel.
    pub data: Signal<In, Word<D>>,
    /// Last pixel of a packet.
    pub last: Signal<In, Bit>,
    /// The receiver takes the pixel on the output.
    pub m_tready: Signal<In, Bit>,
    /// A pixel may be started.
    pub room: Signal<Out, Bit>,
    /// A pixel is on the output.
    pub m_tvalid: Signal<Out, Bit>,
    /// The pixel.
    pub m_tdata: Signal<Out, Word<D>>,
    /// Last pixel of a packet.
    pub m_tlast: Signal<Out, Bit>,
    store: BlockMemory<A, E>,
    joined: Signal<Local, Word<E>>,
    plain: Signal<Local, Word<E>>,
    taken: Signal<Local, Bit>,
    next_read: Signal<Local, Word<C>>,
    read: DFF<Word<C>>,
    written: DFF<Word<C>>,
    promised: DFF<Word<C>>,
    is_there: DFF<Bit>,
    last_bit: Constant<Word<E>>,
    last_place: Constant<Word<8>>,
    full_place: Constant<Word<8>>,
    one: Constant<Word<C>>,
    _asleep: bool,
}

block! {
    [const A: usize, const C: usize, const D: usize, const E: usize] PixelFifo [A, C, D, E]
    inputs { clock, started, push, data, last, m_tready }
    parts { room, m_tvalid, m_tdata, m_tlast, store, joined, plain, taken, next_read, read,
        written, promised, is_there, last_bit, last_place, full_place, one }
    data { }
}

impl<const A: usize, const C: usize, const D: usize, const E: usize> PixelFifo<A, C, D, E> {
    /// A queue behind a pipeline of at most `flight` clocks.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other, or the queue is too short to keep the pipeline full.
    pub fn new(flight: usize) -> Self {
        assert!(C == A + 1 && E == D + 1, "C = A + 1 and E = D + 1");
        assert!(
            1 << A >= flight + 4,
            "a queue of 2^{A} pixels behind {flight} clocks: accepted are {} at least",
            flight + 4
        );
        fields! {
            [clock, started, push, data, last, m_tready, room, m_tvalid, m_tdata, m_tlast, joined,
                plain, taken, next_read, read, written, promised, is_there]
            store: BlockMemory::new(),
            last_bit: constant(1 << D),
            last_place: constant(D as u64),
            full_place: constant(A as u64),
            one: constant(1),
        }
    }

    /// Clocks from a push to the output, when nothing waits before it.
    pub const fn latency() -> usize {
        2
    }
}

impl<const A: usize, const C: usize, const D: usize, const E: usize> Logic
    for PixelFifo<A, C, D, E>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("pixel_fifo");
        dff_setup!(self, clock, read, written, promised, is_there);
        self.taken.next = self.is_there.q.val() & self.m_tready.val();
        self.next_read.next = self.read.q.val();
        if self.taken.val() {
            self.next_read.next = self.read.q.val() + self.one.val();
        }
        self.read.d.next = self.next_read.val();
        // A word that is written in this clock cannot be read in it.
        self.is_there.d.next = self.next_read.val() != self.written.q.val();
        self.plain.next = bit_cast::<E, D>(self.data.val());
        self.joined.next = self.plain.val();
        if self.last.val() {
            self.joined.next = self.plain.val() | self.last_bit.val();
        }
        self.store.clock.next = self.clock.val();
        self.store.write.next = self.push.val();
        self.store.write_address.next = self.written.q.val().get_bits::<A>(0);
        self.store.write_data.next = self.joined.val();
        self.store.read_address.next = self.next_read.val().get_bits::<A>(0);
        if self.push.val() {
            self.written.d.next = self.written.q.val() + self.one.val();
        }
        if self.started.val() & !self.taken.val() {
            self.promised.d.next = self.promised.q.val() + self.one.val();
        }
        if self.taken.val() & !self.started.val() {
            self.promised.d.next = self.promised.q.val() - self.one.val();
        }
        // No more than 2^A places are promised, so one bit tells whether all are.
        self.room.next = !self.promised.q.val().get_bit(self.full_place.val().index());
        self.m_tvalid.next = self.is_there.q.val();
        self.m_tdata.next = self.store.read_data.val().get_bits::<D>(0);
        self.m_tlast.next = self
            .store
            .read_data
            .val()
            .get_bit(self.last_place.val().index());
    }
}

clocked!(PixelFifo<const A: usize, const C: usize, const D: usize, const E: usize>);
