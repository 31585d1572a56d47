//! Diffuse and specular factor of one light.
use super::light_component::LightComponent;
use crate::kernel::*;
use crate::unit::delay::WordDelay;
use crate::unit::logarithm::Logarithm;
use crate::unit::power_of_two::PowerOfTwo;
use crate::unit::scalar_product::ScalarProduct;
use crate::unit::vector_normaliser::VectorNormaliser;
/// Gives the cosine between normal and light and the power of the cosine between mirrored light and viewer, with attenuation; 0 where the light does not reach.
///
/// | port | direction | format | clocks after the pixel |
/// |---|---|---|---|
/// | `clock` | in | rising edge | |
/// | `flags` | in | 16 bits | 0 |
/// | `place_x`, `place_y`, `depth` | in | 13, 13, 32 bits, two's complement | 1 |
/// | `ray_x` .. `normal_z` | in | 18 bits, two's complement | 5 |
/// | `across`, `square`, `turned` | in | 25, 25 bits, two's complement, 1 bit | 7 |
/// | `normal_log`, `ray_log` | in | 28 bits, two's complement | 15 |
/// | `exponent` | in | 8 bits | 19 |
/// | `attenuation` | in | 26 bits | 24 |
/// | `source`, `point`, `shift` | in | 4, 1, 4 bits | held |
/// | `base_x` .. `slope_z` | in | 28 bits, two's complement | held |
/// | `diffuse`, `specular` | out | 17 bits | 32 |
///
/// Section 8.3 of the architecture.
pub struct LightFactors {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Sources that reach the point.
    pub flags: Signal<In, Word<16>>,
    /// Half pixels from the middle.
    pub place_x: Signal<In, Int<13>>,
    /// Half pixels from the middle.
    pub place_y: Signal<In, Int<13>>,
    /// Depth as a fraction.
    pub depth: Signal<In, Int<32>>,
    /// Line of sight.
    pub ray_x: Signal<In, Int<18>>,
    /// Line of sight.
    pub ray_y: Signal<In, Int<18>>,
    /// Line of sight.
    pub ray_z: Signal<In, Int<18>>,
    /// Normal.
    pub normal_x: Signal<In, Int<18>>,
    /// Normal.
    pub normal_y: Signal<In, Int<18>>,
    /// Normal.
    pub normal_z: Signal<In, Int<18>>,
    /// Normal times line of sight.
    pub across: Signal<In, Int<25>>,
    /// Square of the normal.
    pub square: Signal<In, Int<25>>,
    /// The normal looks away from the viewer.
    pub turned: Signal<In, Bit>,
    /// Logarithm of the square of the normal.
    pub normal_log: Signal<In, Int<28>>,
    /// Logarithm of the square of the line of sight.
    pub ray_log: Signal<In, Int<28>>,
    /// Sharpness of the highlight.
    pub exponent: Signal<In, Word<8>>,
    /// Loss by attenuation.
    pub attenuation: Signal<In, Word<26>>,
    /// Flag of the light.
    pub source: Signal<In, Word<4>>,
    /// The light is at a point.
    pub point: Signal<In, Bit>,
    /// Units of a half pixel, as a power of two.
    pub shift: Signal<In, Word<4>>,
    /// Constant part of the vector.
    pub base_x: Signal<In, Int<28>>,
    /// Constant part of the vector.
    pub base_y: Signal<In, Int<28>>,
    /// Constant part of the vector.
    pub base_z: Signal<In, Int<28>>,
    /// Part of the vector that goes with depth.
    pub slope_x: Signal<In, Int<28>>,
    /// Part of the vector that goes with depth.
    pub slope_y: Signal<In, Int<28>>,
    /// Part of the vector that goes with depth.
    pub slope_z: Signal<In, Int<28>>,
    /// Diffuse factor.
    pub diffuse: Signal<Out, Word<17>>,
    /// Specular factor.
    pub specular: Signal<Out, Word<17>>,
    shifted_flags: Signal<Local, Word<16>>,
    reach: WordDelay<Bit>,
    normaliser: VectorNormaliser<30>,
    long_place_x: Signal<Local, Int<30>>,
    long_word_x: Signal<Local, Word<30>>,
    shifted_x: Signal<Local, Word<30>>,
    light_place_x: Signal<Local, Word<30>>,
    long_place_y: Signal<Local, Int<30>>,
    long_word_y: Signal<Local, Word<30>>,
    shifted_y: Signal<Local, Word<30>>,
    light_place_y: Signal<Local, Word<30>>,
    component_x: LightComponent,
    high_x: Signal<Local, Int<18>>,
    full_word_x: Signal<Local, Word<30>>,
    low_x: Signal<Local, Word<12>>,
    wide_low_x: Signal<Local, Word<18>>,
    component_y: LightComponent,
    high_y: Signal<Local, Int<18>>,
    full_word_y: Signal<Local, Word<30>>,
    low_y: Signal<Local, Word<12>>,
    wide_low_y: Signal<Local, Word<18>>,
    component_z: LightComponent,
    high_z: Signal<Local, Int<18>>,
    full_word_z: Signal<Local, Word<30>>,
    low_z: Signal<Local, Word<12>>,
    wide_low_z: Signal<Local, Word<18>>,
    normal_high: ScalarProduct,
    normal_low: ScalarProduct,
    light_square: ScalarProduct,
    ray_light: ScalarProduct,
    low_carry: Signal<Local, Int<26>>,
    wide_carry: Signal<Local, Int<38>>,
    low_word: Signal<Local, Word<38>>,
    low_rest: Signal<Local, Word<12>>,
    kept_exact: DFF<Int<38>>,
    kept_rest: DFF<Bit>,
    kept_turned: DFF<Bit>,
    is_negative: Signal<Local, Bit>,
    is_positive: Signal<Local, Bit>,
    kept_lit: DFF<Bit>,
    along: Signal<Local, Int<25>>,
    opposite: Signal<Local, Int<25>>,
    kept_along: DFF<Int<25>>,
    along_word: Signal<Local, Word<25>>,
    kept_magnitude: DFF<Word<24>>,
    kept_is_along: DFF<Bit>,
    back: Signal<Local, Int<25>>,
    kept_turn: DFF<Doubled<25>>,
    kept_straight: DFF<Doubled<25>>,
    turn: Signal<Local, Int<50>>,
    straight: Signal<Local, Int<50>>,
    kept_difference: DFF<Int<50>>,
    cosine: Signal<Local, Int<30>>,
    is_cosine: Signal<Local, Bit>,
    light_word: Signal<Local, Word<38>>,
    light_logarithm: Logarithm<36>,
    along_logarithm: Logarithm<24>,
    cosine_logarithm: Logarithm<30>,
    wide_normal_log: Signal<Local, Int<32>>,
    wide_ray_log: Signal<Local, Int<32>>,
    wide_light_log: Signal<Local, Int<32>>,
    wide_along_log: Signal<Local, Int<32>>,
    wide_cosine_log: Signal<Local, Int<32>>,
    pair: Signal<Local, Int<32>>,
    normal_ray: Signal<Local, Int<32>>,
    kept_pair: DFF<Int<32>>,
    kept_four: DFF<Int<32>>,
    kept_pair_cut: DFF<Int<32>>,
    kept_four_cut: DFF<Int<32>>,
    twice_along: Signal<Local, Int<32>>,
    twice_cosine: Signal<Local, Int<32>>,
    kept_diffuse: DFF<Int<32>>,
    kept_specular: DFF<Int<32>>,
    kept_diffuse_loss: DFF<Word<32>>,
    kept_specular_loss: DFF<Word<26>>,
    specular_high: Signal<Local, Int<6>>,
    wide_loss: Signal<Local, Word<28>>,
    loss_factor: Signal<Local, Int<28>>,
    wide_exponent: Signal<Local, Word<28>>,
    exponent_factor: Signal<Local, Int<28>>,
    kept_power: DFF<Doubled<28>>,
    power_word: Signal<Local, Word<36>>,
    power_delay: WordDelay<Word<36>>,
    diffuse_delay: WordDelay<Word<32>>,
    wide_attenuation: Signal<Local, Word<36>>,
    wide_diffuse: Signal<Local, Word<36>>,
    kept_diffuse_sum: DFF<Word<36>>,
    kept_specular_sum: DFF<Word<36>>,
    diffuse_power: PowerOfTwo,
    specular_power: PowerOfTwo,
    diffuse_gate: WordDelay<Bit>,
    specular_gate: WordDelay<Bit>,
    gate: Signal<Local, Bit>,
    first: Constant<Word<8>>,
    no_place: Constant<Word<30>>,
    low_bits: Constant<Word<8>>,
    carry_at: Constant<Word<8>>,
    cut_at: Constant<Word<8>>,
    back_at: Constant<Word<8>>,
    cosine_at: Constant<Word<8>>,
    long_sign: Constant<Word<8>>,
    short_sign: Constant<Word<8>>,
    whole_at: Constant<Word<8>>,
    none: Constant<Int<38>>,
    no_rest: Constant<Word<12>>,
    no_along: Constant<Int<25>>,
    no_magnitude: Constant<Word<24>>,
    no_cosine: Constant<Int<30>>,
    pair_cut: Constant<Int<32>>,
    four_cut: Constant<Int<32>>,
    no_loss: Constant<Word<32>>,
    no_short_loss: Constant<Word<26>>,
    no_high: Constant<Int<6>>,
    most: Constant<Word<26>>,
    nothing: Constant<Word<17>>,
    _asleep: bool,
}

