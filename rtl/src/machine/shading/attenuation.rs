//! Attenuation with the distance from the viewer.
use crate::kernel::*;
use crate::unit::delay::WordDelay;
use crate::unit::logarithm::Logarithm;
use crate::unit::segment_curve::SegmentCurve;
/// Gives the loss `log2(1 + d / k)`, 21 bits after the point, at most 32 less one unit; 0 if the attenuation is off.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `is_on` | in | held |
/// | `offset` | in | 30 bits, held |
/// | `far` | in | 32 bits, what is left of the way to the far end |
/// | `ray_log` | in | 28 bits, 14 clocks after `far` |
/// | `ray_places` | in | 6 bits, with `ray_log` |
/// | `loss` | out | 26 bits, 23 clocks after `far` |
///
/// With `e = log2(d / k)` the loss is `max(e, 0) + log2(1 + 2^-|e|)`.
pub struct Attenuation {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// The attenuation is on.
    pub is_on: Signal<In, Bit>,
    /// `log2(unit / k)`.
    pub offset: Signal<In, Int<30>>,
    /// What is left of the way to the far end.
    pub far: Signal<In, Word<32>>,
    /// Logarithm of the square of the line of sight.
    pub ray_log: Signal<In, Int<28>>,
    /// Places that the line of sight was shifted.
    pub ray_places: Signal<In, Word<6>>,
    /// The loss.
    pub loss: Signal<Out, Word<26>>,
    logarithm: Logarithm<32>,
    far_delay: WordDelay<Int<28>>,
    wide_ray: Signal<Local, Int<32>>,
    wide_far: Signal<Local, Int<32>>,
    twice_far: Signal<Local, Int<32>>,
    cut_offset: Signal<Local, Int<29>>,
    wide_offset: Signal<Local, Int<32>>,
    wide_places: Signal<Local, Word<32>>,
    shifted_places: Signal<Local, Word<32>>,
    places_part: Signal<Local, Int<32>>,
    kept_near: DFF<Int<32>>,
    kept_far: DFF<Int<32>>,
    kept_e: DFF<Int<32>>,
    opposite: Signal<Local, Int<32>>,
    magnitude: Signal<Local, Int<32>>,
    kept_magnitude: DFF<Word<32>>,
    beyond: Signal<Local, Word<7>>,
    curve: SegmentCurve<6>,
    is_beyond: WordDelay<Bit>,
    e_delay: WordDelay<Int<32>>,
    fall: Signal<Local, Word<24>>,
    wide_fall: Signal<Local, Word<32>>,
    shifted_fall: Signal<Local, Word<32>>,
    fall_part: Signal<Local, Int<32>>,
    rise: Signal<Local, Int<32>>,
    sum: Signal<Local, Int<32>>,
    high_bits: Signal<Local, Int<6>>,
    kept_loss: DFF<Word<26>>,
    sign: Constant<Word<8>>,
    one: Constant<Word<8>>,
    point: Constant<Word<8>>,
    three: Constant<Word<8>>,
    beyond_at: Constant<Word<8>>,
    segment_at: Constant<Word<8>>,
    place_at: Constant<Word<8>>,
    whole_at: Constant<Word<8>>,
    no_bits: Constant<Word<7>>,
    no_high: Constant<Int<6>>,
    zero: Constant<Int<32>>,
    nothing: Constant<Word<26>>,
    most: Constant<Word<26>>,
    _asleep: bool,
}

block! {
    [] Attenuation []
    inputs { clock, is_on, offset, far, ray_log, ray_places }
    parts { loss, logarithm, far_delay, wide_ray, wide_far, twice_far, cut_offset, wide_offset, wide_places, shifted_places, places_part, kept_near, kept_far, kept_e, opposite, magnitude, kept_magnitude, beyond, curve, is_beyond, e_delay, fall, wide_fall, shifted_fall, fall_part, rise, sum, high_bits, kept_loss, sign, one, point, three, beyond_at, segment_at, place_at, whole_at, no_bits, no_high, zero, nothing, most }
    data {  }
}

