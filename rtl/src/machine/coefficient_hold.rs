//! Words of an object that are used at every pixel, kept while those of the next object are loaded.

use super::coefficient_store::CONTROL;
use crate::kernel::*;

/// Address of the id of an object in a machine that shares its processors in time.
pub const OBJECT_ID: u64 = 255;

/// Takes over the words of a coefficient store at the beginning of a pass, and keeps them until the next.
///
/// An elementary processor reads its words at the first pixel and keeps what it needs; only the words below are used at every pixel. So the store may be
/// loaded with the next object as soon as all processors have started, and only these words are kept twice.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `take` | in | take over the words |
/// | `write`, `address`, `data` | in | the load bus of the store beside it |
/// | `next_..` | in | the words of the store |
/// | `id` | out | 12 bits, written to address 255 |
/// | the others | out | the words taken over, as the ports of the quadric processor |
///
/// An object whose control word (address 23) was not written since the last `take` is absent: its screen box is empty.
pub struct CoefficientHold<const B: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Take over the words.
    pub take: Signal<In, Bit>,
    /// Write to the store.
    pub write: Signal<In, Bit>,
    /// Which word.
    pub address: Signal<In, Word<8>>,
    /// The word.
    pub data: Signal<In, Word<B>>,
    /// First column of the screen box, in the store.
    pub next_box_x0: Signal<In, Word<12>>,
    /// Factor of the root in normal x, in the store.
    pub next_kx: Signal<In, Int<16>>,
    /// Factor of the root in normal y, in the store.
    pub next_ky: Signal<In, Int<16>>,
    /// Factor of the root in normal z, in the store.
    pub next_kz: Signal<In, Int<16>>,
    /// Last column of the screen box, in the store.
    pub next_box_x1: Signal<In, Word<12>>,
    /// First line of the screen box, in the store.
    pub next_box_y0: Signal<In, Word<12>>,
    /// Last line of the screen box, in the store.
    pub next_box_y1: Signal<In, Word<12>>,
    /// Class of the object, in the store.
    pub next_object_class: Signal<In, Word<2>>,
    /// Places the root is shifted for the normal, in the store.
    pub next_shift: Signal<In, Word<5>>,
    /// Kind of each plane, in the store.
    pub next_plane_kind: Vec<Signal<In, Word<2>>>,
    /// Each plane: normal x, in the store.
    pub next_plane_nx: Vec<Signal<In, Int<16>>>,
    /// Each plane: normal y, in the store.
    pub next_plane_ny: Vec<Signal<In, Int<16>>>,
    /// Each plane: normal z, in the store.
    pub next_plane_nz: Vec<Signal<In, Int<16>>>,
    /// Id of the object.
    pub id: Signal<Out, Word<12>>,
    /// First column of the screen box.
    pub box_x0: Signal<Out, Word<12>>,
    /// Factor of the root in normal x.
    pub kx: Signal<Out, Int<16>>,
    /// Factor of the root in normal y.
    pub ky: Signal<Out, Int<16>>,
    /// Factor of the root in normal z.
    pub kz: Signal<Out, Int<16>>,
    /// Last column of the screen box.
    pub box_x1: Signal<Out, Word<12>>,
    /// First line of the screen box.
    pub box_y0: Signal<Out, Word<12>>,
    /// Last line of the screen box.
    pub box_y1: Signal<Out, Word<12>>,
    /// Class of the object.
    pub object_class: Signal<Out, Word<2>>,
    /// Places the root is shifted for the normal.
    pub shift: Signal<Out, Word<5>>,
    /// Kind of each plane.
    pub plane_kind: Vec<Signal<Out, Word<2>>>,
    /// Each plane: normal x.
    pub plane_nx: Vec<Signal<Out, Int<16>>>,
    /// Each plane: normal y.
    pub plane_ny: Vec<Signal<Out, Int<16>>>,
    /// Each plane: normal z.
    pub plane_nz: Vec<Signal<Out, Int<16>>>,
    next_id: DFF<Word<12>>,
    next_present: DFF<Bit>,
    kept_id: DFF<Word<12>>,
    inverted_box_x0: DFF<Word<12>>,
    kept_kx: DFF<Int<16>>,
    kept_ky: DFF<Int<16>>,
    kept_kz: DFF<Int<16>>,
    kept_box_x1: DFF<Word<12>>,
    kept_box_y0: DFF<Word<12>>,
    kept_box_y1: DFF<Word<12>>,
    kept_object_class: DFF<Word<2>>,
    kept_shift: DFF<Word<5>>,
    kept_plane_kind: Vec<DFF<Word<2>>>,
    kept_plane_nx: Vec<DFF<Int<16>>>,
    kept_plane_ny: Vec<DFF<Int<16>>>,
    kept_plane_nz: Vec<DFF<Int<16>>>,
    at_id: Constant<Word<8>>,
    at_control: Constant<Word<8>>,
    nowhere: Constant<Word<12>>,
    _planes: usize,
    _asleep: bool,
}

