//! Video timing.

use super::video_mode::{POSITION, VideoMode};
use super::video_scan::VideoScan;
use crate::kernel::*;

/// Scans a screen with its blanking and, `lead` clocks ahead of it, asks for its pixels.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `enable` | in | go on; all outputs hold without it |
/// | `de` | out | a pixel is shown |
/// | `start` | out | first pixel of the frame |
/// | `line` | out | first pixel of any other line |
/// | `x`, `y` | out | 12 bits, the pixel; 0 in the blanking |
/// | `hsync`, `vsync` | out | synchronisation, with the polarities of the mode; `vsync` changes where `hsync` begins |
/// | `frame_start` | out | first clock of the vertical blanking, the one after the last pixel |
/// | `need`, `go`, `need_line`, `need_x`, `need_y` | out | `de`, `start`, `line`, `x`, `y` of `lead` clocks later |
///
/// All outputs are registered: the first clock with `enable` gives the first clock of a vertical blanking. A pipeline of latency `lead` that is started by
/// `need`, `go` and `need_line` gives its pixels with `de`.
pub struct VideoTiming {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Go on.
    pub enable: Signal<In, Bit>,
    /// A pixel is shown.
    pub de: Signal<Out, Bit>,
    /// First pixel of the frame.
    pub start: Signal<Out, Bit>,
    /// First pixel of any other line.
    pub line: Signal<Out, Bit>,
    /// Column of the pixel.
    pub x: Signal<Out, Word<12>>,
    /// Line of the pixel.
    pub y: Signal<Out, Word<12>>,
    /// Synchronisation of the line.
    pub hsync: Signal<Out, Bit>,
    /// Synchronisation of the frame.
    pub vsync: Signal<Out, Bit>,
    /// First clock of the vertical blanking.
    pub frame_start: Signal<Out, Bit>,
    /// A pixel is shown `lead` clocks later.
    pub need: Signal<Out, Bit>,
    /// First pixel of the frame, `lead` clocks later.
    pub go: Signal<Out, Bit>,
    /// First pixel of any other line, `lead` clocks later.
    pub need_line: Signal<Out, Bit>,
    /// Column of the pixel `lead` clocks later.
    pub need_x: Signal<Out, Word<12>>,
    /// Line of the pixel `lead` clocks later.
    pub need_y: Signal<Out, Word<12>>,
    shown: VideoScan,
    ahead: VideoScan,
    in_hsync: DFF<Bit>,
    in_vsync: DFF<Bit>,
    hsync_begin: Constant<Word<POSITION>>,
    hsync_end: Constant<Word<POSITION>>,
    vsync_begin: Constant<Word<POSITION>>,
    vsync_end: Constant<Word<POSITION>>,
    hsync_low: Constant<Bit>,
    vsync_low: Constant<Bit>,
    _asleep: bool,
}

block! {
    [] VideoTiming []
    inputs { clock, enable }
    parts { de, start, line, x, y, hsync, vsync, frame_start, need, go, need_line, need_x, need_y,
        shown, ahead, in_hsync, in_vsync, hsync_begin, hsync_end, vsync_begin, vsync_end,
        hsync_low, vsync_low }
    data { }
}

impl VideoTiming {
    /// The timing of a mode for a pipeline of `lead` clocks.
    ///
    /// # Panics
    ///
    /// When a number of the mode is out of its range, or `lead` is not shorter than the vertical blanking.
    pub fn new(mode: &VideoMode, lead: usize) -> Self {
        mode.check();
        assert!(
            (lead as u64) < mode.retrace(),
            "a lead of {lead} clocks: accepted are fewer than the {} of the vertical blanking",
            mode.retrace()
        );
        fields! {
            [clock, enable, de, start, line, x, y, hsync, vsync, frame_start, need, go, need_line,
                need_x, need_y, in_hsync, in_vsync]
            shown: VideoScan::new(mode, 0),
            ahead: VideoScan::new(mode, lead as u64),
            hsync_begin: constant(mode.line.front),
            hsync_end: constant(mode.line.front + mode.line.sync),
            vsync_begin: constant(mode.frame.front),
            vsync_end: constant(mode.frame.front + mode.frame.sync),
            hsync_low: Constant::new(!mode.hsync_high),
            vsync_low: Constant::new(!mode.vsync_high),
        }
    }

    /// Clocks from `enable` to a position.
    pub const fn latency() -> usize {
        1
    }
}

impl Logic for VideoTiming {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("video_timing");
        dff_setup!(self, clock, in_hsync, in_vsync);
        self.shown.clock.next = self.clock.val();
        self.shown.enable.next = self.enable.val();
        self.ahead.clock.next = self.clock.val();
        self.ahead.enable.next = self.enable.val();
        if self.enable.val() {
            if self.shown.column.val() == self.hsync_end.val() {
                self.in_hsync.d.next = false;
            }
            if self.shown.column.val() == self.hsync_begin.val() {
                self.in_hsync.d.next = true;
                if self.shown.row.val() == self.vsync_end.val() {
                    self.in_vsync.d.next = false;
                }
                if self.shown.row.val() == self.vsync_begin.val() {
                    self.in_vsync.d.next = true;
                }
            }
        }
        self.hsync.next = self.in_hsync.q.val() ^ self.hsync_low.val();
        self.vsync.next = self.in_vsync.q.val() ^ self.vsync_low.val();
        self.de.next = self.shown.active.val();
        self.start.next = self.shown.start.val();
        self.line.next = self.shown.line.val();
        self.x.next = self.shown.x.val();
        self.y.next = self.shown.y.val();
        self.frame_start.next = self.shown.retrace.val();
        self.need.next = self.ahead.active.val();
        self.go.next = self.ahead.start.val();
        self.need_line.next = self.ahead.line.val();
        self.need_x.next = self.ahead.x.val();
        self.need_y.next = self.ahead.y.val();
    }
}

clocked!(VideoTiming);
