//! Smoothing filter behind the shading.

use super::three_taps::ThreeTaps;
use crate::kernel::*;
use crate::unit::block_memory::BlockMemory;

/// Colours of a pixel.
const CHANNELS: usize = 3;

/// Smooths a picture that comes line by line: 2 x 2 box, 3 x 3 binomial, or nothing.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `kernel` | in | 2 bits: 0 pass, 1 box of 2 x 2, 2 and 3 binomial of 3 x 3; read with the first pixel of a picture |
/// | `valid` | in | this clock carries a pixel |
/// | `x`, `y` | in | 12 bits, the pixel; `x` below `2^A` |
/// | `line_end`, `last` | in | last pixel of its line, of the picture |
/// | `r`, `g`, `b` | in | 8 bits |
/// | `out_valid`, `out_x`, `out_y`, `out_line_end`, `out_last` | out | the same of the smooth picture |
/// | `out_r`, `out_g`, `out_b` | out | 8 bits, rounded to the nearest, halves up |
///
/// Pixels outside the picture are the nearest inside. A pixel leaves 3 clocks after the one to the right of it in the next line came, and the last of a line
/// 1 clock after the one before it: a line leaves while the next one comes, the last line by itself from 2 clocks after the last pixel on. After a picture
/// there are `width + 2` clocks or more without a pixel, after a line 1 or more. With every kernel the same clocks, so it can change from picture to picture.
pub struct PostFilter<const A: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Which weights.
    pub kernel: Signal<In, Word<2>>,
    /// This clock carries a pixel.
    pub valid: Signal<In, Bit>,
    /// Column.
    pub x: Signal<In, Word<12>>,
    /// Line.
    pub y: Signal<In, Word<12>>,
    /// Last pixel of the line.
    pub line_end: Signal<In, Bit>,
    /// Last pixel of the picture.
    pub last: Signal<In, Bit>,
    /// Red.
    pub r: Signal<In, Word<8>>,
    /// Green.
    pub g: Signal<In, Word<8>>,
    /// Blue.
    pub b: Signal<In, Word<8>>,
    /// A smooth pixel is there.
    pub out_valid: Signal<Out, Bit>,
    /// Its column.
    pub out_x: Signal<Out, Word<12>>,
    /// Its line.
    pub out_y: Signal<Out, Word<12>>,
    /// Last pixel of the line.
    pub out_line_end: Signal<Out, Bit>,
    /// Last pixel of the picture.
    pub out_last: Signal<Out, Bit>,
    /// Red of the smooth pixel.
    pub out_r: Signal<Out, Word<8>>,
    /// Green of the smooth pixel.
    pub out_g: Signal<Out, Word<8>>,
    /// Blue of the smooth pixel.
    pub out_b: Signal<Out, Word<8>>,
    store: BlockMemory<A, 48>,
    vertical: Vec<ThreeTaps<8, 10>>,
    horizontal: Vec<ThreeTaps<10, 12>>,
    // The pixel that comes, or the place below the last line.
    at_origin: Signal<Local, Bit>,
    now_kernel: Signal<Local, Word<2>>,
    kept_kernel: DFF<Word<2>>,
    waits: DFF<Bit>,
    flushes: DFF<Bit>,
    flush_x: DFF<Word<12>>,
    flush_y: DFF<Word<12>>,
    right: DFF<Word<12>>,
    flush_ends: Signal<Local, Bit>,
    now_x: Signal<Local, Word<12>>,
    now_y: Signal<Local, Word<12>>,
    now_ends: Signal<Local, Bit>,
    wide_r: Signal<Local, Word<24>>,
    wide_g: Signal<Local, Word<24>>,
    wide_b: Signal<Local, Word<24>>,
    high_r: Signal<Local, Word<24>>,
    high_g: Signal<Local, Word<24>>,
    // Beside what the line store gives.
    step_1: DFF<Bit>,
    flush_1: DFF<Bit>,
    ends_1: DFF<Bit>,
    x_1: DFF<Word<12>>,
    y_1: DFF<Word<12>>,
    kernel_1: DFF<Word<2>>,
    colour_1: DFF<Word<24>>,
    one_up: Signal<Local, Word<24>>,
    two_up: Signal<Local, Word<24>>,
    wide_new: Signal<Local, Word<48>>,
    wide_old: Signal<Local, Word<48>>,
    high_old: Signal<Local, Word<48>>,
    above: Signal<Local, Word<24>>,
    below: Signal<Local, Word<24>>,
    above_part: Vec<Signal<Local, Word<8>>>,
    here_part: Vec<Signal<Local, Word<8>>>,
    below_part: Vec<Signal<Local, Word<8>>>,
    // A column of three lines.
    step_2: DFF<Bit>,
    ends_2: DFF<Bit>,
    last_2: DFF<Bit>,
    x_2: DFF<Word<12>>,
    y_2: DFF<Word<12>>,
    kernel_2: DFF<Word<2>>,
    column_2: Vec<DFF<Word<10>>>,
    is_left: Signal<Local, Bit>,
    // The column in the middle of the window, and the one before it.
    ends_3: DFF<Bit>,
    last_3: DFF<Bit>,
    left_3: DFF<Bit>,
    x_3: DFF<Word<12>>,
    y_3: DFF<Word<12>>,
    kernel_3: DFF<Word<2>>,
    column_3: Vec<DFF<Word<10>>>,
    before_3: Vec<DFF<Word<10>>>,
    leaves: Signal<Local, Bit>,
    rounded: Vec<Signal<Local, Word<12>>>,
    // The outputs.
    valid_4: DFF<Bit>,
    ends_4: DFF<Bit>,
    last_4: DFF<Bit>,
    x_4: DFF<Word<12>>,
    y_4: DFF<Word<12>>,
    colour_4: Vec<DFF<Word<8>>>,
    zero: Constant<Word<12>>,
    one: Constant<Word<12>>,
    half: Constant<Word<12>>,
    place: Vec<Constant<Word<5>>>,
    line_place: Constant<Word<6>>,
    _channels: usize,
    _asleep: bool,
}

