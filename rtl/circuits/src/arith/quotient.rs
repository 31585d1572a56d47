//! Quotient of two numbers by a restoring array.

use crate::rows::numbered;
use imogene_hdl::{Bits, Bundle, Int, Value, bundle, join, module, net, ports};

bundle! {
    /// A quotient rounded down, if a word has it.
    Quotient(word) {
        word: Int(word), "numerator / denominator, rounded down, if no other output is 1";
        is_above: Bits(1), "the quotient is above every word, if is_below is 0";
        is_below: Bits(1), "the quotient is below every word";
        is_down: Bits(1), "the denominator is negative";
    }

    /// What a row takes, and, called `next`, what it leaves.
    Division(denominator, digits) {
        denominator: Bits(denominator), "size of the denominator";
        rest: Bits(denominator - 1), "what is left of the dividend so far: less than the denominator";
        digits: Bits(digits), "bits of the dividend that are not used yet, and behind them the digits found";
    }
}

/// Clocks of a quotient of so many bits.
pub fn quotient_clocks(bits: u32, rows_per_stage: u32) -> u32 {
    2 + bits.div_ceil(rows_per_stage)
}

/// The word of `bits` bits that a numerator of as many bits more than its denominator is divided to, rounded down.
///
/// Both are negated where the denominator is negative. The least word times the denominator is added first, so no
/// digit is that of a negative number. Over a denominator of zero every numerator is above or below. Latency
/// `ceil(bits / rows_per_stage) + 2`. Section 2.1.1 (c' = 0).
pub fn quotient(at: &str, (numerator, denominator): (Int, Int), rows_per_stage: u32) -> Quotient {
    let inputs = ports!(numerator, denominator);
    module("quotient", at, inputs, |(numerator, denominator)| {
        let bits = numerator.width() - denominator.width();
        let whole = numerator.width() + 1;
        let is_down = denominator.is_negative();
        let upwards = |number: Int| is_down.select(Int::new(0, number.width()) - number, number);
        net! {
            let size = upwards(denominator).bits().reg();
            let lifted = upwards(numerator.extend(whole)).reg();
            let least = join([size, Bits::new(0, bits - 1)]).extend(whole).int();
            let dividend = (lifted + least).reg();
            let size_late = size.reg();
            let rest = dividend.bits().slice(whole - 2, bits);
        }
        let division = Division {
            denominator: size_late,
            rest: rest.low(rest.width() - 1),
            digits: dividend.low(bits).bits(),
        };
        let rows = (0..bits).step_by(rows_per_stage as usize);
        let last = numbered("stages", rows).fold(division, |division, (at, first)| {
            stage(&at, division, rows_per_stage.min(bits - first))
        });
        let stages = bits.div_ceil(rows_per_stage);
        // The least word was added: the highest digit is the other way round.
        net! { let word = last.digits ^ join([Bits::new(1, 1), Bits::new(0, bits - 1)]); }
        Quotient {
            word: word.int(),
            is_above: (!rest.less(size_late)).delayed_as("is_above_late", stages),
            is_below: dividend.is_negative().delayed_as("is_below_late", stages),
            is_down: is_down.delayed_as("is_down_late", stages + 2),
        }
    })
}

/// Some rows, then registers.
fn stage(at: &str, division: Division, rows: u32) -> Division {
    module("quotient_stage", at, division, |division| {
        let rows = numbered("rows", 0..rows);
        let last = rows.fold(division, |division, (at, _)| row(&at, division));
        ("next", last.registered())
    })
}

/// One digit: 1 where the denominator can be taken from what is left and the next bit.
fn row(at: &str, division: Division) -> Division {
    module("quotient_row", at, division, |division| {
        let (digits, own) = (division.digits, division.rest.width());
        net! {
            let dividend = join([division.rest, digits.high(1)]);
            let trial = dividend.extend(own + 2).int() - division.denominator.extend(own + 2).int();
            let negative = trial.is_negative();
            let left = negative.select(dividend.low(own), trial.low(own).bits());
        }
        let next = Division {
            rest: left,
            digits: join([digits.low(digits.width() - 1), !negative]),
            ..division
        };
        ("next", next)
    })
}
