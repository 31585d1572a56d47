//! Line of sight and normal at a pixel.
use crate::kernel::*;
use crate::unit::delay::WordDelay;
use crate::unit::logarithm::Logarithm;
use crate::unit::scalar_product::ScalarProduct;
use crate::unit::vector_normaliser::VectorNormaliser;
/// What all lights share: place on the screen, line of sight and normal in full words, and their products.
///
/// | port | direction | format | clocks after the pixel |
/// |---|---|---|---|
/// | `clock` | in | rising edge | |
/// | `x`, `y` | in | 12 bits | 0 |
/// | `nx`, `ny`, `nz` | in | 16 bits, two's complement | 0 |
/// | `size_x`, `size_y`, `perspective`, `view_shift`, `distance` | in | 13, 13, 1, 4, 17 bits | held |
/// | `place_x`, `place_y` | out | 13 bits, two's complement | 1 |
/// | `ray_x`, `ray_y`, `ray_z` | out | 18 bits, two's complement | 5 |
/// | `normal_x`, `normal_y`, `normal_z` | out | 18 bits, two's complement | 5 |
/// | `across`, `square`, `turned` | out | 25, 25 bits, two's complement, 1 bit | 7 |
/// | `normal_log`, `ray_log` | out | 28 bits, two's complement | 15 |
/// | `ray_places` | out | 6 bits | 15 |
///
/// Section 8.2 of the architecture.
pub struct Sight {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Column.
    pub x: Signal<In, Word<12>>,
    /// Line.
    pub y: Signal<In, Word<12>>,
    /// Component x of the normal.
    pub nx: Signal<In, Int<16>>,
    /// Component y of the normal.
    pub ny: Signal<In, Int<16>>,
    /// Component z of the normal.
    pub nz: Signal<In, Int<16>>,
    /// Columns of the picture.
    pub size_x: Signal<In, Word<13>>,
    /// Lines of the picture.
    pub size_y: Signal<In, Word<13>>,
    /// Lines of sight meet in the eye.
    pub perspective: Signal<In, Bit>,
    /// Places that coordinates are shifted to the right.
    pub view_shift: Signal<In, Word<4>>,
    /// Distance of the eye.
    pub distance: Signal<In, Word<17>>,
    /// Half pixels from the middle.
    pub place_x: Signal<Out, Int<13>>,
    /// Half pixels from the middle.
    pub place_y: Signal<Out, Int<13>>,
    /// Line of sight.
    pub ray_x: Signal<Out, Int<18>>,
    /// Line of sight.
    pub ray_y: Signal<Out, Int<18>>,
    /// Line of sight.
    pub ray_z: Signal<Out, Int<18>>,
    /// Normal.
    pub normal_x: Signal<Out, Int<18>>,
    /// Normal.
    pub normal_y: Signal<Out, Int<18>>,
    /// Normal.
    pub normal_z: Signal<Out, Int<18>>,
    /// Normal times line of sight.
    pub across: Signal<Out, Int<25>>,
    /// Square of the normal.
    pub square: Signal<Out, Int<25>>,
    /// The normal looks away from the viewer.
    pub turned: Signal<Out, Bit>,
    /// Logarithm of the square of the normal.
    pub normal_log: Signal<Out, Int<28>>,
    /// Logarithm of the square of the line of sight.
    pub ray_log: Signal<Out, Int<28>>,
    /// Places that the line of sight was shifted.
    pub ray_places: Signal<Out, Word<6>>,
    wide_at_x: Signal<Local, Word<13>>,
    wide_at_y: Signal<Local, Word<13>>,
    twice_x: Signal<Local, Word<13>>,
    twice_y: Signal<Local, Word<13>>,
    kept_place_x: DFF<Word<13>>,
    kept_place_y: DFF<Word<13>>,
    signed_place_x: Signal<Local, Int<13>>,
    long_place_x: Signal<Local, Int<33>>,
    long_word_x: Signal<Local, Word<33>>,
    raised_x: Signal<Local, Word<33>>,
    lowered_x: Signal<Local, Word<33>>,
    kept_ray_x: DFF<Word<18>>,
    signed_place_y: Signal<Local, Int<13>>,
    long_place_y: Signal<Local, Int<33>>,
    long_word_y: Signal<Local, Word<33>>,
    raised_y: Signal<Local, Word<33>>,
    lowered_y: Signal<Local, Word<33>>,
    kept_ray_y: DFF<Word<18>>,
    wide_distance: Signal<Local, Word<18>>,
    ray_normaliser: VectorNormaliser<18>,
    normal_normaliser: VectorNormaliser<16>,
    places_delay: WordDelay<Word<6>>,
    kept_full_ray_x: DFF<Int<18>>,
    normal_delay_x: WordDelay<Int<16>>,
    full_normal_x: Signal<Local, Int<18>>,
    kept_full_ray_y: DFF<Int<18>>,
    normal_delay_y: WordDelay<Int<16>>,
    full_normal_y: Signal<Local, Int<18>>,
    kept_full_ray_z: DFF<Int<18>>,
    normal_delay_z: WordDelay<Int<16>>,
    full_normal_z: Signal<Local, Int<18>>,
    normal_square: ScalarProduct,
    ray_square: ScalarProduct,
    both: ScalarProduct,
    normal_word: Signal<Local, Word<38>>,
    ray_word: Signal<Local, Word<38>>,
    cut_square: Signal<Local, Word<23>>,
    wide_square: Signal<Local, Word<25>>,
    normal_logarithm: Logarithm<32>,
    ray_logarithm: Logarithm<36>,
    one: Constant<Word<8>>,
    five: Constant<Word<8>>,
    no_ray: Constant<Word<18>>,
    square_at: Constant<Word<8>>,
    across_at: Constant<Word<8>>,
    none: Constant<Int<38>>,
    _asleep: bool,
}