block! {
    [const B: usize] CoefficientHold [B]
    inputs { clock, take, write, address, data, next_box_x0, next_kx, next_ky, next_kz, next_box_x1, next_box_y0, next_box_y1, next_object_class, next_shift, next_plane_kind, next_plane_nx, next_plane_ny, next_plane_nz }
    parts { id, box_x0, kx, ky, kz, box_x1, box_y0, box_y1, object_class, shift, plane_kind, plane_nx, plane_ny, plane_nz, next_id, next_present, kept_id, inverted_box_x0, kept_kx, kept_ky, kept_kz, kept_box_x1, kept_box_y0, kept_box_y1, kept_object_class, kept_shift, kept_plane_kind, kept_plane_nx, kept_plane_ny, kept_plane_nz, at_id, at_control, nowhere }
    data { _planes }
}

impl<const B: usize> CoefficientHold<B> {
    /// For an object with `planes` planes.
    pub fn new(planes: usize) -> Self {
        fields! {
            [clock, take, write, address, data, next_box_x0, next_kx, next_ky, next_kz, next_box_x1, next_box_y0, next_box_y1, next_object_class, next_shift, id, box_x0, kx, ky, kz, box_x1, box_y0, box_y1, object_class, shift, next_id, next_present, kept_id,
                inverted_box_x0, kept_kx, kept_ky, kept_kz, kept_box_x1, kept_box_y0, kept_box_y1, kept_object_class, kept_shift]
            next_plane_kind: repeat(planes, Default::default),
            plane_kind: repeat(planes, Default::default),
            kept_plane_kind: repeat(planes, Default::default),
            next_plane_nx: repeat(planes, Default::default),
            plane_nx: repeat(planes, Default::default),
            kept_plane_nx: repeat(planes, Default::default),
            next_plane_ny: repeat(planes, Default::default),
            plane_ny: repeat(planes, Default::default),
            kept_plane_ny: repeat(planes, Default::default),
            next_plane_nz: repeat(planes, Default::default),
            plane_nz: repeat(planes, Default::default),
            kept_plane_nz: repeat(planes, Default::default),
            at_id: constant(OBJECT_ID),
            at_control: constant(CONTROL),
            nowhere: constant(0),
            _planes: planes,
        }
    }
}

impl<const B: usize> Logic for CoefficientHold<B> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("coefficient_hold");
        dff_setup!(
            self,
            clock,
            next_id,
            next_present,
            kept_id,
            inverted_box_x0,
            kept_kx,
            kept_ky,
            kept_kz,
            kept_box_x1,
            kept_box_y0,
            kept_box_y1,
            kept_object_class,
            kept_shift
        );
        for i in 0..self._planes {
            self.kept_plane_kind[i].clock.next = self.clock.val();
            self.kept_plane_kind[i].d.next = self.kept_plane_kind[i].q.val();
            self.kept_plane_nx[i].clock.next = self.clock.val();
            self.kept_plane_nx[i].d.next = self.kept_plane_nx[i].q.val();
            self.kept_plane_ny[i].clock.next = self.clock.val();
            self.kept_plane_ny[i].d.next = self.kept_plane_ny[i].q.val();
            self.kept_plane_nz[i].clock.next = self.clock.val();
            self.kept_plane_nz[i].d.next = self.kept_plane_nz[i].q.val();
        }
        if self.take.val() {
            self.next_present.d.next = false;
            self.kept_id.d.next = self.next_id.q.val();
            // Kept inverted: zero, also that of power-up, is an empty box.
            self.inverted_box_x0.d.next = self.nowhere.val();
            if self.next_present.q.val() {
                self.inverted_box_x0.d.next = !self.next_box_x0.val();
            }
            self.kept_kx.d.next = self.next_kx.val();
            self.kept_ky.d.next = self.next_ky.val();
            self.kept_kz.d.next = self.next_kz.val();
            self.kept_box_x1.d.next = self.next_box_x1.val();
            self.kept_box_y0.d.next = self.next_box_y0.val();
            self.kept_box_y1.d.next = self.next_box_y1.val();
            self.kept_object_class.d.next = self.next_object_class.val();
            self.kept_shift.d.next = self.next_shift.val();
            for i in 0..self._planes {
                self.kept_plane_kind[i].d.next = self.next_plane_kind[i].val();
                self.kept_plane_nx[i].d.next = self.next_plane_nx[i].val();
                self.kept_plane_ny[i].d.next = self.next_plane_ny[i].val();
                self.kept_plane_nz[i].d.next = self.next_plane_nz[i].val();
            }
        }
        if self.write.val() {
            if self.address.val() == self.at_id.val() {
                self.next_id.d.next = self.data.val().get_bits::<12>(0);
            }
            if self.address.val() == self.at_control.val() {
                self.next_present.d.next = true;
            }
        }
        self.id.next = self.kept_id.q.val();
        self.box_x0.next = !self.inverted_box_x0.q.val();
        self.kx.next = self.kept_kx.q.val();
        self.ky.next = self.kept_ky.q.val();
        self.kz.next = self.kept_kz.q.val();
        self.box_x1.next = self.kept_box_x1.q.val();
        self.box_y0.next = self.kept_box_y0.q.val();
        self.box_y1.next = self.kept_box_y1.q.val();
        self.object_class.next = self.kept_object_class.q.val();
        self.shift.next = self.kept_shift.q.val();
        for i in 0..self._planes {
            self.plane_kind[i].next = self.kept_plane_kind[i].q.val();
            self.plane_nx[i].next = self.kept_plane_nx[i].q.val();
            self.plane_ny[i].next = self.kept_plane_ny[i].q.val();
            self.plane_nz[i].next = self.kept_plane_nz[i].q.val();
        }
    }
}

clocked!(CoefficientHold<const B: usize>);
