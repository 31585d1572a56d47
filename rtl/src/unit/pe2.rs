//! Second-degree elementary processor.

use crate::kernel::*;

/// Evaluates `value(x, y) = a x^2 + b y^2 + c xy + d x + e y + f mod 2^F` by additions alone, one pixel per clock.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line` | in | raster flags |
/// | `a2` = 2a, `b2` = 2b, `c` | in | `F` bits, second differences |
/// | `p0` = d + a, `i0` = e + b | in | `F` bits, increment to the second pixel, to the second line |
/// | `f` | in | `F` bits, value of the first pixel |
/// | `value` | out | `F` bits, two's complement |
///
/// The coefficients are read on a clock with `valid` and `start` only. Latency 1. All sums are formed in parallel, one
/// carry chain per clock. Sections 2.3.2 and B.2.1.
#[derive(Default)]
pub struct Pe2<const F: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// This clock carries a pixel.
    pub valid: Signal<In, Bit>,
    /// First pixel of the zone.
    pub start: Signal<In, Bit>,
    /// First pixel of a later line.
    pub line: Signal<In, Bit>,
    /// Second difference along the line.
    pub a2: Signal<In, Int<F>>,
    /// Second difference from line to line.
    pub b2: Signal<In, Int<F>>,
    /// Mixed difference.
    pub c: Signal<In, Int<F>>,
    /// Increment from the first pixel to the second.
    pub p0: Signal<In, Int<F>>,
    /// Increment from the first line to the second.
    pub i0: Signal<In, Int<F>>,
    /// Value of the first pixel.
    pub f: Signal<In, Int<F>>,
    /// The polynomial.
    pub value: Signal<Out, Int<F>>,
    first: Signal<Local, Bit>,
    next_pixel: Signal<Local, Int<F>>,
    next_pixel_step: Signal<Local, Int<F>>,
    next_line: Signal<Local, Int<F>>,
    next_line_step: Signal<Local, Int<F>>,
    next_first_step: Signal<Local, Int<F>>,
    line_begin: Signal<Local, Int<F>>,
    line_begin_step: Signal<Local, Int<F>>,
    first_begin_step: Signal<Local, Int<F>>,
    kept_a2: DFF<Int<F>>,
    kept_b2: DFF<Int<F>>,
    kept_c: DFF<Int<F>>,
    line_value: DFF<Int<F>>,
    line_step: DFF<Int<F>>,
    first_step: DFF<Int<F>>,
    pixel_step: DFF<Int<F>>,
    pixel_value: DFF<Int<F>>,
    _asleep: bool,
}

block! {
    [const F: usize] Pe2 [F]
    inputs { clock, valid, start, line, a2, b2, c, p0, i0, f }
    parts { value, first, next_pixel, next_pixel_step, next_line, next_line_step,
        next_first_step, line_begin, line_begin_step, first_begin_step, kept_a2, kept_b2, kept_c, line_value, line_step, first_step, pixel_step, pixel_value }
    data { }
}

impl<const F: usize> Pe2<F> {
    /// Clocks from the flags to the value.
    pub const fn latency() -> usize {
        1
    }
}

impl<const F: usize> Logic for Pe2<F> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("pe2");
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
            pixel_value
        );
        self.next_pixel.next = self.pixel_value.q.val() + self.pixel_step.q.val();
        self.next_pixel_step.next = self.pixel_step.q.val() + self.kept_a2.q.val();
        self.next_line.next = self.line_value.q.val() + self.line_step.q.val();
        self.next_line_step.next = self.line_step.q.val() + self.kept_b2.q.val();
        self.next_first_step.next = self.first_step.q.val() + self.kept_c.q.val();
        // The first pixel of a line takes what the line begins with: one selection behind each sum.
        self.first.next = self.start.val() | self.line.val();
        if self.start.val() {
            self.line_begin.next = self.f.val();
            self.line_begin_step.next = self.i0.val();
            self.first_begin_step.next = self.p0.val();
        } else {
            self.line_begin.next = self.next_line.val();
            self.line_begin_step.next = self.next_line_step.val();
            self.first_begin_step.next = self.next_first_step.val();
        }
        if self.valid.val() {
            if self.start.val() {
                self.kept_a2.d.next = self.a2.val();
                self.kept_b2.d.next = self.b2.val();
                self.kept_c.d.next = self.c.val();
            }
            if self.first.val() {
                self.line_value.d.next = self.line_begin.val();
                self.pixel_value.d.next = self.line_begin.val();
                self.line_step.d.next = self.line_begin_step.val();
                self.first_step.d.next = self.first_begin_step.val();
                self.pixel_step.d.next = self.first_begin_step.val();
            } else {
                self.pixel_value.d.next = self.next_pixel.val();
                self.pixel_step.d.next = self.next_pixel_step.val();
            }
        }
        self.value.next = self.pixel_value.q.val();
    }
}

clocked!(Pe2<const F: usize>);