impl Attenuation {
    pub(in crate::machine) fn new() -> Self {
        fields! {
            [clock, is_on, offset, far, ray_log, ray_places, loss, wide_ray, wide_far, twice_far, cut_offset, wide_offset, wide_places, shifted_places, places_part, kept_near, kept_far, kept_e, opposite, magnitude, kept_magnitude, beyond, fall, wide_fall, shifted_fall, fall_part, rise, sum, high_bits, kept_loss]
            logarithm: Logarithm::new(),
            far_delay: WordDelay::new(6),
            curve: SegmentCurve::new(|t| (1.0 + (-t).exp2()).log2(), 0.25, 18),
            is_beyond: WordDelay::new(5),
            e_delay: WordDelay::new(6),
            sign: constant(31),
            one: constant(1),
            point: constant(21),
            three: constant(3),
            beyond_at: constant(25),
            segment_at: constant(19),
            place_at: constant(5),
            whole_at: constant(26),
            no_bits: constant(0),
            no_high: signed_constant(0),
            zero: signed_constant(0),
            nothing: constant(0),
            most: constant((1 << 26) - 1),
        }
    }
}

impl Logic for Attenuation {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("attenuation");
        clock!(
            self,
            clock,
            logarithm,
            far_delay,
            kept_near,
            kept_far,
            kept_e,
            kept_magnitude,
            curve,
            is_beyond,
            e_delay,
            kept_loss
        );
        self.logarithm.number.next = self.far.val();
        self.far_delay.word.next = self.logarithm.value.val();
        self.wide_ray.next = signed_bit_cast::<32, 28>(self.ray_log.val());
        self.wide_far.next = signed_bit_cast::<32, 28>(self.far_delay.late.val());
        self.twice_far.next = self.wide_far.val() + self.wide_far.val();
        self.cut_offset.next = self.offset.val().get_bits::<29>(self.one.val().index());
        self.wide_offset.next = signed_bit_cast::<32, 29>(self.cut_offset.val());
        self.wide_places.next = bit_cast::<32, 6>(self.ray_places.val());
        self.shifted_places.next = self.wide_places.val() << self.point.val();
        self.places_part.next = signed_cast(self.shifted_places.val());
        self.kept_near.d.next = self.wide_ray.val() - self.places_part.val();
        self.kept_far.d.next = self.wide_offset.val() - self.twice_far.val();
        self.kept_e.d.next = self.kept_near.q.val() + self.kept_far.q.val();
        self.opposite.next = -self.kept_e.q.val();
        if self.kept_e.q.val().get_bit(self.sign.val().index()) {
            self.magnitude.next = self.opposite.val();
        } else {
            self.magnitude.next = self.kept_e.q.val();
        }
        self.kept_magnitude.d.next = unsigned_cast(self.magnitude.val());
        self.beyond.next = self
            .kept_magnitude
            .q
            .val()
            .get_bits::<7>(self.beyond_at.val().index());
        self.is_beyond.word.next = self.beyond.val() != self.no_bits.val();
        self.curve.segment.next = self
            .kept_magnitude
            .q
            .val()
            .get_bits::<6>(self.segment_at.val().index());
        self.curve.place.next = self
            .kept_magnitude
            .q
            .val()
            .get_bits::<14>(self.place_at.val().index());
        self.e_delay.word.next = self.kept_e.q.val();
        self.fall.next = unsigned_cast(self.curve.value.val());
        self.wide_fall.next = bit_cast::<32, 24>(self.fall.val());
        self.shifted_fall.next = self.wide_fall.val() << self.three.val();
        if self.is_beyond.late.val() {
            self.fall_part.next = self.zero.val();
        } else {
            self.fall_part.next = signed_cast(self.shifted_fall.val());
        }
        if self.e_delay.late.val().get_bit(self.sign.val().index()) {
            self.rise.next = self.zero.val();
        } else {
            self.rise.next = self.e_delay.late.val();
        }
        self.sum.next = self.fall_part.val() + self.rise.val();
        self.high_bits.next = self.sum.val().get_bits::<6>(self.whole_at.val().index());
        if !self.is_on.val() {
            self.kept_loss.d.next = self.nothing.val();
        } else {
            if self.high_bits.val() == self.no_high.val() {
                self.kept_loss.d.next = unsigned_cast(self.sum.val().get_bits::<26>(0));
            } else {
                self.kept_loss.d.next = self.most.val();
            }
        }
        self.loss.next = self.kept_loss.q.val();
    }
}

clocked!(Attenuation);
