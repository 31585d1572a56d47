//! Beam machine that streams its picture.

use super::beam_core::{BeamCore, BeamShape};
use super::frame_loader::FrameLoader;
use super::frame_scan::FrameScan;
use super::pixel_fifo::PixelFifo;
use crate::kernel::*;
use crate::unit::delay::WordDelay;

/// Bits of the queue behind the shading processor.
const QUEUE_BITS: usize = 8;

/// Draws frame after frame over AXI4-Stream, as fast as the receiver takes the pixels: the objects of a beam machine, without a screen's timing.
///
/// Widths: `W1 = W + 1`, `S = W + 2`, `F = 2 W`, `P = W + 12`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `s_tvalid`, `s_tready`, `s_tdest`, `s_tuser`, `s_tdata`, `s_tlast` | in, out | words of the next frame, as for the frame loader |
/// | `m_tvalid`, `m_tready` | out, in | a pixel leaves |
/// | `m_tdata` | out | 24 bits: red in 23..16, green in 15..8, blue in 7..0 |
/// | `m_tuser` | out | first pixel of a frame |
/// | `m_tlast` | out | last pixel of a line |
/// | `swapped` | out | the words of a new frame are at work |
/// | `refused` | out | a frame had more words than the loader keeps |
///
/// Between two frames the pipeline runs empty, and the words of a new frame are copied if its last one has come.
pub struct BeamStream<
    const W: usize,
    const W1: usize,
    const S: usize,
    const F: usize,
    const P: usize,
> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// A beat is there.
    pub s_tvalid: Signal<In, Bit>,
    /// What it carries.
    pub s_tdest: Signal<In, Word<4>>,
    /// Unit and address.
    pub s_tuser: Signal<In, Word<24>>,
    /// Data.
    pub s_tdata: Signal<In, Word<F>>,
    /// Last word of the frame.
    pub s_tlast: Signal<In, Bit>,
    /// The receiver takes a pixel.
    pub m_tready: Signal<In, Bit>,
    /// The word is taken.
    pub s_tready: Signal<Out, Bit>,
    /// A pixel is there.
    pub m_tvalid: Signal<Out, Bit>,
    /// Its colour.
    pub m_tdata: Signal<Out, Word<24>>,
    /// It is the first of a frame.
    pub m_tuser: Signal<Out, Bit>,
    /// It is the last of a line.
    pub m_tlast: Signal<Out, Bit>,
    /// A new frame is at work.
    pub swapped: Signal<Out, Bit>,
    /// A frame was too long.
    pub refused: Signal<Out, Bit>,
    loader: FrameLoader<F>,
    scan: FrameScan,
    core: BeamCore<W, W1, S, F, P>,
    queue: PixelFifo<QUEUE_BITS, { QUEUE_BITS + 1 }, 25, 26>,
    start_delay: WordDelay<Bit>,
    end_delay: WordDelay<Bit>,
    colour: Signal<Local, Word<25>>,
    first: Signal<Local, Word<25>>,
    green_bit: Constant<Word<8>>,
    red_bit: Constant<Word<8>>,
    first_bit: Constant<Word<8>>,
    is_first: Constant<Word<25>>,
    is_not: Constant<Word<25>>,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize] BeamStream [W, W1, S, F, P]
    inputs { clock, s_tvalid, s_tdest, s_tuser, s_tdata, s_tlast, m_tready }
    parts { s_tready, m_tvalid, m_tdata, m_tuser, m_tlast, swapped, refused, loader, scan, core, queue, start_delay, end_delay, colour, first, green_bit,
        red_bit, first_bit, is_first, is_not }
    data { }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
    BeamStream<W, W1, S, F, P>
{
    /// A machine of a shape with `lights` lights for pictures of `width` by `height` pixels.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or a number is out of range.
    pub fn new(shape: &BeamShape, lights: usize, width: usize, height: usize) -> Self {
        let latency = BeamCore::<W, W1, S, F, P>::latency(shape);
        fields! {
            [clock, s_tvalid, s_tdest, s_tuser, s_tdata, s_tlast, m_tready, s_tready, m_tvalid, m_tdata, m_tuser, m_tlast, swapped, refused, colour, first]
            loader: FrameLoader::new(shape.loader_bits),
            scan: FrameScan::new(width, height, latency + 2),
            core: BeamCore::new(shape, lights),
            queue: PixelFifo::new(latency + 1),
            start_delay: WordDelay::new(latency),
            end_delay: WordDelay::new(latency),
            green_bit: constant(8),
            red_bit: constant(16),
            first_bit: constant(24),
            is_first: constant(1 << 24),
            is_not: constant(0),
        }
    }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> Logic
    for BeamStream<W, W1, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("beam_stream");
        clock!(
            self,
            clock,
            loader,
            scan,
            core,
            queue,
            start_delay,
            end_delay
        );
        self.loader.s_tvalid.next = self.s_tvalid.val();
        self.loader.s_tdest.next = self.s_tdest.val();
        self.loader.s_tuser.next = self.s_tuser.val();
        self.loader.s_tdata.next = self.s_tdata.val();
        self.loader.s_tlast.next = self.s_tlast.val();
        self.loader.retrace.next = self.scan.retrace.val();
        self.s_tready.next = self.loader.s_tready.val();
        self.swapped.next = self.loader.take.val();
        self.refused.next = self.loader.refused.val();
        self.scan.room.next = self.queue.room.val();
        self.scan.is_busy.next = self.loader.is_busy.val();
        self.core.valid.next = self.scan.valid.val();
        self.core.start.next = self.scan.start.val();
        self.core.line.next = self.scan.line.val();
        self.core.x.next = self.scan.x.val();
        self.core.y.next = self.scan.y.val();
        self.core.load_object.next = self.loader.load_object.val();
        self.core.load_volume.next = self.loader.load_volume.val();
        self.core.load_shading.next = self.loader.load_shading.val();
        self.core.load_material.next = self.loader.load_material.val();
        self.core.load_unit.next = self.loader.load_unit.val();
        self.core.load_address.next = self.loader.load_address.val();
        self.core.load_data.next = self.loader.load_data.val();
        self.core.take.next = self.loader.take.val();
        self.start_delay.word.next = self.scan.start.val();
        self.end_delay.word.next = self.scan.line_ends.val();
        if self.start_delay.late.val() {
            self.first.next = self.is_first.val();
        } else {
            self.first.next = self.is_not.val();
        }
        self.colour.next = bit_cast::<25, 8>(self.core.blue.val())
            | (bit_cast::<25, 8>(self.core.green.val()) << self.green_bit.val())
            | (bit_cast::<25, 8>(self.core.red.val()) << self.red_bit.val())
            | self.first.val();
        self.queue.started.next = self.scan.issue.val();
        self.queue.push.next = self.core.out_valid.val();
        self.queue.data.next = self.colour.val();
        self.queue.last.next = self.end_delay.late.val();
        self.queue.m_tready.next = self.m_tready.val();
        self.m_tvalid.next = self.queue.m_tvalid.val();
        self.m_tdata.next = self.queue.m_tdata.val().get_bits::<24>(0);
        self.m_tuser.next = self
            .queue
            .m_tdata
            .val()
            .get_bit(self.first_bit.val().index());
        self.m_tlast.next = self.queue.m_tlast.val();
    }
}

clocked!(BeamStream<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>);
