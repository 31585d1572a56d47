//! First-degree elementary processor.

use super::{Flags, HELD, Linear};
use imogene_hdl::{Int, Value, module, net};

/// `value(x, y) = a x + b y + c` modulo the width of the words, by additions alone, one pixel per clock.
///
/// Latency 1. A clock without `valid` changes nothing; the words stay as they are from `start` to the last pixel of the
/// zone. Sections 2.3.2 and B.2.1.
pub fn pe1(at: &str, flags: Flags, words: Linear) -> Int {
    let inputs = (flags, ("", words, HELD));
    module("pe1", at, inputs, |(flags, words)| {
        net! {
            let first = flags.start | flags.line;
            let line_value = Int::register(words.c.width());
            let pixel_value = Int::register(words.c.width());
            let next_line = line_value + words.b;
            let next_pixel = pixel_value + words.a;
            // The first pixel of a line takes what the line begins with: one selection behind each sum.
            let line_begin = flags.start.select(words.c, next_line);
        }
        line_value.load_when(flags.valid & first, line_begin);
        pixel_value.load_when(flags.valid, first.select(line_begin, next_pixel));
        ("value", pixel_value, "a x + b y + c, modulo its width")
    })
}
