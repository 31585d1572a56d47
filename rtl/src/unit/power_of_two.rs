//! Powers of two with negative exponents.

use super::delay::WordDelay;
use super::segment_curve::SegmentCurve;
use crate::kernel::*;

/// Gives `2^-loss`, 17 bits after the point, at most `1 - 2^-17`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `loss` | in | 36 bits, 21 of them after the point |
/// | `value` | out | 17 bits |
///
/// The first 17 bits after the point through a curve of 8 segments, then a shift by the octaves. Latency 7.
pub struct PowerOfTwo {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// The negative exponent.
    pub loss: Signal<In, Word<36>>,
    /// The power.
    pub value: Signal<Out, Word<17>>,
    curve: SegmentCurve<3>,
    octaves: Signal<Local, Word<15>>,
    octave_delay: WordDelay<Word<15>>,
    curve_word: Signal<Local, Word<24>>,
    power: Signal<Local, Word<18>>,
    shifted: Signal<Local, Word<18>>,
    kept_shifted: DFF<Word<18>>,
    kept: DFF<Word<17>>,
    segment_at: Constant<Word<8>>,
    place_at: Constant<Word<8>>,
    point: Constant<Word<8>>,
    first_bit: Constant<Word<8>>,
    most: Constant<Word<17>>,
    _asleep: bool,
}

block! {
    [] PowerOfTwo []
    inputs { clock, loss }
    parts { value, curve, octaves, octave_delay, curve_word, power, shifted, kept_shifted, kept, segment_at, place_at, point,
        first_bit, most }
    data { }
}

impl PowerOfTwo {
    /// The unit.
    pub fn new() -> Self {
        fields! {
            [clock, loss, value, octaves, curve_word, power, shifted, kept_shifted, kept]
            curve: SegmentCurve::new(|t| (-t).exp2(), 1.0 / 8.0, 17),
            octave_delay: WordDelay::new(5),
            segment_at: constant(18),
            place_at: constant(4),
            point: constant(21),
            first_bit: constant(17),
            most: constant((1 << 17) - 1),
        }
    }

    /// Clocks from the exponent to the power.
    pub const fn latency() -> usize {
        7
    }
}

impl Default for PowerOfTwo {
    fn default() -> Self {
        Self::new()
    }
}

impl Logic for PowerOfTwo {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("power_of_two");
        clock!(self, clock, curve, octave_delay, kept_shifted, kept);
        self.curve.segment.next = self.loss.val().get_bits::<3>(self.segment_at.val().index());
        self.curve.place.next = self.loss.val().get_bits::<14>(self.place_at.val().index());
        self.octaves.next = self.loss.val().get_bits::<15>(self.point.val().index());
        self.octave_delay.word.next = self.octaves.val();
        self.curve_word.next = unsigned_cast(self.curve.value.val());
        self.power.next = self.curve_word.val().get_bits::<18>(0);
        self.shifted.next = self.power.val() >> self.octave_delay.late.val();
        self.kept_shifted.d.next = self.shifted.val();
        if self
            .kept_shifted
            .q
            .val()
            .get_bit(self.first_bit.val().index())
        {
            self.kept.d.next = self.most.val();
        } else {
            self.kept.d.next = self.kept_shifted.q.val().get_bits::<17>(0);
        }
        self.value.next = self.kept.q.val();
    }
}

clocked!(PowerOfTwo);
