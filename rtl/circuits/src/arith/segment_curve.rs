//! A function by parabolas over equal segments.

use crate::rows::numbered;
use imogene_hdl::{Bits, Int, Value, module, net, ports};

/// Bits of the place in a segment.
const PLACE: u32 = 14;
/// Bits of the coefficients of second and first degree, and of the factors.
const FACTOR: u32 = 18;
/// Bits of the constant coefficient and of the value.
const VALUE: u32 = 24;

/// A function and how it is cut.
pub(super) struct Curve {
    /// The function.
    pub function: fn(f64) -> f64,
    /// Length of a segment.
    pub length: f64,
    /// Bits of the value after the point.
    pub fraction: u32,
}

/// `c0 + ((c1 + ((c2 x) >> 14)) x >> 14)` at the 14 bits `x` of a place, the coefficients chosen by the segment;
/// shifts round down.
///
/// The coefficients are constants, chosen by a tree of multiplexers. Latency 7: coefficients, product, sum, product,
/// sum; and a register before each multiplier, for the wires that lead to it. Each coefficient is chosen when it is
/// needed, for the number of the segment has fewer bits to keep.
pub(super) fn segment_curve(at: &str, segment: Bits, place: Bits, curve: &Curve) -> Int {
    let inputs = ports!(segment, place);
    module("segment_curve", at, inputs, |(segment, place)| {
        let [bend, slope, base] = coefficients(segment, curve);
        let factor = |place: Bits| place.extend(FACTOR).int();
        let part = |product: Int| product.slice(PLACE + FACTOR - 1, PLACE).int();
        net! {
            let place_1 = place.delay(2);
            let kept_bend = (bend * factor(place_1)).reg();
            let place_2 = place_1.reg();
            let slope_2 = slope;
            let kept_slope = (slope_2 + part(kept_bend)).reg();
            let place_3 = place_2.delay(2);
            let kept_rise = (kept_slope.reg() * factor(place_3)).reg();
        }
        ("value", (base + part(kept_rise).extend(VALUE)).reg())
    })
}

/// Bend, slope and base, each chosen in the clock before its use but the first, for the register of its multiplier.
fn coefficients(segment: Bits, curve: &Curve) -> [Int; 3] {
    let later = segment.delayed_as("segment_late", 2);
    let last = later.delayed_as("segment_last", 3);
    let bend = chosen("bend_choice", segment, curve, (0, FACTOR));
    net! {
        let bend = bend.reg();
        let slope = chosen("slope_choice", later, curve, (FACTOR, FACTOR));
        let base = chosen("base_choice", last, curve, (2 * FACTOR, VALUE));
    }
    [bend, slope, base].map(Bits::int)
}

/// So many bits from one on of the coefficients of a segment, in a register.
fn chosen(name: &str, segment: Bits, curve: &Curve, (low, width): (u32, u32)) -> Bits {
    let word = |index: u32| (curve.word(index) >> low) & ((1 << width) - 1);
    let segments = 0..1 << segment.width();
    let mut choices: Vec<Bits> = segments
        .map(|index| Bits::new(word(index), width))
        .collect();
    for level in 0..segment.width() {
        let pairs = numbered(&format!("{name}_{level}"), choices.chunks(2));
        let choice = |(name, pair): (String, &[Bits])| {
            let choice = segment.bit(level).select(pair[1], pair[0]);
            choice.named(&name)
        };
        choices = pairs.map(choice).collect();
    }
    // Bits that all segments share stay constants, not registers.
    choices[0].reg().initially(word(0))
}

impl Curve {
    /// Coefficients of a segment in one word, the constant one in front.
    fn word(&self, segment: u32) -> u64 {
        let [c0, c1, c2] = self.coefficients(segment);
        let part = |value: i64, width: u32| value as u64 & ((1 << width) - 1);
        part(c0, VALUE) << (2 * FACTOR) | part(c1, FACTOR) << FACTOR | part(c2, FACTOR)
    }

    /// Coefficients of the parabola that meets the function at the Chebyshev nodes of a segment; the constant one is
    /// half a unit higher for the floors that follow.
    fn coefficients(&self, segment: u32) -> [i64; 3] {
        let unit = f64::from(self.fraction).exp2();
        let node = 0.75f64.sqrt() / 2.0;
        let at = |t: f64| (self.function)((f64::from(segment) + t) * self.length);
        let (low, middle, high) = (at(0.5 - node), at(0.5), at(0.5 + node));
        let bend = (low - 2.0 * middle + high) * (8.0 / 3.0);
        let slope = (high - low) / (2.0 * node);
        [
            ((middle - slope / 2.0 + bend / 4.0) * unit + 0.5).round() as i64,
            ((slope - bend) * unit).round() as i64,
            (bend * unit).round() as i64,
        ]
    }
}