block! {
    [const A: usize] PostFilter [A]
    inputs { clock, kernel, valid, x, y, line_end, last, r, g, b }
    parts { out_valid, out_x, out_y, out_line_end, out_last, out_r, out_g, out_b, store, vertical,
        horizontal, at_origin, now_kernel, kept_kernel, waits, flushes, flush_x, flush_y, right,
        flush_ends, now_x, now_y, now_ends, wide_r, wide_g, wide_b, high_r, high_g, step_1,
        flush_1, ends_1, x_1, y_1, kernel_1, colour_1, one_up, two_up, wide_new, wide_old,
        high_old, above, below, above_part, here_part, below_part, step_2, ends_2, last_2, x_2,
        y_2, kernel_2, column_2, is_left, ends_3, last_3, left_3, x_3, y_3, kernel_3, column_3,
        before_3, leaves, rounded, valid_4, ends_4, last_4, x_4, y_4, colour_4, zero, one, half,
        place, line_place }
    data { _channels }
}

impl<const A: usize> PostFilter<A> {
    /// A filter for lines of at most `2^A` pixels.
    pub fn new() -> Self {
        fields! {
            [clock, kernel, valid, x, y, line_end, last, r, g, b, out_valid, out_x, out_y,
                out_line_end, out_last, out_r, out_g, out_b, at_origin, now_kernel, kept_kernel,
                waits, flushes, flush_x, flush_y, right, flush_ends, now_x, now_y, now_ends,
                wide_r, wide_g, wide_b, high_r, high_g, step_1, flush_1, ends_1, x_1, y_1,
                kernel_1, colour_1, one_up, two_up, wide_new, wide_old, high_old, above, below,
                step_2, ends_2, last_2, x_2, y_2, kernel_2, is_left, ends_3, last_3, left_3, x_3,
                y_3, kernel_3, leaves, valid_4, ends_4, last_4, x_4, y_4]
            store: BlockMemory::new(),
            vertical: repeat(CHANNELS, ThreeTaps::new),
            horizontal: repeat(CHANNELS, ThreeTaps::new),
            above_part: repeat(CHANNELS, Signal::default),
            here_part: repeat(CHANNELS, Signal::default),
            below_part: repeat(CHANNELS, Signal::default),
            column_2: repeat(CHANNELS, DFF::default),
            column_3: repeat(CHANNELS, DFF::default),
            before_3: repeat(CHANNELS, DFF::default),
            rounded: repeat(CHANNELS, Signal::default),
            colour_4: repeat(CHANNELS, DFF::default),
            zero: constant(0),
            one: constant(1),
            half: constant(8),
            place: [16, 8, 0].map(constant).into(),
            line_place: constant(24),
            _channels: CHANNELS,
        }
    }

