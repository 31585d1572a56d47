//! The rasters of a tile: that of its screen, and that of the window that goes over it.

use crate::raster::Flags;
use imogene_contract::tile::{THRESHOLD, TileWords};
use imogene_contract::video::Span;
use imogene_hdl::{Bits, Value, bundles, join, module, net};

bundles! {
    /// Where both rasters are.
    #[derive(Copy)]
    TileScan {
        hsync: Bits as "hsync", "synchronisation of the line, with the polarity of the mode";
        vsync: Bits as "vsync", "synchronisation of the frame, with the polarity of the mode";
        is_shown: Bits as "is_shown", "a pixel is shown; one clock before the synchronisation beside it";
        threshold: Bits as "threshold", "of the dither at this pixel";
        /// Raster flags of the window, some clocks before the screen wants its pixels.
        flags: Flags as "";
        steps: Bits as "steps", "once a frame, while nothing of the window is drawn";
        goes_right: Bits as "goes_right", "the window goes to the right";
    }
}

/// A position that begins again behind where it `ends`, and whether it does.
fn counter(
    name: &str,
    (span, begin): (Span, u64),
    steps: Bits,
    ends: impl Fn(Bits) -> Bits,
) -> [Bits; 2] {
    // A line or a frame may be longer by one.
    let width = span.total().ilog2() + 1;
    let place = Bits::register(width).initially(begin).named(name);
    let ends = ends(place).named(&format!("{name}_ends"));
    let next = place + Bits::new(1, width);
    place.load_when(steps, ends.select(Bits::new(0, width), next));
    [place, steps & ends]
}

/// The synchronisation of a span, which begins and ends where it `may_change`.
fn synchronisation(
    name: &str,
    (span, is_high): (Span, bool),
    place: Bits,
    may_change: Bits,
) -> Bits {
    let in_sync = Bits::register(1).named(name);
    let begins = place.is(span.front);
    let ends = place.is(span.front + span.sync);
    in_sync.load_when(may_change & (begins | ends), begins);
    if is_high { in_sync } else { !in_sync }
}

fn below(place: Bits, value: u64) -> Bits {
    place.less(Bits::new(value, place.width()))
}

/// The raster of the screen and that of the window. What is between them is where the window stands: it goes to the
/// right or left as one line of its raster, below the window, is a clock longer or shorter in each frame, and down or
/// up as each of its frames is a line longer or shorter.
///
/// A line is front porch, synchronisation, back porch, shown part, and a frame its lines in the same order. The window
/// is `lead` clocks ahead of the screen.
pub fn tile_raster(at: &str, words: &TileWords, lead: u64) -> TileScan {
    module("tile_raster", at, (), |()| {
        let (mode, window) = (&words.mode, words.window);
        let (line, frame) = (mode.line, mode.frame);
        let always = Bits::new(1, 1);
        let last = |span: Span| move |place: Bits| place.is(span.total() - 1);
        let [column, line_ends] = counter("column", (line, 0), always, last(line));
        let [row, _] = counter("row", (frame, 0), line_ends, last(frame));
        let goes_right = Bits::register(1).initially(1);
        net! {
            let goes_down = Bits::register(1).initially(1);
            let steps = Bits::forward(1);
        }
        // Where the screen is when the window begins at a place.
        let corner = [line.blank() - lead, frame.blank()];
        let behind =
            |axis: usize, span: Span| (span, span.total() - corner[axis] - words.start[axis]);
        let ends = |ahead: Bits, place: Bits, span: Span| {
            ahead.select(place.is(span.total()), place.is(span.total() - 2))
        };
        let line_ends = |x: Bits| steps.select(ends(goes_right, x, line), last(line)(x));
        let [x, window_line_ends] = counter("x", behind(0, line), always, line_ends);
        let frame_ends = |y: Bits| ends(goes_down, y, frame);
        // The first frame is longer, too.
        let [y, _] = counter("y", behind(1, frame), window_line_ends, frame_ends);
        net! {
            let is_left = x.is(0);
            let is_top = y.is(0);
            let begins = is_left & is_top;
        }
        steps.drive(y.is(window[1]));
        for (axis, ahead, place, span) in
            [(0, goes_right, column, line), (1, goes_down, row, frame)]
        {
            let edges = [0, span.active - window[axis]];
            let [is_first, is_last] = edges.map(|edge| place.is(corner[axis] + edge));
            ahead.load_when(begins & (is_first | is_last), is_first);
        }
        let in_hsync = synchronisation("in_hsync", (line, mode.hsync_high), column, always);
        let at_hsync = column.is(line.front);
        let in_vsync = synchronisation("in_vsync", (frame, mode.vsync_high), row, at_hsync);
        let low = |place: Bits, span: Span| {
            let bits = THRESHOLD / 2;
            place.low(bits) - Bits::new(span.blank() % (1 << bits), bits)
        };
        let [low_x, low_y] = [low(column, line), low(row, frame)];
        let pair = |place: u32| [low_x.bit(place) ^ low_y.bit(place), low_y.bit(place)];
        let [[a, b], [c, d]] = [0, 1].map(pair);
        TileScan {
            hsync: in_hsync,
            vsync: in_vsync,
            is_shown: !(below(column, line.blank()) | below(row, frame.blank())),
            threshold: join([a, b, c, d]),
            flags: Flags {
                valid: below(x, window[0]) & below(y, window[1]),
                start: begins,
                line: Some(is_left & !is_top),
            },
            steps: steps & window_line_ends,
            goes_right,
        }
    })
}
