//! Second-degree elementary processor.

use super::{Flags, HELD, Quadratic};
use imogene_hdl::{Bits, Int, Value, module, net};

/// `value(x, y) = a x^2 + b y^2 + c xy + d x + e y + f` modulo the width of the words, from preconditioned words, by
/// additions alone, one pixel per clock.
///
/// Latency 1. A clock without `valid` changes nothing; the words stay as they are from `start` to the last pixel of the
/// zone. Sections 2.3.2 and B.2.1.
pub fn pe2(at: &str, flags: Flags, words: Quadratic) -> Int {
    let inputs = (flags, ("", words, HELD));
    module("pe2", at, inputs, |(flags, words)| {
        let register = || Int::register(words.f.width());
        net! { let first = flags.first(); }
        let (line_begin, first_step) = line_begin(flags, first, words);
        net! {
            let pixel_step = register();
            let pixel_value = register();
            let next_pixel = pixel_value + pixel_step;
            let next_step = pixel_step + words.a2;
        }
        pixel_value.load_when(flags.valid, first.select(line_begin, next_pixel));
        pixel_step.load_when(flags.valid, first.select(first_step, next_step));
        let meaning = "a x^2 + b y^2 + c xy + d x + e y + f, modulo its width";
        ("value", pixel_value, meaning)
    })
}

/// What a line begins with and its first increment, on its first pixel; in a lane they are given.
pub(super) fn line_begin(flags: Flags, first: Bits, words: Quadratic) -> (Int, Int) {
    if flags.line.is_none() {
        return (words.f, words.p0);
    }
    let register = || Int::register(words.f.width());
    net! {
        // Of the next line, as in PE1.
        let next_line = register();
        let next_line_step = register();
        let next_first_step = register();
        let line_begin = flags.start.select(words.f, next_line);
        let line_step = flags.start.select(words.i0, next_line_step);
        let first_step = flags.start.select(words.p0, next_first_step);
    }
    let begin_line = flags.valid & first;
    next_line.load_when(begin_line, line_begin + line_step);
    next_line_step.load_when(begin_line, line_step + words.b2);
    next_first_step.load_when(begin_line, first_step + words.c);
    (line_begin, first_step)
}
