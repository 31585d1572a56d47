//! First-degree elementary processor.

use crate::kernel::*;

/// Evaluates `value(x, y) = a x + b y + c mod 2^W` by additions alone, one pixel per clock.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line` | in | raster flags |
/// | `a`, `b`, `c` | in | `W` bits, two's complement; read on a clock with `valid` and `start` only |
/// | `value` | out | `W` bits, two's complement |
///
/// Latency 1: flags at clock t, value at t + 1. A clock without `valid` changes nothing. Sections 2.3.2 and B.2.1.
#[derive(Default)]
pub struct Pe1<const W: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// This clock carries a pixel.
    pub valid: Signal<In, Bit>,
    /// First pixel of the zone.
    pub start: Signal<In, Bit>,
    /// First pixel of a later line.
    pub line: Signal<In, Bit>,
    /// Increment along the line.
    pub a: Signal<In, Int<W>>,
    /// Increment from line to line.
    pub b: Signal<In, Int<W>>,
    /// Value of the first pixel.
    pub c: Signal<In, Int<W>>,
    /// The polynomial.
    pub value: Signal<Out, Int<W>>,
    first: Signal<Local, Bit>,
    next_line: Signal<Local, Int<W>>,
    line_begin: Signal<Local, Int<W>>,
    next_pixel: Signal<Local, Int<W>>,
    kept_a: DFF<Int<W>>,
    kept_b: DFF<Int<W>>,
    line_value: DFF<Int<W>>,
    pixel_value: DFF<Int<W>>,
    _asleep: bool,
}

block! {
    [const W: usize] Pe1 [W]
    inputs { clock, valid, start, line, a, b, c }
    parts { value, first, next_line, line_begin, next_pixel, kept_a, kept_b, line_value, pixel_value }
    data { }
}

impl<const W: usize> Pe1<W> {
    /// Clocks from the flags to the value.
    pub const fn latency() -> usize {
        1
    }
}

impl<const W: usize> Logic for Pe1<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("pe1");
        dff_setup!(self, clock, kept_a, kept_b, line_value, pixel_value);
        self.next_line.next = self.line_value.q.val() + self.kept_b.q.val();
        self.next_pixel.next = self.pixel_value.q.val() + self.kept_a.q.val();
        // The first pixel of a line takes what the line begins with: one selection behind each sum.
        self.first.next = self.start.val() | self.line.val();
        if self.start.val() {
            self.line_begin.next = self.c.val();
        } else {
            self.line_begin.next = self.next_line.val();
        }
        if self.valid.val() {
            if self.start.val() {
                self.kept_a.d.next = self.a.val();
                self.kept_b.d.next = self.b.val();
            }
            if self.first.val() {
                self.line_value.d.next = self.line_begin.val();
                self.pixel_value.d.next = self.line_begin.val();
            } else {
                self.pixel_value.d.next = self.next_pixel.val();
            }
        }
        self.value.next = self.pixel_value.q.val();
    }
}

clocked!(Pe1<const W: usize>);