block! {
    [] LightFactors []
    inputs { clock, flags, place_x, place_y, depth, ray_x, ray_y, ray_z, normal_x, normal_y, normal_z, across, square, turned, normal_log, ray_log, exponent, attenuation, source, point, shift, base_x, base_y, base_z, slope_x, slope_y, slope_z }
    parts { diffuse, specular, shifted_flags, reach, normaliser, long_place_x, long_word_x, shifted_x, light_place_x, long_place_y, long_word_y, shifted_y, light_place_y, component_x, high_x, full_word_x, low_x, wide_low_x, component_y, high_y, full_word_y, low_y, wide_low_y, component_z, high_z, full_word_z, low_z, wide_low_z, normal_high, normal_low, light_square, ray_light, low_carry, wide_carry, low_word, low_rest, kept_exact, kept_rest, kept_turned, is_negative, is_positive, kept_lit, along, opposite, kept_along, along_word, kept_magnitude, kept_is_along, back, kept_turn, kept_straight, turn, straight, kept_difference, cosine, is_cosine, light_word, light_logarithm, along_logarithm, cosine_logarithm, wide_normal_log, wide_ray_log, wide_light_log, wide_along_log, wide_cosine_log, pair, normal_ray, kept_pair, kept_four, kept_pair_cut, kept_four_cut, twice_along, twice_cosine, kept_diffuse, kept_specular, kept_diffuse_loss, kept_specular_loss, specular_high, wide_loss, loss_factor, wide_exponent, exponent_factor, kept_power, power_word, power_delay, diffuse_delay, wide_attenuation, wide_diffuse, kept_diffuse_sum, kept_specular_sum, diffuse_power, specular_power, diffuse_gate, specular_gate, gate, first, no_place, low_bits, carry_at, cut_at, back_at, cosine_at, long_sign, short_sign, whole_at, none, no_rest, no_along, no_magnitude, no_cosine, pair_cut, four_cut, no_loss, no_short_loss, no_high, most, nothing }
    data {  }
}

