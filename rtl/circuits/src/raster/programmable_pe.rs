//! Programmable elementary processor: one of second degree, or four of first degree.

use super::Flags;
use imogene_hdl::{Bits, Int, Value, bundle, bundles, join, module, net, ports};

bundle! {
    /// What a programmable processor is to be, read with its words.
    Program() {
        split: Bits(1), "four polynomials of first degree, not one of second";
        used: Bits(4), "bit i: the decision asks lane i";
    }

    /// Words of a polynomial of second degree, or of four of first degree.
    SplitWords(width) {
        a2: Int(width), "2a; split, a of lanes 2 (low half) and 3";
        b2: Int(width), "2b; split, a of lanes 0 (low half) and 1";
        c: Int(width), "c; split, b of lanes 2 and 3";
        i0: Int(width), "e + b; split, b of lanes 0 and 1";
        p0: Int(width), "d + a; split, c of lanes 2 and 3";
        f: Int(width), "f; split, c of lanes 0 and 1";
    }
}

bundles! {
    /// What a programmable processor gives.
    Programmed {
        value: Int as "value", "polynomial of second degree, modulo its width";
        lanes: Vec<Int> as "lane", "split, the polynomial of lane #, modulo its width";
        is_inside: Bits as "is_inside", "no used lane, or not the value, is negative; one clock after the values";
    }
}

/// One second-degree processor, or four first-degree processors of half its bits with the decision on their signs.
///
/// Of second degree the words are those of a PE2. Split, each is two words, the low half first: lanes 0 and 1 take a
/// from `b2`, b from `i0`, c from `f`; lanes 2 and 3 take a from `a2`, b from `c`, c from `p0`. The eight registers
/// of a PE2 hold exactly the words of four PE1; added are an AND in each carry chain, one choice of an addend and the
/// decision.
///
/// Latency 1, the decision 2. Words are read on a clock with `valid` and `start` only. Chaillou 1991, IV.1.7.
pub fn programmable_pe(at: &str, flags: Flags, program: Program, words: SplitWords) -> Programmed {
    let inputs = (flags, ("", (program, words), "read with start"));
    module("programmable_pe", at, inputs, |(flags, own)| {
        let (program, words) = own;
        let width = words.f.width();
        let load = flags.valid & flags.start;
        let register = || Bits::register(width);
        net! {
            let first = flags.first();
            let is_split = program.split.reg_when(load);
            let kept_used = program.used.reg_when(load);
            let kept_a2 = words.a2.bits().reg_when(load);
            let kept_b2 = words.b2.bits().reg_when(load);
            let kept_c = words.c.bits().reg_when(load);
            let line_value = register();
            let line_step = register();
            let first_step = register();
            let pixel_step = register();
            let pixel_value = register();
            let value_step = is_split.select(kept_b2, pixel_step);
        }
        let sum = |at: &str, a: Bits, b: Bits| split_adder(at, a, b, is_split);
        let next_pixel = sum("next_pixel", pixel_value, value_step);
        let next_pixel_step = sum("next_pixel_step", pixel_step, kept_a2);
        let next_line = sum("next_line", line_value, line_step);
        let next_line_step = sum("next_line_step", line_step, kept_b2);
        let next_first_step = sum("next_first_step", first_step, kept_c);
        net! {
            let line_begin = flags.start.select(words.f.bits(), next_line);
            // Split, the increment of a line is the coefficient itself.
            let later_step = is_split.select(line_step, next_line_step);
            let line_begin_step = flags.start.select(words.i0.bits(), later_step);
            let first_begin_step = flags.start.select(words.p0.bits(), next_first_step);
        }
        let load_line = flags.valid & first;
        line_value.load_when(load_line, line_begin);
        line_step.load_when(load_line, line_begin_step);
        first_step.load_when(load_line, first_begin_step);
        pixel_value.load_when(flags.valid, first.select(line_begin, next_pixel));
        pixel_step.load_when(flags.valid, first.select(first_begin_step, next_pixel_step));
        let halves = |word: Bits| [word.low(width / 2), word.slice(width - 1, width / 2)];
        let lanes = [pixel_value, pixel_step].into_iter().flat_map(halves);
        let lanes: Vec<Int> = lanes.map(Bits::int).collect();
        let signs = lanes.iter().map(|lane| lane.is_negative());
        let used = |(sign, lane): (Bits, u32)| sign & kept_used.bit(lane);
        let lane_out = signs.zip(0..).map(used).reduce(|a, b| a | b);
        let is_outside = is_split.select(lane_out.expect("lanes"), pixel_value.top());
        Programmed {
            value: pixel_value.int(),
            lanes,
            is_inside: (!is_outside).reg(),
        }
    })
}

/// One sum, or two sums of half the bits side by side: an adder with one AND in its carry chain. Latency 0. Chaillou
/// 1991, IV.1.7.
fn split_adder(at: &str, a: Bits, b: Bits, split: Bits) -> Bits {
    module("split_adder", at, ports!(a, b, split), |(a, b, split)| {
        let half = a.width() / 2;
        let low_half = |word: Bits| word.low(half).extend(half + 1);
        let high_half = |word: Bits| word.slice(2 * half - 1, half);
        net! {
            let low = low_half(a) + low_half(b);
            let carry = low.top() & !split;
            let without_carry = high_half(a) + high_half(b);
            let high = carry.select(without_carry + Bits::new(1, half), without_carry);
        }
        ("sum", join([high, low.low(half)]))
    })
}
