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
        let last = |count: Bits| (count - word(1)).reg();
        net! {
            let running = Bits::register(1);
            let column = Bits::register(COORDINATE);
            let row = Bits::register(COORDINATE);
            let issue = running & room;
            let last_column = last(window.width);
            let last_row = last(window.height);
            let line_ends = column.equals(last_column);
            let zone_ends = line_ends & row.equals(last_row);
        }
        let ends = issue & zone_ends;
        running.load_when(go | ends, go);
        let next_column = (go | line_ends).select(word(0), column + word(1));
        column.load_when(go | issue, next_column);
        row.load_when(go | (issue & line_ends), go.select(word(0), row + word(1)));
        let place = [window.x0 + column, window.y0 + row];
        Issued {
            issue,
            valid: issue.delay(2),
            pixel: Pixel::of(place).delayed(2),
            is_last: ends.delay(2),
        }
    })
}
