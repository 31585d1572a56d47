//! What the shading processor computes of numbers and vectors: functions by parabolas over equal segments.

use super::widths::ShaderWidths;

/// The functions that are tabulated, and the widths they work at. A *loss* is the negative logarithm to base 2 of a
/// factor, with one bit more after the point than a logarithm.
pub(super) struct Curves {
    pub widths: ShaderWidths,
    logarithm: Curve,
    power: Curve,
    fall: Curve,
}

/// Bits of the number of a segment, for each curve.
const LOGARITHM_SEGMENTS: u32 = 5;
const POWER_SEGMENTS: u32 = 3;
const FALL_SEGMENTS: u32 = 6;
/// Bits after the point of the attenuation's curve, and of its argument before the point.
const FALL_FRACTION: u32 = 18;
const FALL_RANGE: u32 = 4;
/// Bits of a loss before its point: 32 octaves leave nothing.
const LOSS_RANGE: u32 = 5;

impl Curves {
    pub fn new(widths: &ShaderWidths) -> Curves {
        let curve = |function: fn(f64) -> f64, segments: u32, length: f64, fraction: u32| {
            Curve::new(function, segments, length, widths.place, fraction)
        };
        // One octave in equal segments.
        let part = |segments: u32| (-f64::from(segments)).exp2();
        let (log, power) = (LOGARITHM_SEGMENTS, POWER_SEGMENTS);
        let fall = |t: f64| (1.0 + (-t).exp2()).log2();
        Curves {
            widths: *widths,
            logarithm: curve(|t| (1.0 + t).log2(), log, part(log), widths.logarithm),
            power: curve(|t| (-t).exp2(), power, part(power), widths.power),
            fall: curve(fall, FALL_SEGMENTS, 0.25, FALL_FRACTION),
        }
    }

    /// Bits after the point of a loss.
    pub fn loss_fraction(&self) -> u32 {
        self.widths.logarithm + 1
    }

    /// The greatest loss.
    pub fn most(&self) -> i64 {
        (1 << (LOSS_RANGE + self.loss_fraction())) - 1
    }

    /// `log2` of a number; that of 0 is that of 1.
    pub fn log2(&self, number: i64) -> i64 {
        let number = number.max(1);
        let octave = number.ilog2();
        let bits = LOGARITHM_SEGMENTS + self.widths.place;
        let fraction = (number as u64) << (63 - octave) << 1 >> (64 - bits);
        (i64::from(octave) << self.widths.logarithm) + self.logarithm.value(fraction)
    }

    /// The factor of a loss, below 1.
    pub fn factor(&self, loss: i64) -> i64 {
        let point = self.loss_fraction();
        let bits = POWER_SEGMENTS + self.widths.place;
        let octaves = (loss >> point).min(63);
        let fraction = loss & ((1 << point) - 1);
        let value = self.power.value((fraction >> (point - bits)) as u64);
        let factor = value << self.widths.factor >> self.widths.power >> octaves;
        factor.min((1 << self.widths.factor) - 1)
    }

    /// The loss of `1 / (1 + 2^e)`, with `e` in the units of a loss.
    pub fn attenuation(&self, e: i64) -> i64 {
        let bits = FALL_SEGMENTS + self.widths.place;
        let argument = e.abs() >> (self.loss_fraction() + FALL_RANGE - bits);
        let fall = if argument >> bits == 0 {
            self.fall.value(argument as u64) << self.loss_fraction() >> FALL_FRACTION
        } else {
            0
        };
        (fall + e.max(0)).min(self.most())
    }
}

/// A vector shifted to the left until its longest component fills `bits` bits, by `bits - 2` at most, and the places it
/// was shifted.
pub(super) fn normalised(vector: [i64; 3], bits: u32) -> ([i64; 3], u32) {
    let magnitude = vector.iter().fold(1, |all, v| all | (v ^ (v >> 63)));
    let length = 64 - magnitude.leading_zeros();
    let places = bits - 1 - length;
    (vector.map(|v| v << places), places)
}

pub(super) fn dot(a: [i64; 3], b: [i64; 3]) -> i64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// A function of one argument: `c0 + (c1 + c2 x) x` in each of `2^n` segments, `x` the place in the segment.
#[derive(Clone, Debug)]
pub struct Curve {
    place: u32,
    coefficients: Vec<[i64; 3]>,
}

impl Curve {
    /// The curve of `function` over `0 .. 2^n * length` in `2^n` segments, with `place` bits of place and `fraction`
    /// bits after the point.
    ///
    /// A parabola meets the function at the three Chebyshev nodes of its segment; `c0` is half a unit higher for the
    /// floors that follow.
    pub fn new(
        function: impl Fn(f64) -> f64,
        n: u32,
        length: f64,
        place: u32,
        fraction: u32,
    ) -> Curve {
        let unit = f64::from(fraction).exp2();
        let node = 0.75f64.sqrt() / 2.0;
        let segment = |i: u32| {
            let at = |t: f64| function((f64::from(i) + t) * length);
            let (low, middle, high) = (at(0.5 - node), at(0.5), at(0.5 + node));
            let bend = (low - 2.0 * middle + high) * (8.0 / 3.0);
            let slope = (high - low) / (2.0 * node);
            [
                ((middle - slope / 2.0 + bend / 4.0) * unit + 0.5).round() as i64,
                ((slope - bend) * unit).round() as i64,
                (bend * unit).round() as i64,
            ]
        };
        Curve {
            place,
            coefficients: (0..1 << n).map(segment).collect(),
        }
    }

    /// The value at an argument: the number of the segment, and below it the bits of the place.
    pub fn value(&self, argument: u64) -> i64 {
        let [c0, c1, c2] = self.coefficients[(argument >> self.place) as usize];
        let x = (argument & ((1 << self.place) - 1)) as i64;
        let slope = c1 + ((c2 * x) >> self.place);
        c0 + ((slope * x) >> self.place)
    }
}
