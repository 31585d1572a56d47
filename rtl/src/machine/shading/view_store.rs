//! Words of the view.
use crate::kernel::*;
/// Keeps the five words that all lights share. A word is written at the clock edge and holds until written again; all are zero at power-up.
pub struct ViewStore {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// This clock carries a word.
    pub load_valid: Signal<In, Bit>,
    /// Its address.
    pub load_address: Signal<In, Word<16>>,
    /// The word.
    pub load_data: Signal<In, Word<32>>,
    /// Columns of the picture.
    pub size_x: Signal<Out, Word<13>>,
    /// Lines of the picture.
    pub size_y: Signal<Out, Word<13>>,
    /// Lines of sight meet in the eye.
    pub perspective: Signal<Out, Bit>,
    /// The attenuation is on.
    pub is_attenuated: Signal<Out, Bit>,
    /// Places that coordinates are shifted to the right.
    pub view_shift: Signal<Out, Word<4>>,
    /// Distance of the eye.
    pub distance: Signal<Out, Word<17>>,
    /// Word of the attenuation.
    pub offset: Signal<Out, Int<30>>,
    /// Red of the background.
    pub background_r: Signal<Out, Word<8>>,
    /// Green of the background.
    pub background_g: Signal<Out, Word<8>>,
    /// Blue of the background.
    pub background_b: Signal<Out, Word<8>>,
    kept_size_x: DFF<Word<13>>,
    size_x_at: Constant<Word<8>>,
    kept_size_y: DFF<Word<13>>,
    size_y_at: Constant<Word<8>>,
    kept_perspective: DFF<Bit>,
    perspective_at: Constant<Word<8>>,
    kept_is_attenuated: DFF<Bit>,
    is_attenuated_at: Constant<Word<8>>,
    kept_view_shift: DFF<Word<4>>,
    view_shift_at: Constant<Word<8>>,
    kept_distance: DFF<Word<17>>,
    distance_at: Constant<Word<8>>,
    kept_offset: DFF<Int<30>>,
    kept_background_r: DFF<Word<8>>,
    background_r_at: Constant<Word<8>>,
    kept_background_g: DFF<Word<8>>,
    background_g_at: Constant<Word<8>>,
    kept_background_b: DFF<Word<8>>,
    background_b_at: Constant<Word<8>>,
    at: Vec<Constant<Word<16>>>,
    _asleep: bool,
}

block! {
    [] ViewStore []
    inputs { clock, load_valid, load_address, load_data }
    parts { size_x, size_y, perspective, is_attenuated, view_shift, distance, offset, background_r, background_g, background_b, kept_size_x, size_x_at, kept_size_y, size_y_at, kept_perspective, perspective_at, kept_is_attenuated, is_attenuated_at, kept_view_shift, view_shift_at, kept_distance, distance_at, kept_offset, kept_background_r, background_r_at, kept_background_g, background_g_at, kept_background_b, background_b_at, at }
    data {  }
}

impl ViewStore {
    pub(in crate::machine) fn new() -> Self {
        fields! {
            [clock, load_valid, load_address, load_data, size_x, size_y, perspective, is_attenuated, view_shift, distance, offset, background_r, background_g, background_b, kept_size_x, kept_size_y, kept_perspective, kept_is_attenuated, kept_view_shift, kept_distance, kept_offset, kept_background_r, kept_background_g, kept_background_b]
            at: (0..5).map(constant).collect(),
            size_x_at: constant(0),
            size_y_at: constant(16),
            perspective_at: constant(0),
            is_attenuated_at: constant(1),
            view_shift_at: constant(4),
            distance_at: constant(0),
            background_r_at: constant(0),
            background_g_at: constant(8),
            background_b_at: constant(16),
        }
    }
}

impl Logic for ViewStore {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("view_store");
        clock!(
            self,
            clock,
            kept_size_x,
            kept_size_y,
            kept_perspective,
            kept_is_attenuated,
            kept_view_shift,
            kept_distance,
            kept_offset,
            kept_background_r,
            kept_background_g,
            kept_background_b
        );
        self.kept_size_x.d.next = self.kept_size_x.q.val();
        self.kept_size_y.d.next = self.kept_size_y.q.val();
        self.kept_perspective.d.next = self.kept_perspective.q.val();
        self.kept_is_attenuated.d.next = self.kept_is_attenuated.q.val();
        self.kept_view_shift.d.next = self.kept_view_shift.q.val();
        self.kept_distance.d.next = self.kept_distance.q.val();
        self.kept_offset.d.next = self.kept_offset.q.val();
        self.kept_background_r.d.next = self.kept_background_r.q.val();
        self.kept_background_g.d.next = self.kept_background_g.q.val();
        self.kept_background_b.d.next = self.kept_background_b.q.val();
        if self.load_valid.val() {
            if self.load_address.val() == self.at[0].val() {
                self.kept_size_x.d.next = self
                    .load_data
                    .val()
                    .get_bits::<13>(self.size_x_at.val().index());
            }
            if self.load_address.val() == self.at[0].val() {
                self.kept_size_y.d.next = self
                    .load_data
                    .val()
                    .get_bits::<13>(self.size_y_at.val().index());
            }
            if self.load_address.val() == self.at[1].val() {
                self.kept_perspective.d.next = self
                    .load_data
                    .val()
                    .get_bit(self.perspective_at.val().index());
            }
            if self.load_address.val() == self.at[1].val() {
                self.kept_is_attenuated.d.next = self
                    .load_data
                    .val()
                    .get_bit(self.is_attenuated_at.val().index());
            }
            if self.load_address.val() == self.at[1].val() {
                self.kept_view_shift.d.next = self
                    .load_data
                    .val()
                    .get_bits::<4>(self.view_shift_at.val().index());
            }
            if self.load_address.val() == self.at[2].val() {
                self.kept_distance.d.next = self
                    .load_data
                    .val()
                    .get_bits::<17>(self.distance_at.val().index());
            }
            if self.load_address.val() == self.at[3].val() {
                self.kept_offset.d.next = signed_cast(self.load_data.val().get_bits::<30>(0));
            }
            if self.load_address.val() == self.at[4].val() {
                self.kept_background_r.d.next = self
                    .load_data
                    .val()
                    .get_bits::<8>(self.background_r_at.val().index());
            }
            if self.load_address.val() == self.at[4].val() {
                self.kept_background_g.d.next = self
                    .load_data
                    .val()
                    .get_bits::<8>(self.background_g_at.val().index());
            }
            if self.load_address.val() == self.at[4].val() {
                self.kept_background_b.d.next = self
                    .load_data
                    .val()
                    .get_bits::<8>(self.background_b_at.val().index());
            }
        }
        self.size_x.next = self.kept_size_x.q.val();
        self.size_y.next = self.kept_size_y.q.val();
        self.perspective.next = self.kept_perspective.q.val();
        self.is_attenuated.next = self.kept_is_attenuated.q.val();
        self.view_shift.next = self.kept_view_shift.q.val();
        self.distance.next = self.kept_distance.q.val();
        self.offset.next = self.kept_offset.q.val();
        self.background_r.next = self.kept_background_r.q.val();
        self.background_g.next = self.kept_background_g.q.val();
        self.background_b.next = self.kept_background_b.q.val();
    }
}

clocked!(ViewStore);