    /// Clocks from the pixel to the right in the next line.
    pub const fn latency() -> usize {
        3
    }
}

impl<const A: usize> Default for PostFilter<A> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const A: usize> Logic for PostFilter<A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("post_filter");
        dff_setup!(
            self,
            clock,
            kept_kernel,
            waits,
            flushes,
            flush_x,
            flush_y,
            right,
            step_1,
            flush_1,
            ends_1,
            x_1,
            y_1,
            kernel_1,
            colour_1,
            step_2,
            ends_2,
            last_2,
            x_2,
            y_2,
            kernel_2,
            ends_3,
            last_3,
            left_3,
            x_3,
            y_3,
            kernel_3,
            valid_4,
            ends_4,
            last_4,
            x_4,
            y_4
        );
        self.at_origin.next = (self.x.val() == self.zero.val()) & (self.y.val() == self.zero.val());
        self.now_kernel.next = self.kept_kernel.q.val();
        if self.valid.val() & self.at_origin.val() {
            self.now_kernel.next = self.kernel.val();
        }
        self.kept_kernel.d.next = self.now_kernel.val();
        // The line store reads the first pixel of the last line when it has been written, also if it is the last.
        self.flush_ends.next = self.flush_x.q.val() == self.right.q.val();
        self.waits.d.next = self.valid.val() & self.last.val();
        if self.valid.val() & self.last.val() {
            self.right.d.next = self.x.val();
            self.flush_y.d.next = self.y.val() + self.one.val();
        }
        if self.waits.q.val() {
            self.flushes.d.next = true;
            self.flush_x.d.next = self.zero.val();
        } else if self.flushes.q.val() {
            self.flushes.d.next = !self.flush_ends.val();
            self.flush_x.d.next = self.flush_x.q.val() + self.one.val();
        }
        self.now_x.next = self.x.val();
        self.now_y.next = self.y.val();
        self.now_ends.next = self.line_end.val();
        if self.flushes.q.val() {
            self.now_x.next = self.flush_x.q.val();
            self.now_y.next = self.flush_y.q.val();
            self.now_ends.next = self.flush_ends.val();
        }
        self.wide_r.next = bit_cast::<24, 8>(self.r.val());
        self.wide_g.next = bit_cast::<24, 8>(self.g.val());
        self.wide_b.next = bit_cast::<24, 8>(self.b.val());
        self.high_r.next = self.wide_r.val() << self.place[0].val();
        self.high_g.next = self.wide_g.val() << self.place[1].val();
        self.step_1.d.next = self.valid.val() | self.flushes.q.val();
        self.flush_1.d.next = self.flushes.q.val();
        self.ends_1.d.next = self.now_ends.val();
        self.x_1.d.next = self.now_x.val();
        self.y_1.d.next = self.now_y.val();
        self.kernel_1.d.next = self.now_kernel.val();
        self.colour_1.d.next = self.high_r.val() | self.high_g.val() | self.wide_b.val();
        // A word of the store has the pixels of two lines; the older one goes out when a new one comes in.
        self.one_up.next = self.store.read_data.val().get_bits::<24>(0);
        self.two_up.next = self.store.read_data.val().get_bits::<24>(24);
        self.wide_new.next = bit_cast::<48, 24>(self.colour_1.q.val());
        self.wide_old.next = bit_cast::<48, 24>(self.one_up.val());
        self.high_old.next = self.wide_old.val() << self.line_place.val();
        self.store.clock.next = self.clock.val();
        self.store.read_address.next = self.now_x.val().get_bits::<A>(0);
        self.store.write.next = self.step_1.q.val() & !self.flush_1.q.val();
        self.store.write_address.next = self.x_1.q.val().get_bits::<A>(0);
        self.store.write_data.next = self.high_old.val() | self.wide_new.val();
        self.above.next = self.two_up.val();
        if self.y_1.q.val() == self.one.val() {
            self.above.next = self.one_up.val();
        }
        self.below.next = self.colour_1.q.val();
        if self.flush_1.q.val() {
            self.below.next = self.one_up.val();
        }
        self.step_2.d.next = self.step_1.q.val() & (self.y_1.q.val() != self.zero.val());
        self.ends_2.d.next = self.ends_1.q.val();
        self.last_2.d.next = self.flush_1.q.val();
        self.x_2.d.next = self.x_1.q.val();
        self.y_2.d.next = self.y_1.q.val() - self.one.val();
        self.kernel_2.d.next = self.kernel_1.q.val();
        self.is_left.next = self.x_2.q.val() == self.zero.val();
        // The last column leaves by itself, any other when the next one comes.
        self.leaves.next = self.ends_3.q.val() | (self.step_2.q.val() & !self.is_left.val());
        self.ends_3.d.next = self.step_2.q.val() & self.ends_2.q.val();
        if self.step_2.q.val() {
            self.last_3.d.next = self.last_2.q.val();
            self.left_3.d.next = self.is_left.val();
            self.x_3.d.next = self.x_2.q.val();
            self.y_3.d.next = self.y_2.q.val();
            self.kernel_3.d.next = self.kernel_2.q.val();
        }
        self.valid_4.d.next = self.leaves.val();
        self.ends_4.d.next = self.ends_3.q.val();
        self.last_4.d.next = self.ends_3.q.val() & self.last_3.q.val();
        self.x_4.d.next = self.x_3.q.val();
        self.y_4.d.next = self.y_3.q.val();
        for i in 0..self._channels {
            self.column_2[i].clock.next = self.clock.val();
            self.column_3[i].clock.next = self.clock.val();
            self.before_3[i].clock.next = self.clock.val();
            self.colour_4[i].clock.next = self.clock.val();
            self.above_part[i].next = self.above.val().get_bits::<8>(self.place[i].val().index());
            self.here_part[i].next = self.one_up.val().get_bits::<8>(self.place[i].val().index());
            self.below_part[i].next = self.below.val().get_bits::<8>(self.place[i].val().index());
            self.vertical[i].earlier.next = self.above_part[i].val();
            self.vertical[i].here.next = self.here_part[i].val();
            self.vertical[i].later.next = self.below_part[i].val();
            self.vertical[i].kernel.next = self.kernel_1.q.val();
            self.column_2[i].d.next = self.vertical[i].sum.val();
            self.column_3[i].d.next = self.column_3[i].q.val();
            self.before_3[i].d.next = self.before_3[i].q.val();
            if self.step_2.q.val() {
                self.column_3[i].d.next = self.column_2[i].q.val();
                self.before_3[i].d.next = self.column_3[i].q.val();
            }
            self.horizontal[i].earlier.next = self.before_3[i].q.val();
            if self.left_3.q.val() {
                self.horizontal[i].earlier.next = self.column_3[i].q.val();
            }
            self.horizontal[i].here.next = self.column_3[i].q.val();
            self.horizontal[i].later.next = self.column_2[i].q.val();
            if self.ends_3.q.val() {
                self.horizontal[i].later.next = self.column_3[i].q.val();
            }
            self.horizontal[i].kernel.next = self.kernel_3.q.val();
            self.rounded[i].next = self.horizontal[i].sum.val() + self.half.val();
            self.colour_4[i].d.next = self.rounded[i].val().get_bits::<8>(4);
        }
        self.out_valid.next = self.valid_4.q.val();
        self.out_x.next = self.x_4.q.val();
        self.out_y.next = self.y_4.q.val();
        self.out_line_end.next = self.ends_4.q.val();
        self.out_last.next = self.last_4.q.val();
        self.out_r.next = self.colour_4[0].q.val();
        self.out_g.next = self.colour_4[1].q.val();
        self.out_b.next = self.colour_4[2].q.val();
    }
}

clocked!(PostFilter<const A: usize>);
