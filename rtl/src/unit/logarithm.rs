//! Logarithm to base 2.

use super::delay::WordDelay;
use super::leading_one::LeadingOne;
use super::segment_curve::SegmentCurve;
use crate::kernel::*;

/// Gives `log2(number)`, 20 bits after the point; 0 has none.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `number` | in | `F` bits, 20 at least |
/// | `value` | out | 28 bits, two's complement |
///
/// The octave by shifting to the leading one, the 19 bits behind it through a curve of 32 segments. Latency 8.
pub struct Logarithm<const F: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// The number.
    pub number: Signal<In, Word<F>>,
    /// Its logarithm.
    pub value: Signal<Out, Int<28>>,
    leading: LeadingOne<F>,
    curve: SegmentCurve<5>,
    octave: Signal<Local, Word<6>>,
    wide_octave: Signal<Local, Word<28>>,
    whole: Signal<Local, Word<28>>,
    octave_delay: WordDelay<Word<6>>,
    part: Signal<Local, Int<28>>,
    sum: Signal<Local, Int<28>>,
    kept: DFF<Int<28>>,
    last_octave: Constant<Word<6>>,
    point: Constant<Word<8>>,
    segment_at: Constant<Word<8>>,
    place_at: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [const F: usize] Logarithm [F]
    inputs { clock, number }
    parts { value, leading, curve, octave, wide_octave, whole, octave_delay, part, sum, kept, last_octave, point, segment_at,
        place_at }
    data { }
}

impl<const F: usize> Logarithm<F> {
    /// A unit for numbers of `F` bits.
    ///
    /// # Panics
    ///
    /// When there are fewer than 20.
    pub fn new() -> Self {
        assert!(
            F >= 20,
            "a number has its leading one and 19 bits behind it"
        );
        fields! {
            [clock, number, value, octave, wide_octave, whole, part, sum, kept]
            leading: LeadingOne::new(),
            curve: SegmentCurve::new(|t| (1.0 + t).log2(), 1.0 / 32.0, 20),
            octave_delay: WordDelay::new(5),
            last_octave: constant(F as u64 - 1),
            point: constant(20),
            segment_at: constant(F as u64 - 6),
            place_at: constant(F as u64 - 20),
        }
    }

    /// Clocks from the number to its logarithm.
    pub const fn latency() -> usize {
        8
    }
}

impl<const F: usize> Default for Logarithm<F> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const F: usize> Logic for Logarithm<F> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("logarithm");
        clock!(self, clock, leading, curve, octave_delay, kept);
        self.leading.number.next = self.number.val();
        self.curve.segment.next = self
            .leading
            .shifted
            .val()
            .get_bits::<5>(self.segment_at.val().index());
        self.curve.place.next = self
            .leading
            .shifted
            .val()
            .get_bits::<14>(self.place_at.val().index());
        self.octave.next = self.last_octave.val() - self.leading.places.val();
        self.octave_delay.word.next = self.octave.val();
        self.wide_octave.next = bit_cast::<28, 6>(self.octave_delay.late.val());
        self.whole.next = self.wide_octave.val() << self.point.val();
        self.part.next = signed_bit_cast::<28, 24>(self.curve.value.val());
        self.sum.next = signed_cast(self.whole.val());
        self.kept.d.next = self.sum.val() + self.part.val();
        self.value.next = self.kept.q.val();
    }
}

clocked!(Logarithm<const F: usize>);
