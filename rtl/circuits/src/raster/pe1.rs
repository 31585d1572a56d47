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
        let register = || Int::register(words.c.width());
        net! {
            let first = flags.start | flags.line;
            // What the next line begins with, ready before it: one selection stands before or behind each sum.
            let next_line = register();
            let pixel_value = register();
            let line_begin = flags.start.select(words.c, next_line);
            let next_pixel = pixel_value + words.a;
        }
        next_line.load_when(flags.valid & first, line_begin + words.b);
        pixel_value.load_when(flags.valid, first.select(line_begin, next_pixel));
        ("value", pixel_value, "a x + b y + c, modulo its width")
    })
}