block! {
    [] Sight []
    inputs { clock, x, y, nx, ny, nz, size_x, size_y, perspective, view_shift, distance }
    parts { place_x, place_y, ray_x, ray_y, ray_z, normal_x, normal_y, normal_z, across, square, turned, normal_log, ray_log, ray_places, wide_at_x, wide_at_y, twice_x, twice_y, kept_place_x, kept_place_y, signed_place_x, long_place_x, long_word_x, raised_x, lowered_x, kept_ray_x, signed_place_y, long_place_y, long_word_y, raised_y, lowered_y, kept_ray_y, wide_distance, ray_normaliser, normal_normaliser, places_delay, kept_full_ray_x, normal_delay_x, full_normal_x, kept_full_ray_y, normal_delay_y, full_normal_y, kept_full_ray_z, normal_delay_z, full_normal_z, normal_square, ray_square, both, normal_word, ray_word, cut_square, wide_square, normal_logarithm, ray_logarithm, one, five, no_ray, square_at, across_at, none }
    data {  }
}

impl Sight {
    pub(in crate::machine) fn new() -> Self {
        fields! {
            [clock, x, y, nx, ny, nz, size_x, size_y, perspective, view_shift, distance, place_x, place_y, ray_x, ray_y, ray_z, normal_x, normal_y, normal_z, across, square, turned, normal_log, ray_log, ray_places, wide_at_x, wide_at_y, twice_x, twice_y, kept_place_x, kept_place_y, signed_place_x, long_place_x, long_word_x, raised_x, lowered_x, kept_ray_x, signed_place_y, long_place_y, long_word_y, raised_y, lowered_y, kept_ray_y, wide_distance, kept_full_ray_x, full_normal_x, kept_full_ray_y, full_normal_y, kept_full_ray_z, full_normal_z, normal_square, ray_square, both, normal_word, ray_word, cut_square, wide_square]
            ray_normaliser: VectorNormaliser::new(),
            normal_normaliser: VectorNormaliser::new(),
            places_delay: WordDelay::new(11),
            normal_delay_x: WordDelay::new(3),
            normal_delay_y: WordDelay::new(3),
            normal_delay_z: WordDelay::new(3),
            normal_logarithm: Logarithm::new(),
            ray_logarithm: Logarithm::new(),
            one: constant(1),
            five: constant(5),
            no_ray: constant(0),
            square_at: constant(9),
            across_at: constant(10),
            none: signed_constant(0),
        }
    }
}

impl Logic for Sight {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("sight");
        clock!(
            self,
            clock,
            kept_place_x,
            kept_place_y,
            kept_ray_x,
            kept_ray_y,
            ray_normaliser,
            normal_normaliser,
            places_delay,
            kept_full_ray_x,
            normal_delay_x,
            kept_full_ray_y,
            normal_delay_y,
            kept_full_ray_z,
            normal_delay_z,
            normal_square,
            ray_square,
            both,
            normal_logarithm,
            ray_logarithm
        );
        self.wide_at_x.next = bit_cast::<13, 12>(self.x.val());
        self.twice_x.next = self.wide_at_x.val() << self.one.val();
        self.kept_place_x.d.next = self.twice_x.val() - self.size_x.val();
        self.signed_place_x.next = signed_cast(self.kept_place_x.q.val());
        self.place_x.next = self.signed_place_x.val();
        self.long_place_x.next = signed_bit_cast::<33, 13>(self.signed_place_x.val());
        self.long_word_x.next = unsigned_cast(self.long_place_x.val());
        self.raised_x.next = self.long_word_x.val() << self.five.val();
        self.lowered_x.next = self.raised_x.val() >> self.view_shift.val();
        if self.perspective.val() {
            self.kept_ray_x.d.next = self.lowered_x.val().get_bits::<18>(0);
        } else {
            self.kept_ray_x.d.next = self.no_ray.val();
        }
        self.ray_normaliser.x.next = signed_cast(self.kept_ray_x.q.val());

