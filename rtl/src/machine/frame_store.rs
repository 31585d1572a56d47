//! Two frames: one is shown while the other arrives.

use super::pixel_place::PixelPlace;
use crate::kernel::*;
use crate::unit::block_memory::BlockMemory;
use crate::unit::delay::WordDelay;

/// Shows the last whole frame that came in over AXI4-Stream; another one takes its place in the vertical blanking.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `width` | in | 12 bits, pixels of a line |
/// | `s_tvalid`, `s_tready` | in, out | a pixel comes in |
/// | `s_tdata` | in | 24 bits: red in 23..16, green in 15..8, blue in 7..0 |
/// | `s_tuser` | in | 24 bits: line in 23..12, column in 11..0 |
/// | `s_tlast` | in | last pixel of the frame |
/// | `retrace` | in | first clock of the vertical blanking |
/// | `need`, `x`, `y` | in | a pixel to show; 12 bits |
/// | `valid`, `r`, `g`, `b` | out | the pixel; 8 bits |
/// | `swapped` | out | another frame is shown from now on |
///
/// Width times height is at most `2^A`. Latency 3. Pixels of a frame come in any order. After the last one `s_tready` is low until the next `retrace`, where
/// the frames change places; a `retrace` before it changes nothing. At power-up both frames are black.
pub struct FrameStore<const A: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Pixels of a line.
    pub width: Signal<In, Word<12>>,
    /// A pixel comes in.
    pub s_tvalid: Signal<In, Bit>,
    /// Its colour.
    pub s_tdata: Signal<In, Word<24>>,
    /// Its place on the screen.
    pub s_tuser: Signal<In, Word<24>>,
    /// Last pixel of the frame.
    pub s_tlast: Signal<In, Bit>,
    /// First clock of the vertical blanking.
    pub retrace: Signal<In, Bit>,
    /// A pixel to show.
    pub need: Signal<In, Bit>,
    /// Its column.
    pub x: Signal<In, Word<12>>,
    /// Its line.
    pub y: Signal<In, Word<12>>,
    /// The pixel that comes in is taken.
    pub s_tready: Signal<Out, Bit>,
    /// A pixel is shown.
    pub valid: Signal<Out, Bit>,
    /// Red.
    pub r: Signal<Out, Word<8>>,
    /// Green.
    pub g: Signal<Out, Word<8>>,
    /// Blue.
    pub b: Signal<Out, Word<8>>,
    /// Another frame is shown from now on.
    pub swapped: Signal<Out, Bit>,
    write_place: PixelPlace,
    read_place: PixelPlace,
    late_taken: WordDelay<Bit>,
    late_data: WordDelay<Word<24>>,
    late_write_bank: WordDelay<Bit>,
    late_need: WordDelay<Bit>,
    late_read_bank: WordDelay<Bit>,
    first_bank: BlockMemory<A, 24>,
    second_bank: BlockMemory<A, 24>,
    taken: Signal<Local, Bit>,
    swaps: Signal<Local, Bit>,
    colour: Signal<Local, Word<24>>,
    second_is_shown: DFF<Bit>,
    is_whole: DFF<Bit>,
    kept_swapped: DFF<Bit>,
    _asleep: bool,
}

block! {
    [const A: usize] FrameStore [A]
    inputs { clock, width, s_tvalid, s_tdata, s_tuser, s_tlast, retrace, need, x, y }
    parts { s_tready, valid, r, g, b, swapped, write_place, read_place, late_taken,
        late_data, late_write_bank, late_need, late_read_bank, first_bank, second_bank, taken,
        swaps, colour, second_is_shown, is_whole, kept_swapped }
    data { }
}

impl<const A: usize> FrameStore<A> {
    /// Two frames of `2^A` pixels.
    pub fn new() -> Self {
        Self::of_address_bits(A)
    }

