//! Video timing.

use super::COORDINATE;
use imogene_contract::video::{self, Span, VideoMode};
use imogene_hdl::{Bits, Value, bundle, module, net};

/// Greatest number of bits of a position in the raster.
const POSITION: u32 = video::POSITION as u32;

bundle! {
    /// Where a scan is.
    Scan(column, row) {
        column: Bits(column), "clock of the line that the next enabled clock gives on the other outputs";
        row: Bits(row), "line of the frame, likewise";
        active: Bits(1), "the position is shown";
        start: Bits(1), "first pixel of the frame";
        line: Bits(1), "first pixel of any other line";
        x: Bits(COORDINATE), "column of the pixel; 0 in the blanking";
        y: Bits(COORDINATE), "line of the pixel; 0 in the blanking";
        retrace: Bits(1), "first clock of the vertical blanking";
    }

    /// What a screen is given, and what is asked of the pipeline before it.
    Screen() {
        de: Bits(1), "a pixel is shown";
        start: Bits(1), "first pixel of the frame";
        line: Bits(1), "first pixel of any other line";
        x: Bits(COORDINATE), "column of the pixel; 0 in the blanking";
        y: Bits(COORDINATE), "line of the pixel; 0 in the blanking";
        hsync: Bits(1), "synchronisation of the line, with the polarity of the mode";
        vsync: Bits(1), "synchronisation of the frame, with the polarity of the mode; it changes where hsync begins";
        frame_start: Bits(1), "first clock of the vertical blanking, the one after the last pixel";
        need: Bits(1), "de of lead clocks later";
        go: Bits(1), "start of lead clocks later";
        need_line: Bits(1), "line of lead clocks later";
        need_x: Bits(COORDINATE), "x of lead clocks later";
        need_y: Bits(COORDINATE), "y of lead clocks later";
    }
}

/// Scans a screen with its blanking and, `lead` clocks ahead of it, asks for its pixels. All holds without `enable`.
///
/// The first clock with `enable` gives the first clock of a vertical blanking. A pipeline of latency `lead` that is
/// started by `need`, `go` and `need_line` gives its pixels with `de`. Latency 1. Chaillou 1991, I.2.4.2 and IV.4.4.
///
/// # Panics
///
/// When a number of the mode is out of its range, or `lead` is not shorter than the vertical blanking.
pub fn video_timing(at: &str, enable: Bits, mode: &VideoMode, lead: u64) -> Screen {
    check("line", mode.line);
    check("frame", mode.frame);
    assert!(
        lead < mode.retrace(),
        "a lead of {lead} clocks: accepted are fewer than the {} of the vertical blanking",
        mode.retrace()
    );
    let inputs = ("enable", enable, "go on; all outputs hold without it");
    module("video_timing", at, inputs, |enable| {
        let shown = video_scan("shown", enable, mode, 0);
        let ahead = video_scan("ahead", enable, mode, lead);
        net! {
            let in_hsync = Bits::register(1);
            let in_vsync = Bits::register(1);
            let hsync_begins = shown.column.is(mode.line.front);
            let hsync_ends = shown.column.is(mode.line.front + mode.line.sync);
            let vsync_begins = shown.row.is(mode.frame.front);
            let vsync_ends = shown.row.is(mode.frame.front + mode.frame.sync);
        }
        in_hsync.load_when(enable & (hsync_begins | hsync_ends), hsync_begins);
        let vsync_changes = hsync_begins & (vsync_begins | vsync_ends);
        in_vsync.load_when(enable & vsync_changes, vsync_begins);
        let level = |high: bool, holds: Bits| if high { holds } else { !holds };
        Screen {
            de: shown.active,
            start: shown.start,
            line: shown.line,
            x: shown.x,
            y: shown.y,
            hsync: level(mode.hsync_high, in_hsync),
            vsync: level(mode.vsync_high, in_vsync),
            frame_start: shown.retrace,
            need: ahead.active,
            go: ahead.start,
            need_line: ahead.line,
            need_x: ahead.x,
            need_y: ahead.y,
        }
    })
}

/// Bits of a number below `values`.
fn bits(values: u64) -> u32 {
    values.next_power_of_two().ilog2().max(1)
}

fn check(what: &str, span: Span) {
    assert!(
        (1..1 << COORDINATE).contains(&span.active)
            && span.sync >= 1
            && span.total() <= 1 << POSITION,
        "the {what} of a video mode: accepted are 1 to 4095 shown, a synchronisation of 1 at least, 8192 in all"
    );
}

/// The positions of a mode one after the other, from the one `ahead` clocks after the beginning of the vertical
/// blanking.
///
/// A line is front porch, synchronisation, back porch, shown part, and a frame its lines in the same order, so that
/// position 0 is the clock after the last pixel of a frame.
fn video_scan(at: &str, enable: Bits, mode: &VideoMode, ahead: u64) -> Scan {
    module("video_scan", at, ("enable", enable), |enable| {
        let (line, frame) = (mode.line, mode.frame);
        let begin = ahead % (line.total() * frame.total());
        let [column_0, row_0] = [begin % line.total(), begin / line.total()];
        let position = |span: Span, begin: u64| Bits::register(bits(span.total())).initially(begin);
        let flag = |begin: bool| Bits::register(1).initially(begin.into());
        let after = |position: Bits, ends: Bits| {
            let [zero, one] = [0, 1].map(|value| Bits::new(value, position.width()));
            ends.select(zero, position + one)
        };
        net! {
            let column = position(line, column_0);
            let row = position(frame, row_0);
            // Known one clock before.
            let line_ends = flag(column_0 == line.total() - 1);
            let is_left = flag(column_0 == line.blank());
            let is_top = flag(row_0 == frame.blank());
            let in_line = flag(column_0 >= line.blank());
            let in_frame = flag(row_0 >= frame.blank());
            let left_comes = column.is(line.blank() - 1);
            let top_comes = row.is(frame.blank() - 1);
            let frame_ends = row.is(frame.total() - 1);
            let next_row = after(row, frame_ends);
            let row_ends = enable & line_ends;
            let is_shown = in_line & in_frame;
        }
        line_ends.load_when(enable, column.is(line.total() - 2));
        column.load_when(enable, after(column, line_ends));
        row.load_when(row_ends, next_row);
        is_left.load_when(enable, left_comes);
        is_top.load_when(row_ends, top_comes);
        in_line.load_when(enable & (left_comes | line_ends), left_comes);
        in_frame.load_when(row_ends & (top_comes | frame_ends), top_comes);
        let pixel = |position: Bits, span: Span| {
            let width = bits(span.active);
            let place = (position - Bits::new(span.blank(), position.width())).low(width);
            let none = Bits::new(0, width);
            is_shown
                .select(place, none)
                .reg_when(enable)
                .extend(COORDINATE)
        };
        Scan {
            column,
            row,
            active: is_shown.reg_when(enable),
            start: (is_shown & is_left & is_top).reg_when(enable),
            line: (is_shown & is_left & !is_top).reg_when(enable),
            x: pixel(column, line),
            y: pixel(row, frame),
            retrace: (column.is(0) & row.is(0)).reg_when(enable),
        }
    })
}
