//! Raster control.

use crate::kernel::*;

/// Scans a zone left to right, top to bottom, one pixel per clock, without a bubble between lines or zones.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `go` | in | begin a zone; obeyed when idle or together with `last`, ignored otherwise |
/// | `width`, `height` | in | 12 bits, 1 to 4095, read with an obeyed `go` |
/// | `valid` | out | this clock carries a pixel |
/// | `start` | out | first pixel of the zone |
/// | `line` | out | first pixel of any other line |
/// | `x`, `y` | out | 12 bits; they keep their last value when idle |
/// | `last` | out | last pixel of the zone |
///
/// All outputs are registered: `go` at clock t gives the first pixel at t + 1. The flags are low when idle.
pub struct RasterControl {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Begin a zone.
    pub go: Signal<In, Bit>,
    /// Pixels of a line.
    pub width: Signal<In, Word<12>>,
    /// Lines of the zone.
    pub height: Signal<In, Word<12>>,
    /// This clock carries a pixel.
    pub valid: Signal<Out, Bit>,
    /// First pixel of the zone.
    pub start: Signal<Out, Bit>,
    /// First pixel of a later line.
    pub line: Signal<Out, Bit>,
    /// Column.
    pub x: Signal<Out, Word<12>>,
    /// Line.
    pub y: Signal<Out, Word<12>>,
    /// Last pixel of the zone.
    pub last: Signal<Out, Bit>,
    obeyed: Signal<Local, Bit>,
    line_ends: Signal<Local, Bit>,
    next_x: Signal<Local, Word<12>>,
    next_y: Signal<Local, Word<12>>,
    last_x: Signal<Local, Word<12>>,
    last_y: Signal<Local, Word<12>>,
    kept_valid: DFF<Bit>,
    kept_start: DFF<Bit>,
    kept_line: DFF<Bit>,
    kept_last: DFF<Bit>,
    kept_x: DFF<Word<12>>,
    kept_y: DFF<Word<12>>,
    right_edge: DFF<Word<12>>,
    bottom_edge: DFF<Word<12>>,
    zero: Constant<Word<12>>,
    one: Constant<Word<12>>,
    _asleep: bool,
}

block! {
    [] RasterControl []
    inputs { clock, go, width, height }
    parts { valid, start, line, x, y, last, obeyed, line_ends, next_x, next_y, last_x, last_y,
        kept_valid, kept_start, kept_line, kept_last, kept_x, kept_y, right_edge, bottom_edge,
        zero, one }
    data { }
}

impl RasterControl {
    /// A raster control.
    pub fn new() -> Self {
        Self {
            clock: Signal::default(),
            go: Signal::default(),
            width: Signal::default(),
            height: Signal::default(),
            valid: Signal::default(),
            start: Signal::default(),
            line: Signal::default(),
            x: Signal::default(),
            y: Signal::default(),
            last: Signal::default(),
            obeyed: Signal::default(),
            line_ends: Signal::default(),
            next_x: Signal::default(),
            next_y: Signal::default(),
            last_x: Signal::default(),
            last_y: Signal::default(),
            kept_valid: DFF::default(),
            kept_start: DFF::default(),
            kept_line: DFF::default(),
            kept_last: DFF::default(),
            kept_x: DFF::default(),
            kept_y: DFF::default(),
            right_edge: DFF::default(),
            bottom_edge: DFF::default(),
            zero: constant(0),
            one: constant(1),
            _asleep: false,
        }
    }

    /// Clocks from `go` to the first pixel.
    pub const fn latency() -> usize {
        1
    }
}

impl Default for RasterControl {
    fn default() -> Self {
        Self::new()
    }
}

impl Logic for RasterControl {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("raster_control");
        dff_setup!(
            self,
            clock,
            kept_valid,
            kept_start,
            kept_line,
            kept_last,
            kept_x,
            kept_y,
            right_edge,
            bottom_edge
        );
        self.obeyed.next = self.go.val() & (!self.kept_valid.q.val() | self.kept_last.q.val());
        self.line_ends.next = self.kept_x.q.val() == self.right_edge.q.val();
        if self.line_ends.val() {
            self.next_x.next = self.zero.val();
            self.next_y.next = self.kept_y.q.val() + self.one.val();
        } else {
            self.next_x.next = self.kept_x.q.val() + self.one.val();
            self.next_y.next = self.kept_y.q.val();
        }
        self.last_x.next = self.width.val() - self.one.val();
        self.last_y.next = self.height.val() - self.one.val();
        if self.obeyed.val() {
            self.kept_valid.d.next = true;
            self.kept_start.d.next = true;
            self.kept_line.d.next = false;
            self.kept_last.d.next =
                (self.last_x.val() == self.zero.val()) & (self.last_y.val() == self.zero.val());
            self.kept_x.d.next = self.zero.val();
            self.kept_y.d.next = self.zero.val();
            self.right_edge.d.next = self.last_x.val();
            self.bottom_edge.d.next = self.last_y.val();
        } else if self.kept_last.q.val() {
            self.kept_valid.d.next = false;
            self.kept_start.d.next = false;
            self.kept_line.d.next = false;
            self.kept_last.d.next = false;
        } else if self.kept_valid.q.val() {
            self.kept_start.d.next = false;
            self.kept_line.d.next = self.line_ends.val();
            self.kept_last.d.next = (self.next_x.val() == self.right_edge.q.val())
                & (self.next_y.val() == self.bottom_edge.q.val());
            self.kept_x.d.next = self.next_x.val();
            self.kept_y.d.next = self.next_y.val();
        }
        self.valid.next = self.kept_valid.q.val();
        self.start.next = self.kept_start.q.val();
        self.line.next = self.kept_line.q.val();
        self.last.next = self.kept_last.q.val();
        self.x.next = self.kept_x.q.val();
        self.y.next = self.kept_y.q.val();
    }
}

clocked!(RasterControl);