        self.wide_at_y.next = bit_cast::<13, 12>(self.y.val());
        self.twice_y.next = self.wide_at_y.val() << self.one.val();
        self.kept_place_y.d.next = self.twice_y.val() - self.size_y.val();
        self.signed_place_y.next = signed_cast(self.kept_place_y.q.val());
        self.place_y.next = self.signed_place_y.val();
        self.long_place_y.next = signed_bit_cast::<33, 13>(self.signed_place_y.val());
        self.long_word_y.next = unsigned_cast(self.long_place_y.val());
        self.raised_y.next = self.long_word_y.val() << self.five.val();
        self.lowered_y.next = self.raised_y.val() >> self.view_shift.val();
        if self.perspective.val() {
            self.kept_ray_y.d.next = self.lowered_y.val().get_bits::<18>(0);
        } else {
            self.kept_ray_y.d.next = self.no_ray.val();
        }
        self.ray_normaliser.y.next = signed_cast(self.kept_ray_y.q.val());

        self.wide_distance.next = bit_cast::<18, 17>(self.distance.val());
        self.ray_normaliser.z.next = signed_cast(self.wide_distance.val());
        self.places_delay.word.next = self.ray_normaliser.places.val();
        self.ray_places.next = self.places_delay.late.val();

        self.kept_full_ray_x.d.next = self.ray_normaliser.shifted_x.val();
        self.ray_x.next = self.kept_full_ray_x.q.val();
        self.normal_delay_x.word.next = self.nx.val();
        self.normal_normaliser.x.next = self.normal_delay_x.late.val();
        self.full_normal_x.next = signed_bit_cast::<18, 16>(self.normal_normaliser.shifted_x.val());
        self.normal_x.next = self.full_normal_x.val();
        self.normal_square.ax.next = self.full_normal_x.val();
        self.normal_square.bx.next = self.full_normal_x.val();
        self.ray_square.ax.next = self.kept_full_ray_x.q.val();
        self.ray_square.bx.next = self.kept_full_ray_x.q.val();
        self.both.ax.next = self.full_normal_x.val();
        self.both.bx.next = self.kept_full_ray_x.q.val();

        self.kept_full_ray_y.d.next = self.ray_normaliser.shifted_y.val();
        self.ray_y.next = self.kept_full_ray_y.q.val();
        self.normal_delay_y.word.next = self.ny.val();
        self.normal_normaliser.y.next = self.normal_delay_y.late.val();
        self.full_normal_y.next = signed_bit_cast::<18, 16>(self.normal_normaliser.shifted_y.val());
        self.normal_y.next = self.full_normal_y.val();
        self.normal_square.ay.next = self.full_normal_y.val();
        self.normal_square.by.next = self.full_normal_y.val();
        self.ray_square.ay.next = self.kept_full_ray_y.q.val();
        self.ray_square.by.next = self.kept_full_ray_y.q.val();
        self.both.ay.next = self.full_normal_y.val();
        self.both.by.next = self.kept_full_ray_y.q.val();

        self.kept_full_ray_z.d.next = self.ray_normaliser.shifted_z.val();
        self.ray_z.next = self.kept_full_ray_z.q.val();
        self.normal_delay_z.word.next = self.nz.val();
        self.normal_normaliser.z.next = self.normal_delay_z.late.val();
        self.full_normal_z.next = signed_bit_cast::<18, 16>(self.normal_normaliser.shifted_z.val());
        self.normal_z.next = self.full_normal_z.val();
        self.normal_square.az.next = self.full_normal_z.val();
        self.normal_square.bz.next = self.full_normal_z.val();
        self.ray_square.az.next = self.kept_full_ray_z.q.val();
        self.ray_square.bz.next = self.kept_full_ray_z.q.val();
        self.both.az.next = self.full_normal_z.val();
        self.both.bz.next = self.kept_full_ray_z.q.val();

        self.normal_word.next = unsigned_cast(self.normal_square.product.val());
        self.ray_word.next = unsigned_cast(self.ray_square.product.val());
        self.cut_square.next = self
            .normal_word
            .val()
            .get_bits::<23>(self.square_at.val().index());
        self.wide_square.next = bit_cast::<25, 23>(self.cut_square.val());
        self.square.next = signed_cast(self.wide_square.val());
        self.across.next = self
            .both
            .product
            .val()
            .get_bits::<25>(self.across_at.val().index());
        self.turned.next = self.both.product.val() > self.none.val();
        self.normal_logarithm.number.next = self.normal_word.val().get_bits::<32>(0);
        self.normal_log.next = self.normal_logarithm.value.val();
        self.ray_logarithm.number.next = self.ray_word.val().get_bits::<36>(0);
        self.ray_log.next = self.ray_logarithm.value.val();
    }
}

clocked!(Sight);
