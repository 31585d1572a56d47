//! Second-degree elementary processor.

use rust_hdl::prelude::*;

/// `value(x, y) = a x^2 + b y^2 + c xy + d x + e y + f` modulo `2^W` from preconditioned words, one pixel per clock.
/// Latency 1. Sections 2.3.2 and B.2.1.
#[derive(LogicBlock, Default)]
pub struct Pe2<const W: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// This clock carries a pixel.
    pub valid: Signal<In, Bit>,
    /// First pixel of the zone.
    pub start: Signal<In, Bit>,
    /// First pixel of a later line.
    pub line: Signal<In, Bit>,
    /// Second difference along the line.
    pub a2: Signal<In, Signed<W>>,
    /// Second difference from line to line.
    pub b2: Signal<In, Signed<W>>,
    /// Mixed difference.
    pub c: Signal<In, Signed<W>>,
    /// Increment from the first line to the second.
    pub i0: Signal<In, Signed<W>>,
    /// Increment from the first pixel to the second.
    pub p0: Signal<In, Signed<W>>,
    /// Value of the first pixel.
    pub f: Signal<In, Signed<W>>,
    /// Value of the pixel.
    pub value: Signal<Out, Signed<W>>,
    next_line: DFF<Signed<W>>,
    next_line_step: DFF<Signed<W>>,
    next_first_step: DFF<Signed<W>>,
    pixel_step: DFF<Signed<W>>,
    pixel_value: DFF<Signed<W>>,
    line_begin: Signal<Local, Signed<W>>,
    line_step: Signal<Local, Signed<W>>,
    first_step: Signal<Local, Signed<W>>,
}

impl<const W: usize> Logic for Pe2<W> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, next_line, next_line_step, next_first_step);
        dff_setup!(self, clock, pixel_value, pixel_step);
        self.line_begin.next = self.next_line.q.val();
        self.line_step.next = self.next_line_step.q.val();
        self.first_step.next = self.next_first_step.q.val();
        if self.start.val() {
            self.line_begin.next = self.f.val();
            self.line_step.next = self.i0.val();
            self.first_step.next = self.p0.val();
        }
        if self.valid.val() {
            if self.start.val() | self.line.val() {
                self.next_line.d.next = self.line_begin.val() + self.line_step.val();
                self.next_line_step.d.next = self.line_step.val() + self.b2.val();
                self.next_first_step.d.next = self.first_step.val() + self.c.val();
                self.pixel_value.d.next = self.line_begin.val();
                self.pixel_step.d.next = self.first_step.val();
            } else {
                self.pixel_value.d.next = self.pixel_value.q.val() + self.pixel_step.q.val();
                self.pixel_step.d.next = self.pixel_step.q.val() + self.a2.val();
            }
        }
        self.value.next = self.pixel_value.q.val();
    }
}
