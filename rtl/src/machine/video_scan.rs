//! The scan of a screen with its blanking.

use super::video_mode::{POSITION, VideoMode};
use crate::kernel::*;

/// Goes through the positions of a video mode, blanking included, and says which are shown.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `enable` | in | go on; all outputs hold without it |
/// | `column`, `row` | out | 13 bits, the position that the next enabled clock gives on the other outputs |
/// | `active` | out | the position is shown |
/// | `start` | out | first pixel of the frame |
/// | `line` | out | first pixel of any other line |
/// | `x`, `y` | out | 12 bits, the pixel; 0 in the blanking |
/// | `retrace` | out | first clock of the vertical blanking |
///
/// A line is front porch, synchronisation, back porch, shown part, and a frame its lines in the same order, so that position 0 is the clock after the
/// last pixel of a frame.
pub struct VideoScan {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Go on.
    pub enable: Signal<In, Bit>,
    /// Clock of the line.
    pub column: Signal<Out, Word<POSITION>>,
    /// Line of the frame.
    pub row: Signal<Out, Word<POSITION>>,
    /// The position is shown.
    pub active: Signal<Out, Bit>,
    /// First pixel of the frame.
    pub start: Signal<Out, Bit>,
    /// First pixel of any other line.
    pub line: Signal<Out, Bit>,
    /// Column of the pixel.
    pub x: Signal<Out, Word<12>>,
    /// Line of the pixel.
    pub y: Signal<Out, Word<12>>,
    /// First clock of the vertical blanking.
    pub retrace: Signal<Out, Bit>,
    now_column: Signal<Local, Word<POSITION>>,
    now_row: Signal<Local, Word<POSITION>>,
    next_column: Signal<Local, Word<POSITION>>,
    next_row: Signal<Local, Word<POSITION>>,
    is_shown: Signal<Local, Bit>,
    is_left: Signal<Local, Bit>,
    is_top: Signal<Local, Bit>,
    low_column: Signal<Local, Word<12>>,
    low_row: Signal<Local, Word<12>>,
    kept_column: DFF<Word<POSITION>>,
    kept_row: DFF<Word<POSITION>>,
    kept_active: DFF<Bit>,
    kept_start: DFF<Bit>,
    kept_line: DFF<Bit>,
    kept_x: DFF<Word<12>>,
    kept_y: DFF<Word<12>>,
    kept_retrace: DFF<Bit>,
    begin_column: Constant<Word<POSITION>>,
    begin_row: Constant<Word<POSITION>>,
    last_column: Constant<Word<POSITION>>,
    last_row: Constant<Word<POSITION>>,
    left: Constant<Word<POSITION>>,
    top: Constant<Word<POSITION>>,
    low_left: Constant<Word<12>>,
    low_top: Constant<Word<12>>,
    origin: Constant<Word<12>>,
    zero: Constant<Word<POSITION>>,
    one: Constant<Word<POSITION>>,
    _asleep: bool,
}

block! {
    [] VideoScan []
    inputs { clock, enable }
    parts { column, row, active, start, line, x, y, retrace, now_column, now_row, next_column,
        next_row, is_shown, is_left, is_top, low_column, low_row, kept_column, kept_row,
        kept_active, kept_start, kept_line, kept_x, kept_y, kept_retrace, begin_column, begin_row,
        last_column, last_row, left, top, low_left, low_top, origin, zero, one }
    data { }
}

impl VideoScan {
    /// The scan of a mode that begins `ahead` clocks after the beginning of the vertical blanking.
    pub(super) fn new(mode: &VideoMode, ahead: u64) -> Self {
        let begin = ahead % (mode.line.total() * mode.frame.total());
        fields! {
            [clock, enable, column, row, active, start, line, x, y, retrace, now_column, now_row,
                next_column, next_row, is_shown, is_left, is_top, low_column, low_row, kept_column,
                kept_row, kept_active, kept_start, kept_line, kept_x, kept_y, kept_retrace]
            begin_column: constant(begin % mode.line.total()),
            begin_row: constant(begin / mode.line.total()),
            last_column: constant(mode.line.total() - 1),
            last_row: constant(mode.frame.total() - 1),
            left: constant(mode.line.blank()),
            top: constant(mode.frame.blank()),
            low_left: constant(mode.line.blank()),
            low_top: constant(mode.frame.blank()),
            origin: constant(0),
            zero: constant(0),
            one: constant(1),
        }
    }
}

impl Logic for VideoScan {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("video_scan");
        dff_setup!(
            self,
            clock,
            kept_column,
            kept_row,
            kept_active,
            kept_start,
            kept_line,
            kept_x,
            kept_y,
            kept_retrace
        );
        // Registers start at zero: they hold the difference to the position where the scan begins.
        self.now_column.next = self.kept_column.q.val() ^ self.begin_column.val();
        self.now_row.next = self.kept_row.q.val() ^ self.begin_row.val();
        self.next_column.next = self.now_column.val() + self.one.val();
        self.next_row.next = self.now_row.val();
        if self.now_column.val() == self.last_column.val() {
            self.next_column.next = self.zero.val();
            self.next_row.next = self.now_row.val() + self.one.val();
            if self.now_row.val() == self.last_row.val() {
                self.next_row.next = self.zero.val();
            }
        }
        self.is_shown.next =
            (self.now_column.val() >= self.left.val()) & (self.now_row.val() >= self.top.val());
        self.is_left.next = self.now_column.val() == self.left.val();
        self.is_top.next = self.now_row.val() == self.top.val();
        self.low_column.next = self.now_column.val().get_bits::<12>(0);
        self.low_row.next = self.now_row.val().get_bits::<12>(0);
        if self.enable.val() {
            self.kept_column.d.next = self.next_column.val() ^ self.begin_column.val();
            self.kept_row.d.next = self.next_row.val() ^ self.begin_row.val();
            self.kept_active.d.next = self.is_shown.val();
            self.kept_start.d.next = self.is_shown.val() & self.is_left.val() & self.is_top.val();
            self.kept_line.d.next = self.is_shown.val() & self.is_left.val() & !self.is_top.val();
            self.kept_retrace.d.next = (self.now_column.val() == self.zero.val())
                & (self.now_row.val() == self.zero.val());
            self.kept_x.d.next = self.origin.val();
            self.kept_y.d.next = self.origin.val();
            if self.is_shown.val() {
                self.kept_x.d.next = self.low_column.val() - self.low_left.val();
                self.kept_y.d.next = self.low_row.val() - self.low_top.val();
            }
        }
        self.column.next = self.now_column.val();
        self.row.next = self.now_row.val();
        self.active.next = self.kept_active.q.val();
        self.start.next = self.kept_start.q.val();
        self.line.next = self.kept_line.q.val();
        self.x.next = self.kept_x.q.val();
        self.y.next = self.kept_y.q.val();
        self.retrace.next = self.kept_retrace.q.val();
    }
}
