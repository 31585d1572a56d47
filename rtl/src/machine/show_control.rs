//! Pixels of a zone on their way to the shading processor.

use crate::kernel::*;

/// Scans a zone left to right, top to bottom, on clocks on which there is room behind the shading processor.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `go` | in | begin a zone |
/// | `room` | in | a pixel issued on this clock will find a place |
/// | `x0`, `y0`, `width`, `height` | in | 12 bits, the zone; stay as they are until `ends` |
/// | `issue` | out | a pixel is issued on this clock |
/// | `x`, `y` | out | 12 bits, its place on the screen, one clock later |
/// | `valid` | out | `issue`, one clock later |
/// | `is_last` | out | it is the last pixel of the zone, one clock later |
/// | `ends` | out | the last pixel was issued, one clock later |
pub struct ShowControl {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Begin a zone.
    pub go: Signal<In, Bit>,
    /// There is room for a pixel.
    pub room: Signal<In, Bit>,
    /// First column.
    pub x0: Signal<In, Word<12>>,
    /// First line.
    pub y0: Signal<In, Word<12>>,
    /// Columns.
    pub width: Signal<In, Word<12>>,
    /// Lines.
    pub height: Signal<In, Word<12>>,
    /// A pixel is issued.
    pub issue: Signal<Out, Bit>,
    /// A pixel was issued.
    pub valid: Signal<Out, Bit>,
    /// Its column.
    pub x: Signal<Out, Word<12>>,
    /// Its line.
    pub y: Signal<Out, Word<12>>,
    /// It is the last.
    pub is_last: Signal<Out, Bit>,
    /// The zone is issued.
    pub ends: Signal<Out, Bit>,
    running: DFF<Bit>,
    column: DFF<Word<12>>,
    row: DFF<Word<12>>,
    kept_valid: DFF<Bit>,
    kept_last: DFF<Bit>,
    kept_x: DFF<Word<12>>,
    kept_y: DFF<Word<12>>,
    last_column: Signal<Local, Word<12>>,
    last_row: Signal<Local, Word<12>>,
    issued: Signal<Local, Bit>,
    line_ends: Signal<Local, Bit>,
    zone_ends: Signal<Local, Bit>,
    zero: Constant<Word<12>>,
    one: Constant<Word<12>>,
    _asleep: bool,
}

block! {
    [] ShowControl []
    inputs { clock, go, room, x0, y0, width, height }
    parts { issue, valid, x, y, is_last, ends, running, column, row, kept_valid, kept_last, kept_x, kept_y, last_column, last_row, issued,
        line_ends, zone_ends, zero, one }
    data { }
}

impl ShowControl {
    /// An idle control.
    pub fn new() -> Self {
        fields! {
            [clock, go, room, x0, y0, width, height, issue, valid, x, y, is_last, ends, running, column, row, kept_valid, kept_last,
                kept_x, kept_y, last_column, last_row, issued, line_ends, zone_ends]
            zero: constant(0),
            one: constant(1),
        }
    }
}

impl Default for ShowControl {
    fn default() -> Self {
        Self::new()
    }
}

impl Logic for ShowControl {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("show_control");
        dff_setup!(
            self, clock, running, column, row, kept_valid, kept_last, kept_x, kept_y
        );
        self.last_column.next = self.width.val() - self.one.val();
        self.last_row.next = self.height.val() - self.one.val();
        self.issued.next = self.running.q.val() & self.room.val();
        self.line_ends.next = self.column.q.val() == self.last_column.val();
        self.zone_ends.next = self.line_ends.val() & (self.row.q.val() == self.last_row.val());
        if self.go.val() {
            self.running.d.next = true;
            self.column.d.next = self.zero.val();
            self.row.d.next = self.zero.val();
        } else if self.issued.val() {
            if self.line_ends.val() {
                self.column.d.next = self.zero.val();
                self.row.d.next = self.row.q.val() + self.one.val();
            } else {
                self.column.d.next = self.column.q.val() + self.one.val();
            }
            if self.zone_ends.val() {
                self.running.d.next = false;
            }
        }
        self.kept_valid.d.next = self.issued.val();
        self.kept_last.d.next = self.issued.val() & self.zone_ends.val();
        self.kept_x.d.next = self.x0.val() + self.column.q.val();
        self.kept_y.d.next = self.y0.val() + self.row.q.val();
        self.issue.next = self.issued.val();
        self.valid.next = self.kept_valid.q.val();
        self.x.next = self.kept_x.q.val();
        self.y.next = self.kept_y.q.val();
        self.is_last.next = self.kept_last.q.val();
        self.ends.next = self.kept_last.q.val();
    }
}

clocked!(ShowControl);