impl LightFactors {
    pub(in crate::machine) fn new() -> Self {
        fields! {
            [clock, flags, place_x, place_y, depth, ray_x, ray_y, ray_z, normal_x, normal_y, normal_z, across, square, turned, normal_log, ray_log, exponent, attenuation, source, point, shift, base_x, base_y, base_z, slope_x, slope_y, slope_z, diffuse, specular, shifted_flags, long_place_x, long_word_x, shifted_x, light_place_x, long_place_y, long_word_y, shifted_y, light_place_y, high_x, full_word_x, low_x, wide_low_x, high_y, full_word_y, low_y, wide_low_y, high_z, full_word_z, low_z, wide_low_z, normal_high, normal_low, light_square, ray_light, low_carry, wide_carry, low_word, low_rest, kept_exact, kept_rest, kept_turned, is_negative, is_positive, kept_lit, along, opposite, kept_along, along_word, kept_magnitude, kept_is_along, back, kept_turn, kept_straight, turn, straight, kept_difference, cosine, is_cosine, light_word, wide_normal_log, wide_ray_log, wide_light_log, wide_along_log, wide_cosine_log, pair, normal_ray, kept_pair, kept_four, kept_pair_cut, kept_four_cut, twice_along, twice_cosine, kept_diffuse, kept_specular, kept_diffuse_loss, kept_specular_loss, specular_high, wide_loss, loss_factor, wide_exponent, exponent_factor, kept_power, power_word, wide_attenuation, wide_diffuse, kept_diffuse_sum, kept_specular_sum, gate]
            reach: WordDelay::new(9),
            normaliser: VectorNormaliser::new(),
            component_x: LightComponent::new(),
            component_y: LightComponent::new(),
            component_z: LightComponent::new(),
            light_logarithm: Logarithm::new(),
            along_logarithm: Logarithm::new(),
            cosine_logarithm: Logarithm::new(),
            power_delay: WordDelay::new(4),
            diffuse_delay: WordDelay::new(5),
            diffuse_power: PowerOfTwo::new(),
            specular_power: PowerOfTwo::new(),
            diffuse_gate: WordDelay::new(23),
            specular_gate: WordDelay::new(23),
            first: constant(0),
            no_place: constant(0),
            low_bits: constant(12),
            carry_at: constant(12),
            cut_at: constant(10),
            back_at: constant(12),
            cosine_at: constant(20),
            long_sign: constant(37),
            short_sign: constant(31),
            whole_at: constant(26),
            none: signed_constant(0),
            no_rest: constant(0),
            no_along: signed_constant(0),
            no_magnitude: constant(0),
            no_cosine: signed_constant(0),
            pair_cut: signed_constant(20 << 20),
            four_cut: signed_constant(82 << 20),
            no_loss: constant(0),
            no_short_loss: constant(0),
            no_high: signed_constant(0),
            most: constant((1 << 26) - 1),
            nothing: constant(0),
        }
    }
}

