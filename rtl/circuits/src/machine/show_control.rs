//! Pixels of a zone on their way to the shading processor.

use super::COORDINATE;
use crate::raster::Pixel;
use imogene_hdl::{Bits, Bundle, Value, bundle, bundles, module, net, ports};

bundle! {
    /// A rectangle of the screen.
    Window() {
        x0: Bits(COORDINATE), "first column";
        y0: Bits(COORDINATE), "first line";
        width: Bits(COORDINATE), "columns";
        height: Bits(COORDINATE), "lines";
    }
}

bundles! {
    /// A pixel that is shown.
    #[derive(Copy)]
    Issued {
        issue: Bits as "issue", "a pixel is issued on this clock";
        valid: Bits as "valid", "one was issued two clocks before";
        pixel: Pixel as "", "its place on the screen";
        is_last: Bits as "is_last", "it is the last of the zone";
    }
}

/// Scans a zone left to right, top to bottom, on clocks on which there is `room` behind the shading processor.
///
/// The window stands a clock before `go`, and stays as it is until the last pixel was issued. Latency 2.
/// `docs/zone-machine.md`.
pub fn show_control(at: &str, go: Bits, room: Bits, window: Window) -> Issued {
    let inputs = (ports!(go, room), window);
    module("show_control", at, inputs, |((go, room), window)| {
        let word = |value: u64| Bits::new(value, COORDINATE);
        let before = |count: Bits| (count - word(2)).reg();
        let flag = || Bits::register(1);
        net! {
            let running = flag();
            let column = Bits::register(COORDINATE);
            let row = Bits::register(COORDINATE);
            let issue = running & room;
            // Known one pixel before.
            let in_last_column = flag();
            let in_last_row = flag();
            let column_before = before(window.width);
            let row_before = before(window.height);
            let one_column = window.width.is(1).reg();
            let one_row = window.height.is(1).reg();
            let line_ends = issue & in_last_column;
            let ends = line_ends & in_last_row;
            let column_is_last = one_column | (!go & column.equals(column_before));
            let row_is_last = one_row | (!go & row.equals(row_before));
            let next_column = (go | in_last_column).select(word(0), column + word(1));
            let next_row = go.select(word(0), row + word(1));
        }
        running.load_when(go | ends, go);
        column.load_when(go | issue, next_column);
        in_last_column.load_when(go | issue, column_is_last);
        row.load_when(go | line_ends, next_row);
        in_last_row.load_when(go | line_ends, row_is_last);
        let place = [window.x0 + column, window.y0 + row];
        Issued {
            issue,
            valid: issue.delay(2),
            pixel: Pixel::of(place).delayed(2),
            is_last: ends.delay(2),
        }
    })
}
