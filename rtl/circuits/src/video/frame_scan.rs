//! Frames one after the other, as fast as the receiver takes them.

use super::COORDINATE;
use crate::raster::{Flags, Pixel, Scan};
use imogene_hdl::{Bits, Value, bundles, module, net, ports};

bundles! {
    /// A pixel of a scan.
    Scanned {
        issue: Bits as "issue", "a pixel is issued on this clock";
        scan: Scan as "", "of the screen, one clock later";
        line_ends: Bits as "line_ends", "it is the last of its line";
        retrace: Bits as "retrace", "the pipeline is empty: words may be copied";
    }
}

/// Frames of `width` by `height` pixels left to right, top to bottom, on clocks on which there is `room` behind the
/// pipeline, `pace` clocks apart or more. It is empty `drain` clocks after the last pixel of a frame; the next one
/// waits while words are copied (`is_busy`). Latency 1.
///
/// # Panics
///
/// When a side is no coordinate.
pub fn frame_scan(
    at: &str,
    (room, is_busy): (Bits, Bits),
    (width, height): (u64, u64),
    pace: u32,
    drain: u64,
) -> Scanned {
    module(
        "frame_scan",
        at,
        ports!(room, is_busy),
        |(room, is_busy)| {
            let word = |value: u64| Bits::new(value, COORDINATE);
            let clocks = |value: u64| Bits::new(value, drain.ilog2() + 1);
            net! {
                let running = Bits::register(1);
                let waiting = Bits::register(drain.ilog2() + 1);
                let retrace = Bits::register(1);
                let column = Bits::register(COORDINATE);
                let row = Bits::register(COORDINATE);
                let issued = paced(running & room, pace);
                let at_left = Bits::register(1).initially(1);
                let at_right = Bits::register(1).initially((width == 1).into());
                let at_top = Bits::register(1).initially(1);
                let at_bottom = Bits::register(1).initially((height == 1).into());
                let line_ends = issued & at_right;
                let frame_ends = line_ends & at_bottom;
                let is_empty = waiting.is(0);
                let drains = !running & !is_empty;
                let begins = !running & is_empty & !retrace & !is_busy;
            }
            column.load_when(issued, at_right.select(word(0), column + word(1)));
            at_left.load_when(issued, at_right);
            at_right.load_when(issued, comes_last(column, width));
            row.load_when(line_ends, at_bottom.select(word(0), row + word(1)));
            at_top.load_when(line_ends, at_bottom);
            at_bottom.load_when(line_ends, comes_last(row, height));
            running.load_when(frame_ends | begins, begins);
            let next_waiting = drains.select(waiting - clocks(1), waiting);
            waiting.load(frame_ends.select(clocks(drain), next_waiting));
            retrace.load(drains & waiting.is(1));
            Scanned {
                issue: issued,
                scan: Scan {
                    flags: Flags {
                        valid: issued.reg(),
                        start: (issued & at_left & at_top).reg(),
                        line: Some((issued & at_left & !at_top).reg()),
                    },
                    pixel: Pixel::of([column.reg(), row.reg()]),
                },
                line_ends: line_ends.reg(),
                retrace,
            }
        },
    )
}

/// Behind this place comes the last of so many.
fn comes_last(place: Bits, count: u64) -> Bits {
    match count {
        1 => Bits::new(1, 1),
        _ => place.is(count - 2),
    }
}

/// What is asked, `pace` clocks after it was 1 or later.
fn paced(asked: Bits, pace: u32) -> Bits {
    if pace == 1 {
        return asked;
    }
    let clocks = |value: u32| Bits::new(value.into(), pace.ilog2() + 1);
    net! {
        let pause = Bits::register(pace.ilog2() + 1);
        let is_over = pause.is(0);
    }
    let issued = asked & is_over;
    let less = is_over.select(pause, pause - clocks(1));
    pause.load(issued.select(clocks(pace - 1), less));
    issued
}
