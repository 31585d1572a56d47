//! Words of one light.
use crate::kernel::*;
/// Keeps the ten words of one light, from address `16 (light + 1)` on. A word is written at the clock edge and holds until written again.
///
/// All words are zero at power-up: a light that adds nothing.
pub struct LightStore {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// This clock carries a word.
    pub load_valid: Signal<In, Bit>,
    /// Its address.
    pub load_address: Signal<In, Word<16>>,
    /// Its low bits.
    pub load_data: Signal<In, Word<28>>,
    /// Flag of the light.
    pub source: Signal<Out, Word<4>>,
    /// The light is at a point.
    pub point: Signal<Out, Bit>,
    /// Units of a half pixel, as a power of two.
    pub shift: Signal<Out, Word<4>>,
    /// Part of the vector to the light.
    pub base_x: Signal<Out, Int<28>>,
    /// Part of the vector to the light.
    pub base_y: Signal<Out, Int<28>>,
    /// Part of the vector to the light.
    pub base_z: Signal<Out, Int<28>>,
    /// Part of the vector to the light.
    pub slope_x: Signal<Out, Int<28>>,
    /// Part of the vector to the light.
    pub slope_y: Signal<Out, Int<28>>,
    /// Part of the vector to the light.
    pub slope_z: Signal<Out, Int<28>>,
    /// Colour of the light.
    pub colour_r: Signal<Out, Word<17>>,
    /// Colour of the light.
    pub colour_g: Signal<Out, Word<17>>,
    /// Colour of the light.
    pub colour_b: Signal<Out, Word<17>>,
    kept_source: DFF<Word<4>>,
    kept_point: DFF<Bit>,
    kept_shift: DFF<Word<4>>,
    kept_base_x: DFF<Int<28>>,
    kept_base_y: DFF<Int<28>>,
    kept_base_z: DFF<Int<28>>,
    kept_slope_x: DFF<Int<28>>,
    kept_slope_y: DFF<Int<28>>,
    kept_slope_z: DFF<Int<28>>,
    kept_colour_r: DFF<Word<17>>,
    kept_colour_g: DFF<Word<17>>,
    kept_colour_b: DFF<Word<17>>,
    at: Vec<Constant<Word<16>>>,
    bit_point: Constant<Word<8>>,
    source_at: Constant<Word<8>>,
    shift_at: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [] LightStore []
    inputs { clock, load_valid, load_address, load_data }
    parts { source, point, shift, base_x, base_y, base_z, slope_x, slope_y, slope_z, colour_r, colour_g, colour_b, kept_source, kept_point, kept_shift, kept_base_x, kept_base_y, kept_base_z, kept_slope_x, kept_slope_y, kept_slope_z, kept_colour_r, kept_colour_g, kept_colour_b, at, bit_point, source_at, shift_at }
    data {  }
}

impl LightStore {
    pub(in crate::machine) fn new(light: u64) -> Self {
        fields! {
            [clock, load_valid, load_address, load_data, source, point, shift, base_x, base_y, base_z, slope_x, slope_y, slope_z, colour_r, colour_g, colour_b, kept_source, kept_point, kept_shift, kept_base_x, kept_base_y, kept_base_z, kept_slope_x, kept_slope_y, kept_slope_z, kept_colour_r, kept_colour_g, kept_colour_b]
            at: (0..10).map(|word| constant(16 * (light + 1) + word)).collect(),
            bit_point: constant(0),
            source_at: constant(4),
            shift_at: constant(8),
        }
    }
}

impl Logic for LightStore {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("light_store");
        clock!(
            self,
            clock,
            kept_source,
            kept_point,
            kept_shift,
            kept_base_x,
            kept_base_y,
            kept_base_z,
            kept_slope_x,
            kept_slope_y,
            kept_slope_z,
            kept_colour_r,
            kept_colour_g,
            kept_colour_b
        );
        self.kept_source.d.next = self.kept_source.q.val();
        self.kept_point.d.next = self.kept_point.q.val();
        self.kept_shift.d.next = self.kept_shift.q.val();
        self.kept_base_x.d.next = self.kept_base_x.q.val();
        self.kept_base_y.d.next = self.kept_base_y.q.val();
        self.kept_base_z.d.next = self.kept_base_z.q.val();
        self.kept_slope_x.d.next = self.kept_slope_x.q.val();
        self.kept_slope_y.d.next = self.kept_slope_y.q.val();
        self.kept_slope_z.d.next = self.kept_slope_z.q.val();
        self.kept_colour_r.d.next = self.kept_colour_r.q.val();
        self.kept_colour_g.d.next = self.kept_colour_g.q.val();
        self.kept_colour_b.d.next = self.kept_colour_b.q.val();
        if self.load_valid.val() {
            if self.load_address.val() == self.at[0].val() {
                self.kept_point.d.next = self.load_data.val().get_bit(self.bit_point.val().index());
                self.kept_source.d.next = self
                    .load_data
                    .val()
                    .get_bits::<4>(self.source_at.val().index());
                self.kept_shift.d.next = self
                    .load_data
                    .val()
                    .get_bits::<4>(self.shift_at.val().index());
            }
            if self.load_address.val() == self.at[1].val() {
                self.kept_base_x.d.next = signed_cast(self.load_data.val());
            }
            if self.load_address.val() == self.at[2].val() {
                self.kept_base_y.d.next = signed_cast(self.load_data.val());
            }
            if self.load_address.val() == self.at[3].val() {
                self.kept_base_z.d.next = signed_cast(self.load_data.val());
            }
            if self.load_address.val() == self.at[4].val() {
                self.kept_slope_x.d.next = signed_cast(self.load_data.val());
            }
            if self.load_address.val() == self.at[5].val() {
                self.kept_slope_y.d.next = signed_cast(self.load_data.val());
            }
            if self.load_address.val() == self.at[6].val() {
                self.kept_slope_z.d.next = signed_cast(self.load_data.val());
            }
            if self.load_address.val() == self.at[7].val() {
                self.kept_colour_r.d.next = self.load_data.val().get_bits::<17>(0);
            }
            if self.load_address.val() == self.at[8].val() {
                self.kept_colour_g.d.next = self.load_data.val().get_bits::<17>(0);
            }
            if self.load_address.val() == self.at[9].val() {
                self.kept_colour_b.d.next = self.load_data.val().get_bits::<17>(0);
            }
        }
        self.source.next = self.kept_source.q.val();
        self.point.next = self.kept_point.q.val();
        self.shift.next = self.kept_shift.q.val();
        self.base_x.next = self.kept_base_x.q.val();
        self.base_y.next = self.kept_base_y.q.val();
        self.base_z.next = self.kept_base_z.q.val();
        self.slope_x.next = self.kept_slope_x.q.val();
        self.slope_y.next = self.kept_slope_y.q.val();
        self.slope_z.next = self.kept_slope_z.q.val();
        self.colour_r.next = self.kept_colour_r.q.val();
        self.colour_g.next = self.kept_colour_g.q.val();
        self.colour_b.next = self.kept_colour_b.q.val();
    }
}

clocked!(LightStore);