impl Logic for LightFactors {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("light_factors");
        clock!(
            self,
            clock,
            reach,
            normaliser,
            component_x,
            component_y,
            component_z,
            normal_high,
            normal_low,
            light_square,
            ray_light,
            kept_exact,
            kept_rest,
            kept_turned,
            kept_lit,
            kept_along,
            kept_magnitude,
            kept_is_along,
            kept_turn,
            kept_straight,
            kept_difference,
            light_logarithm,
            along_logarithm,
            cosine_logarithm,
            kept_pair,
            kept_four,
            kept_pair_cut,
            kept_four_cut,
            kept_diffuse,
            kept_specular,
            kept_diffuse_loss,
            kept_specular_loss,
            kept_power,
            power_delay,
            diffuse_delay,
            kept_diffuse_sum,
            kept_specular_sum,
            diffuse_power,
            specular_power,
            diffuse_gate,
            specular_gate
        );
        self.shifted_flags.next = self.flags.val() >> self.source.val();
        self.reach.word.next = self.shifted_flags.val().get_bit(self.first.val().index());

        self.long_place_x.next = signed_bit_cast::<30, 13>(self.place_x.val());
        self.long_word_x.next = unsigned_cast(self.long_place_x.val());
        self.shifted_x.next = self.long_word_x.val() << self.shift.val();
        if self.point.val() {
            self.light_place_x.next = self.shifted_x.val();
        } else {
            self.light_place_x.next = self.no_place.val();
        }
        self.component_x.place.next = signed_cast(self.light_place_x.val());

        self.long_place_y.next = signed_bit_cast::<30, 13>(self.place_y.val());
        self.long_word_y.next = unsigned_cast(self.long_place_y.val());
        self.shifted_y.next = self.long_word_y.val() << self.shift.val();
        if self.point.val() {
            self.light_place_y.next = self.shifted_y.val();
        } else {
            self.light_place_y.next = self.no_place.val();
        }
        self.component_y.place.next = signed_cast(self.light_place_y.val());
        self.component_z.place.next = signed_cast(self.no_place.val());

        self.component_x.depth.next = self.depth.val();
        self.component_x.base.next = self.base_x.val();
        self.component_x.slope.next = self.slope_x.val();
        self.normaliser.x.next = self.component_x.result.val();
        self.high_x.next = self
            .normaliser
            .shifted_x
            .val()
            .get_bits::<18>(self.low_bits.val().index());
        self.full_word_x.next = unsigned_cast(self.normaliser.shifted_x.val());
        self.low_x.next = self.full_word_x.val().get_bits::<12>(0);
        self.wide_low_x.next = bit_cast::<18, 12>(self.low_x.val());
        self.normal_high.ax.next = self.normal_x.val();
        self.normal_high.bx.next = self.high_x.val();
        self.normal_low.ax.next = self.normal_x.val();
        self.normal_low.bx.next = signed_cast(self.wide_low_x.val());
        self.light_square.ax.next = self.high_x.val();
        self.light_square.bx.next = self.high_x.val();
        self.ray_light.ax.next = self.ray_x.val();
        self.ray_light.bx.next = self.high_x.val();

