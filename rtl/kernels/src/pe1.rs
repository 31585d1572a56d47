//! First-degree elementary processor.

use rust_hdl::prelude::*;

/// `value(x, y) = a x + b y + c` modulo `2^W`, one pixel per clock. Latency 1. Section 2.3.2.
#[derive(LogicBlock, Default)]
pub struct Pe1<const W: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// This clock carries a pixel.
    pub valid: Signal<In, Bit>,
    /// First pixel of the zone.
    pub start: Signal<In, Bit>,
    /// First pixel of a later line.
    pub line: Signal<In, Bit>,
    /// Increment along the line.
    pub a: Signal<In, Signed<W>>,
    /// Increment from line to line.
    pub b: Signal<In, Signed<W>>,
    /// Value of the first pixel.
    pub c: Signal<In, Signed<W>>,
    /// Value of the pixel.
    pub value: Signal<Out, Signed<W>>,
    next_line: DFF<Signed<W>>,
    pixel_value: DFF<Signed<W>>,
    line_begin: Signal<Local, Signed<W>>,
}

impl<const W: usize> Logic for Pe1<W> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, next_line, pixel_value);
        self.line_begin.next = self.next_line.q.val();
        if self.start.val() {
            self.line_begin.next = self.c.val();
        }
        if self.valid.val() {
            if self.start.val() | self.line.val() {
                self.next_line.d.next = self.line_begin.val() + self.b.val();
                self.pixel_value.d.next = self.line_begin.val();
            } else {
                self.pixel_value.d.next = self.pixel_value.q.val() + self.a.val();
            }
        }
        self.value.next = self.pixel_value.q.val();
    }
}
