//! Programmable elementary processor: one of second degree, or four of first degree.

use super::split_adder::SplitAdder;
use crate::kernel::*;

/// One second-degree processor of `F = 2 W` bits, or four first-degree processors of `W` bits with the decision on their signs.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line` | in | raster flags |
/// | `split` | in | four of first degree; read with the coefficients |
/// | `used` | in | 4 bits, lanes that the decision asks; read with the coefficients |
/// | `a2`, `b2`, `c`, `i0`, `p0`, `f` | in | `F` bits, of second degree as for pe2; split, halves of `W` bits, low half first: lanes 0 and 1 take a from `b2`, b from `i0`, c from `f`; lanes 2 and 3 take a from `a2`, b from `c`, c from `p0` |
/// | `value` | out | `F` bits, of second degree |
/// | `lane_0` .. `lane_3` | out | `W` bits, of first degree |
/// | `is_inside` | out | no used lane, or not the value, is negative; one clock after them |
///
/// Latency 1, the decision 2. The coefficients are read on a clock with `valid` and `start` only. The eight registers of a pe2 hold
/// exactly the words of four pe1; added are an AND in each carry chain, one choice of an addend and the decision. Chaillou 1991, IV.1.7.
pub struct ProgrammablePe<const W: usize, const W1: usize, const F: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// This clock carries a pixel.
    pub valid: Signal<In, Bit>,
    /// First pixel of the zone.
    pub start: Signal<In, Bit>,
    /// First pixel of a later line.
    pub line: Signal<In, Bit>,
    /// Four of first degree.
    pub split: Signal<In, Bit>,
    /// Lanes that the decision asks.
    pub used: Signal<In, Word<4>>,
    /// Second difference along the line.
    pub a2: Signal<In, Int<F>>,
    /// Second difference from line to line.
    pub b2: Signal<In, Int<F>>,
    /// Mixed difference.
    pub c: Signal<In, Int<F>>,
    /// Increment from the first line to the second.
    pub i0: Signal<In, Int<F>>,
    /// Increment from the first pixel to the second.
    pub p0: Signal<In, Int<F>>,
    /// Value of the first pixel.
    pub f: Signal<In, Int<F>>,
    /// The polynomial of second degree.
    pub value: Signal<Out, Int<F>>,
    /// The polynomial of first degree of lane 0.
    pub lane_0: Signal<Out, Int<W>>,
    /// The polynomial of first degree of lane 1.
    pub lane_1: Signal<Out, Int<W>>,
    /// The polynomial of first degree of lane 2.
    pub lane_2: Signal<Out, Int<W>>,
    /// The polynomial of first degree of lane 3.
    pub lane_3: Signal<Out, Int<W>>,
    /// Nothing asked is negative, one clock later.
    pub is_inside: Signal<Out, Bit>,
    first: Signal<Local, Bit>,
    is_split: Signal<Local, Bit>,
    value_step: Signal<Local, Word<F>>,
    next_pixel: SplitAdder<W, W1, F>,
    next_pixel_step: SplitAdder<W, W1, F>,
    next_line: SplitAdder<W, W1, F>,
    next_line_step: SplitAdder<W, W1, F>,
    next_first_step: SplitAdder<W, W1, F>,
    line_begin: Signal<Local, Word<F>>,
    line_begin_step: Signal<Local, Word<F>>,
    first_begin_step: Signal<Local, Word<F>>,
    kept_a2: DFF<Word<F>>,
    kept_b2: DFF<Word<F>>,
    kept_c: DFF<Word<F>>,
    line_value: DFF<Word<F>>,
    line_step: DFF<Word<F>>,
    first_step: DFF<Word<F>>,
    pixel_step: DFF<Word<F>>,
    pixel_value: DFF<Word<F>>,
    kept_split: DFF<Bit>,
    kept_used: DFF<Word<4>>,
    lane_0_out: Signal<Local, Bit>,
    lane_1_out: Signal<Local, Bit>,
    lane_2_out: Signal<Local, Bit>,
    lane_3_out: Signal<Local, Bit>,
    value_out: Signal<Local, Bit>,
    kept_inside: DFF<Bit>,
    half: Constant<Word<8>>,
    half_sign: Constant<Word<8>>,
    sign: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const F: usize] ProgrammablePe [W, W1, F]
    inputs { clock, valid, start, line, split, used, a2, b2, c, i0, p0, f }
    parts { value, lane_0, lane_1, lane_2, lane_3, is_inside, first, is_split, value_step,
        next_pixel, next_pixel_step, next_line, next_line_step, next_first_step, line_begin,
        line_begin_step, first_begin_step, kept_a2, kept_b2, kept_c, line_value, line_step,
        first_step, pixel_step, pixel_value, kept_split, kept_used, lane_0_out, lane_1_out,
        lane_2_out, lane_3_out, value_out, kept_inside, half, half_sign, sign }
    data { }
}

impl<const W: usize, const W1: usize, const F: usize> ProgrammablePe<W, W1, F> {
    /// A processor of two halves of `W` bits.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other.
    pub fn new() -> Self {
        fields! {
            [clock, valid, start, line, split, used, a2, b2, c, i0, p0, f, value, lane_0, lane_1,
                lane_2, lane_3, is_inside, first, is_split, value_step, line_begin,
                line_begin_step, first_begin_step, kept_a2, kept_b2, kept_c, line_value,
                line_step, first_step, pixel_step, pixel_value, kept_split, kept_used, lane_0_out,
                lane_1_out, lane_2_out, lane_3_out, value_out, kept_inside]
            next_pixel: SplitAdder::new(),
            next_pixel_step: SplitAdder::new(),
            next_line: SplitAdder::new(),
            next_line_step: SplitAdder::new(),
            next_first_step: SplitAdder::new(),
            half: constant(W as u64),
            half_sign: constant(W as u64 - 1),
            sign: constant(F as u64 - 1),
        }
    }

