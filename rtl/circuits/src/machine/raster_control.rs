//! The pixels of a zone, one a clock.

use super::COORDINATE;
use crate::raster::{Flags, Pixel, Scan};
use imogene_hdl::{Bits, Value, bundle, bundles, module, net};

bundle! {
    /// What starts a zone.
    Zone() {
        go: Bits(1), "begin a zone; obeyed when idle or with the last pixel of a zone, ignored otherwise";
        width: Bits(COORDINATE), "pixels of a line, at least 1; read with an obeyed go";
        height: Bits(COORDINATE), "lines of the zone, at least 1; read with an obeyed go";
    }
}

bundles! {
    /// A pixel on its way.
    #[derive(Copy)]
    Raster {
        /// Where it is.
        scan: Scan as "";
        last: Bits as "last", "last pixel of the zone";
    }
}

/// Raster flags and places of a zone of `width` by `height` pixels, one pixel a clock without a gap.
///
/// Latency 1. Section 2 of `docs/architecture.md`.
pub fn raster_control(at: &str, zone: Zone) -> Raster {
    module("raster_control", at, zone, |zone| {
        let word = |value: u64| Bits::new(value, COORDINATE);
        let flag = || Bits::register(1);
        let place = || Bits::register(COORDINATE);
        let (valid, start, line) = (flag(), flag(), flag());
        let (x, y) = (place(), place());
        net! {
            // The last column but one and the last line but one: whether the next pixel is in the last ones is asked
            // of the place of this one, without a sum.
            let column_before = place();
            let line_before = place();
            let is_narrow = flag();
            let in_last_column = flag();
            let in_last_line = flag();
            let last = valid & in_last_column & in_last_line;
            let goes_on = valid & !last;
            let obeyed = zone.go & !goes_on;
            let steps = obeyed | goes_on;
            let next_x = in_last_column.select(word(0), x + word(1));
            let next_y = in_last_column.select(y + word(1), y);
            let one_column = zone.width.is(1);
            let one_line = zone.height.is(1);
            let column_is_last = is_narrow | x.equals(column_before);
            let line_is_last = in_last_line | (in_last_column & y.equals(line_before));
        }
        column_before.load_when(obeyed, zone.width - word(2));
        line_before.load_when(obeyed, zone.height - word(2));
        is_narrow.load_when(obeyed, one_column);
        in_last_column.load_when(steps, obeyed.select(one_column, column_is_last));
        in_last_line.load_when(steps, obeyed.select(one_line, line_is_last));
        valid.load(steps);
        start.load(obeyed);
        line.load(goes_on & in_last_column);
        x.load_when(steps, obeyed.select(word(0), next_x));
        y.load_when(steps, obeyed.select(word(0), next_y));
        let scan = Scan {
            flags: Flags {
                valid,
                start,
                line: Some(line),
            },
            pixel: Pixel { x, y },
        };
        Raster { scan, last }
    })
}