        self.component_y.depth.next = self.depth.val();
        self.component_y.base.next = self.base_y.val();
        self.component_y.slope.next = self.slope_y.val();
        self.normaliser.y.next = self.component_y.result.val();
        self.high_y.next = self
            .normaliser
            .shifted_y
            .val()
            .get_bits::<18>(self.low_bits.val().index());
        self.full_word_y.next = unsigned_cast(self.normaliser.shifted_y.val());
        self.low_y.next = self.full_word_y.val().get_bits::<12>(0);
        self.wide_low_y.next = bit_cast::<18, 12>(self.low_y.val());
        self.normal_high.ay.next = self.normal_y.val();
        self.normal_high.by.next = self.high_y.val();
        self.normal_low.ay.next = self.normal_y.val();
        self.normal_low.by.next = signed_cast(self.wide_low_y.val());
        self.light_square.ay.next = self.high_y.val();
        self.light_square.by.next = self.high_y.val();
        self.ray_light.ay.next = self.ray_y.val();
        self.ray_light.by.next = self.high_y.val();

        self.component_z.depth.next = self.depth.val();
        self.component_z.base.next = self.base_z.val();
        self.component_z.slope.next = self.slope_z.val();
        self.normaliser.z.next = self.component_z.result.val();
        self.high_z.next = self
            .normaliser
            .shifted_z
            .val()
            .get_bits::<18>(self.low_bits.val().index());
        self.full_word_z.next = unsigned_cast(self.normaliser.shifted_z.val());
        self.low_z.next = self.full_word_z.val().get_bits::<12>(0);
        self.wide_low_z.next = bit_cast::<18, 12>(self.low_z.val());
        self.normal_high.az.next = self.normal_z.val();
        self.normal_high.bz.next = self.high_z.val();
        self.normal_low.az.next = self.normal_z.val();
        self.normal_low.bz.next = signed_cast(self.wide_low_z.val());
        self.light_square.az.next = self.high_z.val();
        self.light_square.bz.next = self.high_z.val();
        self.ray_light.az.next = self.ray_z.val();
        self.ray_light.bz.next = self.high_z.val();

