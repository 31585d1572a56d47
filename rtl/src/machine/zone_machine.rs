//! Zone machine: from the command stream to shaded pixels.

use super::pixel_fifo::PixelFifo;
use super::sample_mean::SampleMean;
use super::shading_processor::ShadingProcessor;
use super::zone_core::{ZoneCore, ZoneShape};
use crate::kernel::*;
use crate::unit::block_memory::BlockMemory;
use crate::unit::delay::WordDelay;

/// Bits of the queue behind the shading processor.
const QUEUE_BITS: usize = 6;

/// Draws scenes of any number of objects with a few processors, zone by zone, and shades what is visible.
///
/// Widths: `W1 = W + 1`, `S = W + 2`, `F = 2 W`, `P = W + 12`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `s_tvalid`, `s_tready`, `s_tdest`, `s_tuser`, `s_tdata` | in, out | command stream, as for the zone control |
/// | `m_tvalid`, `m_tready` | out, in | a pixel leaves |
/// | `m_tdata` | out | 24 bits: red in 23..16, green in 15..8, blue in 7..0 |
/// | `m_tuser` | out | 24 bits: line in 23..12, column in 11..0 |
/// | `m_tlast` | out | last pixel of the frame |
///
/// With `samples` of 2 or 4 the means of 2 x 2 or 4 x 4 samples leave, after the last pass over a zone. Pixels leave in the order of the zones, line by line in each. While the receiver stalls, the showing pass waits; drawing goes on.
pub struct ZoneMachine<
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
    /// The receiver takes a pixel.
    pub m_tready: Signal<In, Bit>,
    /// The beat is taken.
    pub s_tready: Signal<Out, Bit>,
    /// A pixel is there.
    pub m_tvalid: Signal<Out, Bit>,
    /// Its colour.
    pub m_tdata: Signal<Out, Word<24>>,
    /// Its place.
    pub m_tuser: Signal<Out, Word<24>>,
    /// It is the last of the frame.
    pub m_tlast: Signal<Out, Bit>,
    core: ZoneCore<W, W1, S, F, P>,
    materials: BlockMemory<12, 8>,
    shading: ShadingProcessor<W>,
    queue: PixelFifo<QUEUE_BITS, { QUEUE_BITS + 1 }, 48, 49>,
    late_valid: WordDelay<Bit>,
    late_depth: WordDelay<Int<W>>,
    late_nx: WordDelay<Int<16>>,
    late_ny: WordDelay<Int<16>>,
    late_nz: WordDelay<Int<16>>,
    late_flags: WordDelay<Word<16>>,
    late_x: WordDelay<Word<12>>,
    late_y: WordDelay<Word<12>>,
    place_delay: WordDelay<Word<24>>,
    last_delay: WordDelay<Bit>,
    means: Vec<SampleMean>,
    late_sample: Vec<WordDelay<Word<6>>>,
    first_pass_delay: Vec<WordDelay<Bit>>,
    last_pass_delay: Vec<WordDelay<Bit>>,
    pass_ends_delay: Vec<WordDelay<Bit>>,
    column_in_pixel: Signal<Local, Word<2>>,
    line_in_pixel: Signal<Local, Word<2>>,
    red: Signal<Local, Word<8>>,
    green: Signal<Local, Word<8>>,
    blue: Signal<Local, Word<8>>,
    shown_place: Signal<Local, Word<24>>,
    sample_scale: Constant<Word<4>>,
    no_sample: Constant<Word<2>>,
    place: Signal<Local, Word<24>>,
    colour: Signal<Local, Word<24>>,
    line_bit: Constant<Word<8>>,
    green_bit: Constant<Word<8>>,
    red_bit: Constant<Word<8>>,
    place_bit: Constant<Word<8>>,
    _plain: usize,
    _sampled: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize] ZoneMachine [W, W1, S, F, P]
    inputs { clock, s_tvalid, s_tdest, s_tuser, s_tdata, m_tready }
    parts { s_tready, m_tvalid, m_tdata, m_tuser, m_tlast, core, materials, shading, queue, late_valid, late_depth, late_nx, late_ny, late_nz,
        late_flags, late_x, late_y, place_delay, last_delay, means, late_sample, first_pass_delay, last_pass_delay, pass_ends_delay,
        column_in_pixel, line_in_pixel, red, green, blue, shown_place, sample_scale, no_sample, place, colour, line_bit, green_bit, red_bit, place_bit }
    data { _plain, _sampled }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
    ZoneMachine<W, W1, S, F, P>
{
    /// A machine of a shape whose shading processor has `lights` lights.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or a number is out of range.
    pub fn new(shape: &ZoneShape, lights: usize) -> Self {
        let shading = ShadingProcessor::<W>::latency();
        let sampled = usize::from(shape.samples > 1);
        let mean = sampled * SampleMean::latency();
        fields! {
            [clock, s_tvalid, s_tdest, s_tuser, s_tdata, m_tready, s_tready, m_tvalid, m_tdata, m_tuser, m_tlast, place, colour, column_in_pixel, line_in_pixel, red, green, blue, shown_place]
            core: ZoneCore::new(shape, shading + 2 + mean),
            materials: BlockMemory::new(),
            shading: ShadingProcessor::new(lights),
            queue: PixelFifo::new(shading + 2 + mean),
            late_valid: WordDelay::new(1),
            late_depth: WordDelay::new(1),
            late_nx: WordDelay::new(1),
            late_ny: WordDelay::new(1),
            late_nz: WordDelay::new(1),
            late_flags: WordDelay::new(1),
            late_x: WordDelay::new(1),
            late_y: WordDelay::new(1),
            place_delay: WordDelay::new(shading + 1),
            last_delay: WordDelay::new(shading + 1),
            means: repeat(sampled, || SampleMean::new(shape.samples, shape.zone_bits)),
            late_sample: repeat(sampled, || WordDelay::new(1)),
            first_pass_delay: repeat(sampled, || WordDelay::new(shading + 1)),
            last_pass_delay: repeat(sampled, || WordDelay::new(shading + 1)),
            pass_ends_delay: repeat(sampled, || WordDelay::new(shading + 1)),
            sample_scale: constant(u64::from(shape.samples.trailing_zeros())),
            no_sample: constant(0),
            line_bit: constant(12),
            green_bit: constant(8),
            red_bit: constant(16),
            place_bit: constant(24),
            _plain: 1 - sampled,
            _sampled: sampled,
        }
    }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> Logic
    for ZoneMachine<W, W1, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("zone_machine");
        clock!(
            self,
            clock,
            core,
            materials,
            shading,
            queue,
            late_valid,
            late_depth,
            late_nx,
            late_ny,
            late_nz,
            late_flags,
            late_x,
            late_y,
            place_delay,
            last_delay
        );
        self.core.s_tvalid.next = self.s_tvalid.val();
        self.core.s_tdest.next = self.s_tdest.val();
        self.core.s_tuser.next = self.s_tuser.val();
        self.core.s_tdata.next = self.s_tdata.val();
        self.s_tready.next = self.core.s_tready.val();
        // The material of the object is a clock later than the object.
        self.materials.write.next = self.core.load_material.val();
        self.materials.write_address.next = self.core.load_address.val().get_bits::<12>(0);
        self.materials.write_data.next = self.core.load_data.val().get_bits::<8>(0);
        self.materials.read_address.next = self.core.id.val();
        self.late_valid.word.next = self.core.valid.val();
        self.late_depth.word.next = self.core.depth.val();
        self.late_nx.word.next = self.core.nx.val();
        self.late_ny.word.next = self.core.ny.val();
        self.late_nz.word.next = self.core.nz.val();
        self.late_flags.word.next = self.core.source_flags.val();
        self.late_x.word.next = self.core.x.val();
        self.late_y.word.next = self.core.y.val();
        self.shading.load_valid.next = self.core.load_shading.val();
        self.shading.load_address.next = self.core.load_address.val();
        self.shading.load_data.next = self.core.load_data.val().get_bits::<32>(0);
        self.shading.valid.next = self.late_valid.late.val();
        self.shading.depth.next = self.late_depth.late.val();
        self.shading.material.next = self.materials.read_data.val();
        self.shading.nx.next = self.late_nx.late.val();
        self.shading.ny.next = self.late_ny.late.val();
        self.shading.nz.next = self.late_nz.late.val();
        self.shading.flags.next = self.late_flags.late.val();
        self.place.next = bit_cast::<24, 12>(self.core.x.val())
            | (bit_cast::<24, 12>(self.core.y.val()) << self.line_bit.val());
        self.place_delay.word.next = self.place.val();
        self.last_delay.word.next = self.core.frame_ends.val();
        for _i in 0..self._plain {
            self.column_in_pixel.next = self.no_sample.val();
            self.line_in_pixel.next = self.no_sample.val();
            self.core.room.next = self.queue.room.val();
            self.queue.started.next = self.core.started.val();
            self.queue.push.next = self.shading.out_valid.val();
            self.queue.last.next = self.last_delay.late.val();
            self.red.next = self.shading.red.val();
            self.green.next = self.shading.green.val();
            self.blue.next = self.shading.blue.val();
            self.shown_place.next = self.place_delay.late.val();
        }
        for i in 0..self._sampled {
            self.late_sample[i].clock.next = self.clock.val();
            self.first_pass_delay[i].clock.next = self.clock.val();
            self.last_pass_delay[i].clock.next = self.clock.val();
            self.pass_ends_delay[i].clock.next = self.clock.val();
            self.means[i].clock.next = self.clock.val();
            self.late_sample[i].word.next = self.core.sample.val();
            self.column_in_pixel.next = self.late_sample[i].late.val().get_bits::<2>(2);
            self.line_in_pixel.next = self.late_sample[i].late.val().get_bits::<2>(4);
            // Samples before the last pass stay here and want no room.
            self.core.room.next = self.queue.room.val() | !self.core.sample.val().get_bit(1);
            self.queue.started.next = self.core.started.val() & self.core.sample.val().get_bit(1);
            self.first_pass_delay[i].word.next = self.core.sample.val().get_bit(0);
            self.last_pass_delay[i].word.next = self.core.sample.val().get_bit(1);
            self.pass_ends_delay[i].word.next = self.core.pass_ends.val();
            self.means[i].valid.next = self.shading.out_valid.val();
            self.means[i].first_pass.next = self.first_pass_delay[i].late.val();
            self.means[i].last_pass.next = self.last_pass_delay[i].late.val();
            self.means[i].pass_ends.next = self.pass_ends_delay[i].late.val();
            self.means[i].r.next = self.shading.red.val();
            self.means[i].g.next = self.shading.green.val();
            self.means[i].b.next = self.shading.blue.val();
            self.means[i].place.next = self.place_delay.late.val();
            self.means[i].last.next = self.last_delay.late.val();
            self.queue.push.next = self.means[i].out_valid.val();
            self.queue.last.next = self.means[i].out_last.val();
            self.red.next = self.means[i].out_r.val();
            self.green.next = self.means[i].out_g.val();
            self.blue.next = self.means[i].out_b.val();
            self.shown_place.next = self.means[i].out_place.val();
        }
        // The processors count pixels, the shading processor samples.
        self.shading.x.next = (self.late_x.late.val() << self.sample_scale.val())
            | bit_cast::<12, 2>(self.column_in_pixel.val());
        self.shading.y.next = (self.late_y.late.val() << self.sample_scale.val())
            | bit_cast::<12, 2>(self.line_in_pixel.val());
        self.colour.next = bit_cast::<24, 8>(self.blue.val())
            | (bit_cast::<24, 8>(self.green.val()) << self.green_bit.val())
            | (bit_cast::<24, 8>(self.red.val()) << self.red_bit.val());
        self.queue.data.next = bit_cast::<48, 24>(self.colour.val())
            | (bit_cast::<48, 24>(self.shown_place.val()) << self.place_bit.val());
        self.queue.m_tready.next = self.m_tready.val();
        self.m_tvalid.next = self.queue.m_tvalid.val();
        self.m_tdata.next = self.queue.m_tdata.val().get_bits::<24>(0);
        self.m_tuser.next = self
            .queue
            .m_tdata
            .val()
            .get_bits::<24>(self.place_bit.val().index());
        self.m_tlast.next = self.queue.m_tlast.val();
    }
}

clocked!(ZoneMachine<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>);
