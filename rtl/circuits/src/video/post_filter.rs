//! Smoothing filter behind the shading.

use super::{COORDINATE, Colour, LEVEL};
use imogene_hdl::{Bits, Bundle, Value, bundle, bundles, join, memory, module, net, ports};

bundle! {
    /// A pixel of a picture that goes line by line.
    Place() {
        valid: Bits(1), "this clock carries one";
        x: Bits(COORDINATE), "column, below 2048";
        y: Bits(COORDINATE), "line, below 4095";
        line_end: Bits(1), "last of its line";
        last: Bits(1), "last of the picture";
    }
}

bundles! {
    /// A pixel with its colour.
    #[derive(Copy)]
    Picture() {
        /// Where it is.
        place: Place() as "";
        /// Its colour.
        colour: Colour(LEVEL) as "";
    }
}

/// Smooths a picture with lines of at most `2^places` pixels: `kernel` 0 passes it, 1 is a box of 2 x 2, 2 and 3 are
/// binomials of 3 x 3. It is read with the first pixel of a picture. Levels are rounded to the nearest, halves up.
///
/// Pixels outside the picture are the nearest inside. A pixel leaves 6 clocks after the one to the right of it in the
/// next line came, and the last of a line 1 clock after the one before it: a line leaves while the next one comes,
/// the last line by itself from 3 clocks after the last pixel on. After a picture there are `width + 3` clocks or
/// more without a pixel, after a line 1 or more, and lines begin 3 clocks apart or more. With every kernel the same
/// clocks, so it can change from picture to picture. Chaillou 1991, IV.4.3.
pub fn post_filter(at: &str, kernel: Bits, pixel: Picture, places: u32) -> Picture {
    let meaning =
        "0 pass, 1 box of 2 x 2, 2 and 3 binomial of 3 x 3; read with the first pixel of a picture";
    let inputs = (("kernel", kernel, meaning), ("", pixel, "pixel"));
    module("post_filter", at, inputs, |(kernel, pixel)| {
        let Picture { place, colour } = pixel;
        let word = |value: u64| Bits::new(value, COORDINATE);
        let coordinate = || Bits::register(COORDINATE);
        // The pixel that comes, or the place below the last line. The line store reads the first pixel of the last
        // line when it has been written, also if it is the last. A word is written 2 clocks after it was read.
        net! {
            let kept_kernel = Bits::register(2);
            let at_origin = place.x.is(0) & place.y.is(0);
            let now_kernel = (place.valid & at_origin).select(kernel, kept_kernel);
            let ends = place.valid & place.last;
            let waits = ends.delay(2);
            let right = place.x.reg_when(ends);
            let flush_y = (place.y + word(1)).reg_when(ends);
            let flushes = Bits::register(1);
            let flush_x = coordinate();
            let flush_ends = flush_x.equals(right);
        }
        kept_kernel.load(now_kernel);
        flushes.load_when(waits | flushes, waits | !flush_ends);
        flush_x.load_when(waits | flushes, waits.select(word(0), flush_x + word(1)));
        net! {
            let now_x = flushes.select(flush_x, place.x);
            let step_1 = (place.valid | flushes).delay(2);
            let flush_1 = flushes.delay(2);
            let ends_1 = flushes.select(flush_ends, place.line_end).delay(2);
            let x_1 = now_x.delay(2);
            let y_1 = flushes.select(flush_y, place.y).delay(2);
            let kernel_1 = now_kernel.delay(2);
            let colour_1 = colour.packed().delay(2);
        }
        // A word of the store has the pixels of two lines; the older one goes out when a new one comes in.
        let lines = Bits::forward(6 * LEVEL);
        let write = (step_1 & !flush_1, x_1.low(places), lines);
        net! {
            let stored = memory("store", 1 << places, write, now_x.low(places)).reg();
            let one_up = stored.low(3 * LEVEL);
            let two_up = stored.slice(6 * LEVEL - 1, 3 * LEVEL);
            let above = y_1.is(1).select(one_up, two_up);
            let below = flush_1.select(one_up, colour_1);
        }
        lines.drive(join([one_up, colour_1]));
        // A register behind the memory and the choice, before the sums.
        let column = [above, one_up, below].map(|line| Colour::unpacked(line).registered());
        net! { let kernel_late = kernel_1.reg(); }
        let column_2 = taps("vertical", column, kernel_late).registered();
        let column_2 = column_2.called("column_2");
        net! {
            let step_2 = (step_1 & !y_1.is(0)).delay(2);
            let ends_2 = ends_1.delay(2);
            let last_2 = flush_1.delay(2);
            let x_2 = x_1.delay(2);
            let y_2 = (y_1 - word(1)).delay(2);
            let kernel_2 = kernel_late.reg();
            let is_left = x_2.is(0);
            // The column in the middle of the window.
            let ends_3 = (step_2 & ends_2).reg();
            let last_3 = last_2.reg_when(step_2);
            let left_3 = is_left.reg_when(step_2);
            let x_3 = x_2.reg_when(step_2);
            let y_3 = y_2.reg_when(step_2);
            let kernel_3 = kernel_2.reg_when(step_2);
        }
        let column_3 = column_2.registered_when(step_2).called("column_3");
        let before_3 = column_3.registered_when(step_2).called("before_3");
        let left = left_3.select(column_3, before_3);
        let right = ends_3.select(column_3, column_2);
        let sum = taps("horizontal", [left, column_3, right], kernel_3).registered();
        let half = Bits::new(8, LEVEL + 4);
        let colour = sum.map(|sum| (sum + half).slice(LEVEL + 3, 4));
        let place = Place {
            // The last column leaves by itself, any other when the next one comes.
            valid: ends_3 | (step_2 & !is_left),
            x: x_3,
            y: y_3,
            line_end: ends_3,
            last: ends_3 & last_3,
        };
        let smooth = Picture {
            place: place.registered(),
            colour,
        };
        ("out", smooth.registered(), "smooth pixel")
    })
}

/// Three neighbours of a picture, each colour by itself.
fn taps(at: &str, neighbours: [Colour; 3], kernel: Bits) -> Colour {
    Colour::of([0, 1, 2].map(|channel| {
        let values = neighbours.map(|colour| colour.parts()[channel]);
        three_taps(&format!("{at}_{channel}"), values, kernel)
    }))
}

/// Four times the weighted mean of a value and its neighbours: `4 here`, `2 earlier + 2 here` or `earlier + 2 here +
/// later`, by the kernel. The weights of every kernel have the same sum, so all are rounded alike. Without registers.
fn three_taps(at: &str, [earlier, here, later]: [Bits; 3], kernel: Bits) -> Bits {
    let inputs = ports!(earlier, here, later, kernel);
    module("three_taps", at, inputs, |ports| {
        let (earlier, here, later, kernel) = ports;
        net! {
            let is_binomial = kernel.bit(1);
            let first = is_binomial.select(earlier, kernel.bit(0).select(earlier, here));
            let third = is_binomial.select(later, kernel.bit(0).select(earlier, here));
        }
        let wide = |value: Bits| value.extend(here.width() + 2);
        ("sum", (wide(first) + wide(third)) + wide(here).left(1))
    })
}
