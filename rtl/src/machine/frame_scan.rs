//! Frames one after the other, as fast as the receiver takes them.

use crate::kernel::*;

/// Scans frames of a fixed size left to right, top to bottom, on clocks on which there is room behind the pipeline; between frames the pipeline runs empty
/// and the words of the next frame may be copied.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `room` | in | a pixel issued on this clock will find a place |
/// | `is_busy` | in | words are being copied; the next frame waits |
/// | `issue` | out | a pixel is issued on this clock |
/// | `valid`, `start`, `line`, `x`, `y` | out | raster flags and pixel, one clock later |
/// | `line_ends` | out | it is the last of its line |
/// | `retrace` | out | the pipeline is empty: words may be copied |
pub struct FrameScan {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// There is room for a pixel.
    pub room: Signal<In, Bit>,
    /// Words are being copied.
    pub is_busy: Signal<In, Bit>,
    /// A pixel is issued.
    pub issue: Signal<Out, Bit>,
    /// A pixel was issued.
    pub valid: Signal<Out, Bit>,
    /// First of the frame.
    pub start: Signal<Out, Bit>,
    /// First of another line.
    pub line: Signal<Out, Bit>,
    /// Its column.
    pub x: Signal<Out, Word<12>>,
    /// Its line.
    pub y: Signal<Out, Word<12>>,
    /// Last of its line.
    pub line_ends: Signal<Out, Bit>,
    /// The pipeline is empty.
    pub retrace: Signal<Out, Bit>,
    waiting: DFF<Word<10>>,
    asked: DFF<Bit>,
    running: DFF<Bit>,
    column: DFF<Word<12>>,
    row: DFF<Word<12>>,
    kept_valid: DFF<Bit>,
    kept_start: DFF<Bit>,
    kept_line: DFF<Bit>,
    kept_end: DFF<Bit>,
    kept_x: DFF<Word<12>>,
    kept_y: DFF<Word<12>>,
    issued: Signal<Local, Bit>,
    at_left: Signal<Local, Bit>,
    at_right: Signal<Local, Bit>,
    at_top: Signal<Local, Bit>,
    at_bottom: Signal<Local, Bit>,
    is_empty: Signal<Local, Bit>,
    drain: Constant<Word<10>>,
    none: Constant<Word<10>>,
    less: Constant<Word<10>>,
    last_column: Constant<Word<12>>,
    last_row: Constant<Word<12>>,
    zero: Constant<Word<12>>,
    one: Constant<Word<12>>,
    _asleep: bool,
}

block! {
    [] FrameScan []
    inputs { clock, room, is_busy }
    parts { issue, valid, start, line, x, y, line_ends, retrace, waiting, asked, running, column, row, kept_valid, kept_start, kept_line, kept_end,
        kept_x, kept_y, issued, at_left, at_right, at_top, at_bottom, is_empty, drain, none, less, last_column, last_row, zero, one }
    data { }
}

impl FrameScan {
    /// A scan of `width` by `height` pixels before a pipeline that is empty `drain` clocks after the last of them.
    ///
    /// # Panics
    ///
    /// When a side is not in `1..4096`, or `drain` has more than 10 bits.
    pub fn new(width: usize, height: usize, drain: usize) -> Self {
        let sides = 1..4096;
        assert!(
            sides.contains(&width) && sides.contains(&height),
            "a picture has 1 to 4095 pixels along a side"
        );
        assert!(drain < 1024, "a pipeline of fewer than 1024 clocks");
        fields! {
            [clock, room, is_busy, issue, valid, start, line, x, y, line_ends, retrace, waiting, asked, running, column, row, kept_valid, kept_start,
                kept_line, kept_end, kept_x, kept_y, issued, at_left, at_right, at_top, at_bottom, is_empty]
            drain: constant(drain as u64),
            none: constant(0),
            less: constant(1),
            last_column: constant(width as u64 - 1),
            last_row: constant(height as u64 - 1),
            zero: constant(0),
            one: constant(1),
        }
    }
}

impl Logic for FrameScan {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("frame_scan");
        dff_setup!(
            self, clock, waiting, asked, running, column, row, kept_valid, kept_start, kept_line,
            kept_end, kept_x, kept_y
        );
        self.issued.next = self.running.q.val() & self.room.val();
        self.at_left.next = self.column.q.val() == self.zero.val();
        self.at_right.next = self.column.q.val() == self.last_column.val();
        self.at_top.next = self.row.q.val() == self.zero.val();
        self.at_bottom.next = self.row.q.val() == self.last_row.val();
        self.is_empty.next = self.waiting.q.val() == self.none.val();
        self.asked.d.next = false;
        if self.running.q.val() {
            if self.issued.val() {
                if self.at_right.val() {
                    self.column.d.next = self.zero.val();
                    self.row.d.next = self.row.q.val() + self.one.val();
                    if self.at_bottom.val() {
                        self.row.d.next = self.zero.val();
                        self.running.d.next = false;
                        self.waiting.d.next = self.drain.val();
                    }
                } else {
                    self.column.d.next = self.column.q.val() + self.one.val();
                }
            }
        } else if !self.is_empty.val() {
            self.waiting.d.next = self.waiting.q.val() - self.less.val();
            self.asked.d.next = self.waiting.q.val() == self.less.val();
        } else if !self.asked.q.val() & !self.is_busy.val() {
            self.running.d.next = true;
        }
        self.kept_valid.d.next = self.issued.val();
        self.kept_start.d.next = self.issued.val() & self.at_left.val() & self.at_top.val();
        self.kept_line.d.next = self.issued.val() & self.at_left.val() & !self.at_top.val();
        self.kept_end.d.next = self.issued.val() & self.at_right.val();
        self.kept_x.d.next = self.column.q.val();
        self.kept_y.d.next = self.row.q.val();
        self.issue.next = self.issued.val();
        self.valid.next = self.kept_valid.q.val();
        self.start.next = self.kept_start.q.val();
        self.line.next = self.kept_line.q.val();
        self.line_ends.next = self.kept_end.q.val();
        self.x.next = self.kept_x.q.val();
        self.y.next = self.kept_y.q.val();
        self.retrace.next = self.asked.q.val();
    }
}

clocked!(FrameScan);