    /// Clocks from the flags to the values; the decision comes one later.
    pub const fn latency() -> usize {
        1
    }
}

impl<const W: usize, const W1: usize, const F: usize> Default for ProgrammablePe<W, W1, F> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize, const W1: usize, const F: usize> Logic for ProgrammablePe<W, W1, F> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("programmable_pe");
        dff_setup!(
            self,
            clock,
            kept_a2,
            kept_b2,
            kept_c,
            line_value,
            line_step,
            first_step,
            pixel_step,
            pixel_value,
            kept_split,
            kept_used,
            kept_inside
        );
        self.is_split.next = self.kept_split.q.val();
        if self.is_split.val() {
            self.value_step.next = self.kept_b2.q.val();
        } else {
            self.value_step.next = self.pixel_step.q.val();
        }
        self.next_pixel.a.next = self.pixel_value.q.val();
        self.next_pixel.b.next = self.value_step.val();
        self.next_pixel.split.next = self.is_split.val();
        self.next_pixel_step.a.next = self.pixel_step.q.val();
        self.next_pixel_step.b.next = self.kept_a2.q.val();
        self.next_pixel_step.split.next = self.is_split.val();
        self.next_line.a.next = self.line_value.q.val();
        self.next_line.b.next = self.line_step.q.val();
        self.next_line.split.next = self.is_split.val();
        self.next_line_step.a.next = self.line_step.q.val();
        self.next_line_step.b.next = self.kept_b2.q.val();
        self.next_line_step.split.next = self.is_split.val();
        self.next_first_step.a.next = self.first_step.q.val();
        self.next_first_step.b.next = self.kept_c.q.val();
        self.next_first_step.split.next = self.is_split.val();
        self.first.next = self.start.val() | self.line.val();
        if self.start.val() {
            self.line_begin.next = unsigned_cast(self.f.val());
            self.line_begin_step.next = unsigned_cast(self.i0.val());
            self.first_begin_step.next = unsigned_cast(self.p0.val());
        } else {
            self.line_begin.next = self.next_line.sum.val();
            self.first_begin_step.next = self.next_first_step.sum.val();
            // Split, the increment of a line is the coefficient itself.
            if self.is_split.val() {
                self.line_begin_step.next = self.line_step.q.val();
            } else {
                self.line_begin_step.next = self.next_line_step.sum.val();
            }
        }
        if self.valid.val() {
            if self.start.val() {
                self.kept_a2.d.next = unsigned_cast(self.a2.val());
                self.kept_b2.d.next = unsigned_cast(self.b2.val());
                self.kept_c.d.next = unsigned_cast(self.c.val());
                self.kept_split.d.next = self.split.val();
                self.kept_used.d.next = self.used.val();
            }
            if self.first.val() {
                self.line_value.d.next = self.line_begin.val();
                self.pixel_value.d.next = self.line_begin.val();
                self.line_step.d.next = self.line_begin_step.val();
                self.first_step.d.next = self.first_begin_step.val();
                self.pixel_step.d.next = self.first_begin_step.val();
            } else {
                self.pixel_value.d.next = self.next_pixel.sum.val();
                self.pixel_step.d.next = self.next_pixel_step.sum.val();
            }
        }
        self.lane_0_out.next = self
            .pixel_value
            .q
            .val()
            .get_bit(self.half_sign.val().index())
            & self.kept_used.q.val().get_bit(0);
        self.lane_1_out.next = self.pixel_value.q.val().get_bit(self.sign.val().index())
            & self.kept_used.q.val().get_bit(1);
        self.lane_2_out.next = self
            .pixel_step
            .q
            .val()
            .get_bit(self.half_sign.val().index())
            & self.kept_used.q.val().get_bit(2);
        self.lane_3_out.next = self.pixel_step.q.val().get_bit(self.sign.val().index())
            & self.kept_used.q.val().get_bit(3);
        self.value_out.next = self.pixel_value.q.val().get_bit(self.sign.val().index());
        if self.is_split.val() {
            self.kept_inside.d.next = !(self.lane_0_out.val()
                | self.lane_1_out.val()
                | self.lane_2_out.val()
                | self.lane_3_out.val());
        } else {
            self.kept_inside.d.next = !self.value_out.val();
        }
        self.value.next = signed_cast(self.pixel_value.q.val());
        self.lane_0.next = signed_cast(self.pixel_value.q.val().get_bits::<W>(0));
        self.lane_1.next = signed_cast(
            self.pixel_value
                .q
                .val()
                .get_bits::<W>(self.half.val().index()),
        );
        self.lane_2.next = signed_cast(self.pixel_step.q.val().get_bits::<W>(0));
        self.lane_3.next = signed_cast(
            self.pixel_step
                .q
                .val()
                .get_bits::<W>(self.half.val().index()),
        );
        self.is_inside.next = self.kept_inside.q.val();
    }
}

clocked!(ProgrammablePe<const W: usize, const W1: usize, const F: usize>);
