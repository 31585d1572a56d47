//! The raster of transparent objects in a showing pass.

use super::COORDINATE;
use crate::raster::{Flags, Pixel, Scan};
use imogene_hdl::{Bits, Value, module, net, ports};

/// Flags and places of the pixels of a zone, counted from its first, on the clocks on which they are issued; the pass
/// begins a clock after `go`. Latency 0.
pub(super) fn layer_raster(at: &str, go: Bits, issue: Bits, width: Bits) -> Scan {
    let inputs = ports!(go, issue, width);
    module("layer_raster", at, inputs, |(go, issue, width)| {
        let word = |value: u64| Bits::new(value, COORDINATE);
        net! {
            let is_first = Bits::register(1);
            let at_left = Bits::register(1);
            let column = Bits::register(COORDINATE);
            let row = Bits::register(COORDINATE);
            let last_column = (width - word(1)).reg();
            let at_right = column.equals(last_column);
        }
        is_first.load_when(go | issue, go);
        at_left.load_when(go | issue, go | at_right);
        let next_column = (go | at_right).select(word(0), column + word(1));
        column.load_when(go | issue, next_column);
        row.load_when(go | (issue & at_right), go.select(word(0), row + word(1)));
        Scan {
            flags: Flags {
                valid: issue,
                start: issue & is_first,
                line: Some(issue & at_left & !is_first),
            },
            pixel: Pixel { x: column, y: row },
        }
    })
}
