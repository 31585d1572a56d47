//! From words of ten bits to pairs of bits, on a clock five times as fast.

use super::tmds_encoder::SYMBOL;
use imogene_hdl::{Bits, Value, bundle, module, net};

bundle! {
    /// The words of a channel, from the clock of the pixels.
    Symbols() {
        turn: Bits(1), "1 with the first word, another value with every other";
        word: Bits(SYMBOL), "the word, which stands for at least five clocks";
    }
}

/// Sends the words of a channel, two bits per clock, for the two edges of a clock; bit 0 is sent first.
///
/// The words come from the clock of the pixels, a fifth of this one. `turn` goes through three registers, and the words
/// are taken with the third: three of the five clocks behind the edge that changed them, two before the next one. The
/// last pair of a word that stands longer is sent again. Between two registers is one look-up table at most, for a
/// clock of 371.25 MHz; two of them are for the way across the part to the pin. Latency 6 from a change of `turn` to
/// the first pair.
pub fn tmds_serialiser(at: &str, symbols: Symbols) -> Bits {
    module("tmds_serialiser", at, symbols, |symbols| {
        let pair = |index: u32| symbols.word.slice(2 * index + 1, 2 * index);
        net! {
            let turn_seen = symbols.turn.reg();
            let turn_before = turn_seen.reg();
            let takes = (turn_seen ^ turn_before).reg();
            let pair_4 = pair(4).reg();
            let pair_3 = takes.select(pair(3), pair_4).reg();
            let pair_2 = takes.select(pair(2), pair_3).reg();
            let pair_1 = takes.select(pair(1), pair_2).reg();
            let pair_0 = takes.select(pair(0), pair_1).reg();
            let leaving = pair_0.reg();
            let on_the_way = leaving.reg();
            // A register more, which may stand beside the pin.
            let sent = on_the_way.reg();
        }
        ("pair", sent, "two bits of the word, bit 0 first")
    })
}