        self.low_carry.next = self
            .normal_low
            .product
            .val()
            .get_bits::<26>(self.carry_at.val().index());
        self.wide_carry.next = signed_bit_cast::<38, 26>(self.low_carry.val());
        self.low_word.next = unsigned_cast(self.normal_low.product.val());
        self.low_rest.next = self.low_word.val().get_bits::<12>(0);
        self.kept_exact.d.next = self.normal_high.product.val() + self.wide_carry.val();
        self.kept_rest.d.next = self.low_rest.val() != self.no_rest.val();
        self.kept_turned.d.next = self.turned.val();
        self.is_negative.next = self
            .kept_exact
            .q
            .val()
            .get_bit(self.long_sign.val().index());
        self.is_positive.next = (self.kept_exact.q.val() > self.none.val())
            | ((self.kept_exact.q.val() == self.none.val()) & self.kept_rest.q.val());
        if self.kept_turned.q.val() {
            self.kept_lit.d.next = self.is_negative.val();
        } else {
            self.kept_lit.d.next = self.is_positive.val();
        }
        self.along.next = self
            .normal_high
            .product
            .val()
            .get_bits::<25>(self.cut_at.val().index());
        self.opposite.next = -self.along.val();
        if self.turned.val() {
            self.kept_along.d.next = self.opposite.val();
        } else {
            self.kept_along.d.next = self.along.val();
        }
        self.along_word.next = unsigned_cast(self.kept_along.q.val());
        self.kept_magnitude.d.next = self.along_word.val().get_bits::<24>(0);
        self.kept_is_along.d.next = self.kept_along.q.val() > self.no_along.val();
        self.along_logarithm.number.next = self.kept_magnitude.q.val();
        self.back.next = self
            .ray_light
            .product
            .val()
            .get_bits::<25>(self.back_at.val().index());
        self.kept_turn.d.next = self.along.val() * self.across.val();
        self.kept_straight.d.next = self.square.val() * self.back.val();
        self.turn.next = self.kept_turn.q.val().get_bits::<50>(0);
        self.straight.next = self.kept_straight.q.val().get_bits::<50>(0);
        self.kept_difference.d.next = self.straight.val() - self.turn.val();
        self.cosine.next = self
            .kept_difference
            .q
            .val()
            .get_bits::<30>(self.cosine_at.val().index());
        self.is_cosine.next = self.cosine.val() > self.no_cosine.val();
        self.cosine_logarithm.number.next = unsigned_cast(self.cosine.val());
        self.gate.next = self.kept_lit.q.val() & self.reach.late.val();
        self.diffuse_gate.word.next = self.gate.val() & self.kept_is_along.q.val();
        self.specular_gate.word.next = self.gate.val() & self.is_cosine.val();
        self.light_word.next = unsigned_cast(self.light_square.product.val());
        self.light_logarithm.number.next = self.light_word.val().get_bits::<36>(0);
        self.wide_normal_log.next = signed_bit_cast::<32, 28>(self.normal_log.val());
        self.wide_ray_log.next = signed_bit_cast::<32, 28>(self.ray_log.val());
        self.wide_light_log.next = signed_bit_cast::<32, 28>(self.light_logarithm.value.val());
        self.wide_along_log.next = signed_bit_cast::<32, 28>(self.along_logarithm.value.val());
        self.wide_cosine_log.next = signed_bit_cast::<32, 28>(self.cosine_logarithm.value.val());
        self.pair.next = self.wide_normal_log.val() + self.wide_light_log.val();
        self.normal_ray.next = self.wide_normal_log.val() + self.wide_ray_log.val();
        self.kept_pair.d.next = self.pair.val();
        self.kept_four.d.next = self.pair.val() + self.normal_ray.val();
        self.kept_pair_cut.d.next = self.kept_pair.q.val() - self.pair_cut.val();
        self.kept_four_cut.d.next = self.kept_four.q.val() - self.four_cut.val();
        self.twice_along.next = self.wide_along_log.val() + self.wide_along_log.val();
        self.twice_cosine.next = self.wide_cosine_log.val() + self.wide_cosine_log.val();
        self.kept_diffuse.d.next = self.kept_pair_cut.q.val() - self.twice_along.val();
        self.kept_specular.d.next = self.kept_four_cut.q.val() - self.twice_cosine.val();
        if self
            .kept_diffuse
            .q
            .val()
            .get_bit(self.short_sign.val().index())
        {
            self.kept_diffuse_loss.d.next = self.no_loss.val();
        } else {
            self.kept_diffuse_loss.d.next = unsigned_cast(self.kept_diffuse.q.val());
        }
        self.specular_high.next = self
            .kept_specular
            .q
            .val()
            .get_bits::<6>(self.whole_at.val().index());
        if self
            .kept_specular
            .q
            .val()
            .get_bit(self.short_sign.val().index())
        {
            self.kept_specular_loss.d.next = self.no_short_loss.val();
        } else {
            if self.specular_high.val() == self.no_high.val() {
                self.kept_specular_loss.d.next =
                    unsigned_cast(self.kept_specular.q.val().get_bits::<26>(0));
            } else {
                self.kept_specular_loss.d.next = self.most.val();
            }
        }
        self.wide_loss.next = bit_cast::<28, 26>(self.kept_specular_loss.q.val());
        self.loss_factor.next = signed_cast(self.wide_loss.val());
        self.wide_exponent.next = bit_cast::<28, 8>(self.exponent.val());
        self.exponent_factor.next = signed_cast(self.wide_exponent.val());
        self.kept_power.d.next = self.loss_factor.val() * self.exponent_factor.val();
        self.power_word.next = unsigned_cast(self.kept_power.q.val().get_bits::<36>(0));
        self.power_delay.word.next = self.power_word.val();
        self.diffuse_delay.word.next = self.kept_diffuse_loss.q.val();
        self.wide_attenuation.next = bit_cast::<36, 26>(self.attenuation.val());
        self.wide_diffuse.next = bit_cast::<36, 32>(self.diffuse_delay.late.val());
        self.kept_diffuse_sum.d.next = self.wide_diffuse.val() + self.wide_attenuation.val();
        self.kept_specular_sum.d.next = self.power_delay.late.val() + self.wide_attenuation.val();
        self.diffuse_power.loss.next = self.kept_diffuse_sum.q.val();
        self.specular_power.loss.next = self.kept_specular_sum.q.val();
        if self.diffuse_gate.late.val() {
            self.diffuse.next = self.diffuse_power.value.val();
        } else {
            self.diffuse.next = self.nothing.val();
        }
        if self.specular_gate.late.val() {
            self.specular.next = self.specular_power.value.val();
        } else {
            self.specular.next = self.nothing.val();
        }
    }
}

clocked!(LightFactors);
