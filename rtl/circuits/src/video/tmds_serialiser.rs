//! From words of ten bits to pairs of bits, on a clock five times as fast.

use super::tmds_encoder::SYMBOL;
use imogene_hdl::{Bits, Value, bundle, module, net};

bundle! {
    /// Symbols from the clock of the pixels.
    Symbols() {
        turn: Bits(1), "another value with every pixel";
        red: Bits(SYMBOL), "word of the red channel";
        green: Bits(SYMBOL), "word of the green channel";
        blue: Bits(SYMBOL), "word of the blue channel";
    }

    /// Two bits of each channel, for the two edges of a clock; bit 0 is sent first.
    Pairs() {
        red: Bits(2), "red channel";
        green: Bits(2), "green channel";
        blue: Bits(2), "blue channel";
        clock: Bits(2), "clock channel: five ones and five zeros";
    }
}

/// Sends the words of three channels and the clock of the pixels, two bits per clock.
///
/// The words come from the clock of the pixels, a fifth of this one. `turn` goes through two registers, and the words
/// are taken in the clock after the first: one to two of the five clocks behind the edge that changed them, three
/// before the next one. Latency 2 from a change of `turn` to the first pair.
pub fn tmds_serialiser(at: &str, words: Symbols) -> Pairs {
    module("tmds_serialiser", at, words, |words| {
        net! {
            let turn_seen = words.turn.reg();
            let turn_before = turn_seen.reg();
            let takes = turn_seen ^ turn_before;
        }
        let sent = |name: &str, word: Bits| {
            let shift = Bits::register(SYMBOL).named(name);
            let rest = shift.high(SYMBOL - 2).extend(SYMBOL);
            shift.load(takes.select(word, rest));
            shift.low(2)
        };
        let pairs = Pairs {
            red: sent("red_shift", words.red),
            green: sent("green_shift", words.green),
            blue: sent("blue_shift", words.blue),
            clock: sent("clock_shift", Bits::new(0b00000_11111, SYMBOL)),
        };
        ("pair", pairs)
    })
}
