//! First-degree elementary processor.

use super::{Flags, HELD, Linear};
use imogene_hdl::{Bits, Int, Value, module, net};

/// `value(x, y) = a x + b y + c` modulo the width of the words, by additions alone, one pixel per clock.
///
/// Latency 1. A clock without `valid` changes nothing; the words stay as they are from `start` to the last pixel of the
/// zone. Sections 2.3.2 and B.2.1.
pub fn pe1(at: &str, flags: Flags, words: Linear) -> Int {
    let inputs = (flags, ("", words, HELD));
    module("pe1", at, inputs, |(flags, words)| {
        let register = || Int::register(words.c.width());
        net! {
            let first = flags.first();
            let line_begin = line_begin(flags, first, words);
            let pixel_value = register();
            let next_pixel = pixel_value + words.a;
        }
        pixel_value.load_when(flags.valid, first.select(line_begin, next_pixel));
        ("value", pixel_value, "a x + b y + c, modulo its width")
    })
}

/// What a line begins with, on its first pixel; in a lane it is given.
pub(super) fn line_begin(flags: Flags, first: Bits, words: Linear) -> Int {
    if flags.line.is_none() {
        return words.c;
    }
    net! {
        // Ready before the next line: one selection stands before or behind each sum.
        let next_line = Int::register(words.c.width());
        let line_begin = flags.start.select(words.c, next_line);
    }
    next_line.load_when(flags.valid & first, line_begin + words.b);
    line_begin
}