    /// Two frames of `2^bits` pixels.
    ///
    /// # Panics
    ///
    /// When `bits` is not in `1..=A`.
    pub fn of_address_bits(bits: usize) -> Self {
        fields! {
            [clock, width, s_tvalid, s_tdata, s_tuser, s_tlast, retrace, need, x, y, s_tready,
                valid, r, g, b, swapped, taken, swaps, colour, second_is_shown, is_whole,
                kept_swapped]
            write_place: PixelPlace::new(),
            read_place: PixelPlace::new(),
            late_taken: WordDelay::new(2),
            late_data: WordDelay::new(2),
            late_write_bank: WordDelay::new(2),
            late_need: WordDelay::new(3),
            late_read_bank: WordDelay::new(3),
            first_bank: BlockMemory::of_address_bits(bits),
            second_bank: BlockMemory::of_address_bits(bits),
        }
    }

    /// Clocks from `need` to its pixel.
    pub const fn latency() -> usize {
        3
    }
}

impl<const A: usize> Default for FrameStore<A> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const A: usize> Logic for FrameStore<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("frame_store");
        dff_setup!(self, clock, second_is_shown, is_whole, kept_swapped);
        self.taken.next = self.s_tvalid.val() & !self.is_whole.q.val();
        self.swaps.next = self.retrace.val() & self.is_whole.q.val();
        if self.taken.val() & self.s_tlast.val() {
            self.is_whole.d.next = true;
        }
        if self.swaps.val() {
            self.is_whole.d.next = false;
            self.second_is_shown.d.next = !self.second_is_shown.q.val();
        }
        self.kept_swapped.d.next = self.swaps.val();
        self.write_place.clock.next = self.clock.val();
        self.write_place.x.next = self.s_tuser.val().get_bits::<12>(0);
        self.write_place.y.next = self.s_tuser.val().get_bits::<12>(12);
        self.write_place.width.next = self.width.val();
        self.late_taken.clock.next = self.clock.val();
        self.late_taken.word.next = self.taken.val();
        self.late_data.clock.next = self.clock.val();
        self.late_data.word.next = self.s_tdata.val();
        // The bank goes with the pixel: the frames may change places while the last pixel is on its way.
        self.late_write_bank.clock.next = self.clock.val();
        self.late_write_bank.word.next = self.second_is_shown.q.val();
        self.first_bank.clock.next = self.clock.val();
        self.first_bank.write.next = self.late_taken.late.val() & self.late_write_bank.late.val();
        self.first_bank.write_address.next = self.write_place.place.val().get_bits::<A>(0);
        self.first_bank.write_data.next = self.late_data.late.val();
        self.first_bank.read_address.next = self.read_place.place.val().get_bits::<A>(0);
        self.second_bank.clock.next = self.clock.val();
        self.second_bank.write.next = self.late_taken.late.val() & !self.late_write_bank.late.val();
        self.second_bank.write_address.next = self.write_place.place.val().get_bits::<A>(0);
        self.second_bank.write_data.next = self.late_data.late.val();
        self.second_bank.read_address.next = self.read_place.place.val().get_bits::<A>(0);
        self.read_place.clock.next = self.clock.val();
        self.read_place.x.next = self.x.val();
        self.read_place.y.next = self.y.val();
        self.read_place.width.next = self.width.val();
        self.late_need.clock.next = self.clock.val();
        self.late_need.word.next = self.need.val();
        self.late_read_bank.clock.next = self.clock.val();
        self.late_read_bank.word.next = self.second_is_shown.q.val();
        self.colour.next = self.first_bank.read_data.val();
        if self.late_read_bank.late.val() {
            self.colour.next = self.second_bank.read_data.val();
        }
        self.s_tready.next = !self.is_whole.q.val();
        self.valid.next = self.late_need.late.val();
        self.r.next = self.colour.val().get_bits::<8>(16);
        self.g.next = self.colour.val().get_bits::<8>(8);
        self.b.next = self.colour.val().get_bits::<8>(0);
        self.swapped.next = self.kept_swapped.q.val();
    }
}

clocked!(FrameStore<const A: usize>);
