//! Logarithms to base 2 and powers of two.

use super::normalise::{NORMALISED, shifted};
use super::segment_curve::{Curve, segment_curve};
use super::vector::SQUARE_ZEROS;
use imogene_hdl::{Bits, Int, Value, join, module, net};

/// Latency of a logarithm.
pub const LOGARITHM: u32 = NORMALISED + 8;
/// Latency of a power of two.
pub const POWER_OF_TWO: u32 = 10;
/// Latency of the logarithm of a sum.
pub const LOGARITHM_OF_SUM: u32 = 7;
const LOG_CURVE: Curve = Curve {
    function: |t| (1.0 + t).log2(),
    length: 1.0 / 32.0,
    fraction: 20,
};
const POWER: Curve = Curve {
    function: |t| (-t).exp2(),
    length: 1.0 / 8.0,
    fraction: 17,
};
const FALL: Curve = Curve {
    function: |t| (1.0 + (-t).exp2()).log2(),
    length: 0.25,
    fraction: 18,
};

/// `log2(number)` in 28 bits, 20 of them after the point; 0 has none. The number has 20 bits at least.
///
/// The octave by shifting to the leading one, the 19 bits behind it through a curve of 32 segments. Latency
/// [`LOGARITHM`].
pub fn logarithm(at: &str, number: Bits) -> Int {
    logarithm_below(at, number, number.width() - 1)
}

/// The same of the square of a vector in full words.
pub fn logarithm_of_square(at: &str, square: Bits) -> Int {
    logarithm_below(at, square, SQUARE_ZEROS)
}

/// The same of a number with at most so many zeros above its leading one.
fn logarithm_below(at: &str, number: Bits, zeros: u32) -> Int {
    module("logarithm", at, ("number", number), |number| {
        let width = number.width();
        let full = shifted(vec![number], None, zeros);
        let [segment, place] =
            [(2, 6), (7, 20)].map(|(high, low)| full.words[0].slice(width - high, width - low));
        let part = segment_curve("curve", segment, place, &LOG_CURVE);
        let octave = Bits::new(u64::from(width) - 1, 6) - full.places;
        let octave = octave.delayed_as("octave", 7);
        net! { let whole = join([octave, Bits::new(0, 20)]).extend(28).int(); }
        ("value", (whole + part.extend(28)).reg())
    })
}

/// `2^-loss` in 17 bits, all after the point, at most `1 - 2^-17`; of the loss 21 bits are after the point.
///
/// The first 17 bits after the point through a curve of 8 segments, then shifts by the octaves. Latency
/// [`POWER_OF_TWO`].
pub fn power_of_two(at: &str, loss: Bits) -> Bits {
    module("power_of_two", at, ("loss", loss), |loss| {
        let power = segment_curve("curve", loss.slice(20, 18), loss.slice(17, 4), &POWER);
        let octaves = loss.slice(loss.width() - 1, 21);
        let is_none = !octaves.slice(octaves.width() - 1, 5).is(0);
        let octaves = join([is_none, octaves.low(5)]).delayed_as("octaves", 7);
        let eights = join([octaves.slice(4, 3), Bits::new(0, 3)]);
        let power = power.slice(17, 0);
        net! {
            let shifted_eights = octaves.top().select(Bits::new(0, 18), power.right_by(eights)).reg();
            let octaves_left = octaves.low(3).reg();
            let shifted = shifted_eights.right_by(octaves_left).reg();
        }
        let most = Bits::new((1 << 17) - 1, 17);
        ("value", shifted.top().select(most, shifted.low(17)).reg())
    })
}

/// `log2(1 + 2^-t)` in 24 bits, 18 of them after the point, of a number t of which 21 bits are after the point; 0
/// from 16 on.
///
/// A curve of 64 segments. Latency [`LOGARITHM_OF_SUM`].
pub fn logarithm_of_sum(at: &str, number: Bits) -> Bits {
    let beyond = !number.slice(number.width() - 1, 25).is(0);
    let value = segment_curve(at, number.slice(24, 19), number.slice(18, 5), &FALL).bits();
    let beyond = beyond.delayed_as("is_beyond", LOGARITHM_OF_SUM);
    beyond.select(Bits::new(0, value.width()), value)
}
