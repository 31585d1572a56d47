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
        let [no, yes] = [0, 1].map(|value| Bits::new(value, 1));
        let flag = || Bits::register(1);
        let place = || Bits::register(COORDINATE);
        let (valid, start, line, last) = (flag(), flag(), flag(), flag());
        let (x, y) = (place(), place());
        net! {
            let right_edge = place();
            let bottom_edge = place();
            let obeyed = zone.go & (!valid | last);
            let line_ends = x.equals(right_edge);
            let next_x = line_ends.select(word(0), x + word(1));
            let next_y = line_ends.select(y + word(1), y);
            let last_x = zone.width - word(1);
            let last_y = zone.height - word(1);
            let is_single = last_x.is(0) & last_y.is(0);
            let next_is_last = next_x.equals(right_edge) & next_y.equals(bottom_edge);
            let moves = obeyed | last | valid;
            let goes_on = !last;
        }
        right_edge.load_when(obeyed, last_x);
        bottom_edge.load_when(obeyed, last_y);
        valid.load_when(moves, obeyed.select(yes, goes_on));
        start.load_when(moves, obeyed);
        line.load_when(moves, obeyed.select(no, goes_on & line_ends));
        last.load_when(moves, obeyed.select(is_single, goes_on & next_is_last));
        x.load_when(obeyed | (goes_on & valid), obeyed.select(word(0), next_x));
        y.load_when(obeyed | (goes_on & valid), obeyed.select(word(0), next_y));
        let scan = Scan {
            flags: Flags { valid, start, line },
            pixel: Pixel { x, y },
        };
        Raster { scan, last }
    })
}
