//! Coefficient words of one object.

use crate::kernel::*;

/// First address of the words of plane i is `PLANE_ADDRESS + 7 i`.
pub const PLANE_ADDRESS: u64 = 24;
/// Words of one plane.
pub const PLANE_WORDS: u64 = 7;
/// Address of the columns of the screen box.
pub const BOX_COLUMNS: u64 = 21;
/// Address of the lines of the screen box.
pub const BOX_LINES: u64 = 22;
/// Address of the class and the shift.
pub const CONTROL: u64 = 23;

/// Keeps the coefficient words of one object.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `write` | in | write `data` to `address` |
/// | `address` | in | 8 bits |
/// | `data` | in | `B` bits, the widest word, `F` in the catalogue; a narrower word sits in the low bits |
/// | the others | out | the words, as the ports of the quadric processor |
///
/// | address | word |
/// |---|---|
/// | 0, 1, 2 | `f1_a`, `f1_b`, `f1_c` |
/// | 3 .. 8 | `f2_a2`, `f2_b2`, `f2_c`, `f2_i0`, `f2_p0`, `f2_f` |
/// | 9 .. 17 | `gx_a`, `gx_b`, `gx_c`, then y, then z |
/// | 18, 19, 20 | `kx`, `ky`, `kz` |
/// | 21 | `box_x0` in bits 11..0, `box_x1` in bits 23..12 |
/// | 22 | `box_y0`, `box_y1` likewise |
/// | 23 | `object_class` in bits 1..0, `shift` in bits 6..2 |
/// | 24 + 7i .. 30 + 7i | `plane_i_kind`, `_a`, `_b`, `_c`, `_nx`, `_ny`, `_nz` |
///
/// A word is visible after the clock that writes it and holds until written again. At power-up every word is zero, except
/// that the screen box is empty (`box_x0` = 4095), so that a store never loaded holds an absent object. Other addresses are
/// ignored.
pub struct CoefficientStore<
    const S: usize,
    const F: usize,
    const P: usize,
    const N: usize = 16,
    const G: usize = 24,
    const B: usize = F,
> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Write.
    pub write: Signal<In, Bit>,
    /// Which word.
    pub address: Signal<In, Word<8>>,
    /// The word.
    pub data: Signal<In, Word<B>>,
    /// Linear part: increment along the line.
    pub f1_a: Signal<Out, Int<S>>,
    /// Linear part: increment from line to line.
    pub f1_b: Signal<Out, Int<S>>,
    /// Linear part: value of the first pixel.
    pub f1_c: Signal<Out, Int<S>>,
    /// Quadratic: second difference along the line.
    pub f2_a2: Signal<Out, Int<F>>,
    /// Quadratic: second difference from line to line.
    pub f2_b2: Signal<Out, Int<F>>,
    /// Quadratic: mixed difference.
    pub f2_c: Signal<Out, Int<F>>,
    /// Quadratic: increment from the first line to the second.
    pub f2_i0: Signal<Out, Int<F>>,
    /// Quadratic: increment from the first pixel to the second.
    pub f2_p0: Signal<Out, Int<F>>,
    /// Quadratic: value of the first pixel.
    pub f2_f: Signal<Out, Int<F>>,
    /// Normal x: increment along the line.
    pub gx_a: Signal<Out, Int<G>>,
    /// Normal x: increment from line to line.
    pub gx_b: Signal<Out, Int<G>>,
    /// Normal x: value of the first pixel.
    pub gx_c: Signal<Out, Int<G>>,
    /// Normal y: increment along the line.
    pub gy_a: Signal<Out, Int<G>>,
    /// Normal y: increment from line to line.
    pub gy_b: Signal<Out, Int<G>>,
    /// Normal y: value of the first pixel.
    pub gy_c: Signal<Out, Int<G>>,
    /// Normal z: increment along the line.
    pub gz_a: Signal<Out, Int<G>>,
    /// Normal z: increment from line to line.
    pub gz_b: Signal<Out, Int<G>>,
    /// Normal z: value of the first pixel.
    pub gz_c: Signal<Out, Int<G>>,
    /// Factor of the root in normal x.
    pub kx: Signal<Out, Int<N>>,
    /// Factor of the root in normal y.
    pub ky: Signal<Out, Int<N>>,
    /// Factor of the root in normal z.
    pub kz: Signal<Out, Int<N>>,
    /// First column of the screen box.
    pub box_x0: Signal<Out, Word<12>>,
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
    /// Each plane: increment along the line.
    pub plane_a: Vec<Signal<Out, Int<P>>>,
    /// Each plane: increment from line to line.
    pub plane_b: Vec<Signal<Out, Int<P>>>,
    /// Each plane: value of the first pixel.
    pub plane_c: Vec<Signal<Out, Int<P>>>,
    /// Each plane: normal x.
    pub plane_nx: Vec<Signal<Out, Int<N>>>,
    /// Each plane: normal y.
    pub plane_ny: Vec<Signal<Out, Int<N>>>,
    /// Each plane: normal z.
    pub plane_nz: Vec<Signal<Out, Int<N>>>,
    kept_f1_a: DFF<Int<S>>,
    kept_f1_b: DFF<Int<S>>,
    kept_f1_c: DFF<Int<S>>,
    kept_f2_a2: DFF<Int<F>>,
    kept_f2_b2: DFF<Int<F>>,
    kept_f2_c: DFF<Int<F>>,
    kept_f2_i0: DFF<Int<F>>,
    kept_f2_p0: DFF<Int<F>>,
    kept_f2_f: DFF<Int<F>>,
    kept_gx_a: DFF<Int<G>>,
    kept_gx_b: DFF<Int<G>>,
    kept_gx_c: DFF<Int<G>>,
    kept_gy_a: DFF<Int<G>>,
    kept_gy_b: DFF<Int<G>>,
    kept_gy_c: DFF<Int<G>>,
    kept_gz_a: DFF<Int<G>>,
    kept_gz_b: DFF<Int<G>>,
    kept_gz_c: DFF<Int<G>>,
    kept_kx: DFF<Int<N>>,
    kept_ky: DFF<Int<N>>,
    kept_kz: DFF<Int<N>>,
    inverted_box_x0: DFF<Word<12>>,
    kept_box_x1: DFF<Word<12>>,
    kept_box_y0: DFF<Word<12>>,
    kept_box_y1: DFF<Word<12>>,
    kept_object_class: DFF<Word<2>>,
    kept_shift: DFF<Word<5>>,
    kept_plane_kind: Vec<DFF<Word<2>>>,
    kept_plane_a: Vec<DFF<Int<P>>>,
    kept_plane_b: Vec<DFF<Int<P>>>,
    kept_plane_c: Vec<DFF<Int<P>>>,
    kept_plane_nx: Vec<DFF<Int<N>>>,
    kept_plane_ny: Vec<DFF<Int<N>>>,
    kept_plane_nz: Vec<DFF<Int<N>>>,
    at: Vec<Constant<Word<8>>>,
    at_plane_kind: Vec<Constant<Word<8>>>,
    at_plane_a: Vec<Constant<Word<8>>>,
    at_plane_b: Vec<Constant<Word<8>>>,
    at_plane_c: Vec<Constant<Word<8>>>,
    at_plane_nx: Vec<Constant<Word<8>>>,
    at_plane_ny: Vec<Constant<Word<8>>>,
    at_plane_nz: Vec<Constant<Word<8>>>,
    at_box_columns: Constant<Word<8>>,
    at_box_lines: Constant<Word<8>>,
    at_control: Constant<Word<8>>,
    second: Constant<Word<8>>,
    shift_place: Constant<Word<8>>,
    _planes: usize,
    _asleep: bool,
}

block! {
    [const S: usize, const F: usize, const P: usize, const N: usize, const G: usize, const B: usize]
    CoefficientStore [S, F, P, N, G, B]
    inputs { clock, write, address, data }
    parts { f1_a, f1_b, f1_c, f2_a2, f2_b2, f2_c, f2_i0, f2_p0, f2_f, gx_a, gx_b, gx_c, gy_a,
        gy_b, gy_c, gz_a, gz_b, gz_c, kx, ky, kz, box_x0, box_x1, box_y0, box_y1, object_class,
        shift, plane_kind, plane_a, plane_b, plane_c, plane_nx, plane_ny, plane_nz, kept_f1_a,
        kept_f1_b, kept_f1_c, kept_f2_a2, kept_f2_b2, kept_f2_c, kept_f2_i0, kept_f2_p0,
        kept_f2_f, kept_gx_a, kept_gx_b, kept_gx_c, kept_gy_a, kept_gy_b, kept_gy_c, kept_gz_a,
        kept_gz_b, kept_gz_c, kept_kx, kept_ky, kept_kz, inverted_box_x0, kept_box_x1,
        kept_box_y0, kept_box_y1, kept_object_class, kept_shift, kept_plane_kind, kept_plane_a,
        kept_plane_b, kept_plane_c, kept_plane_nx, kept_plane_ny, kept_plane_nz, at,
        at_plane_kind, at_plane_a, at_plane_b, at_plane_c, at_plane_nx, at_plane_ny, at_plane_nz,
        at_box_columns, at_box_lines, at_control, second, shift_place }
    data { _planes }
}

fn plane_addresses(planes: usize, word: u64) -> Vec<Constant<Word<8>>> {
    (0..planes as u64)
        .map(|i| constant(PLANE_ADDRESS + PLANE_WORDS * i + word))
        .collect()
}

impl<const S: usize, const F: usize, const P: usize, const N: usize, const G: usize, const B: usize>
    CoefficientStore<S, F, P, N, G, B>
{
    /// A store for an object with `planes` planes.
    ///
    /// # Panics
    ///
    /// When a word does not fit the load bus.
    pub fn new(planes: usize) -> Self {
        let widest = [S, F, P, N, G, 24].into_iter().max();
        assert!(widest <= Some(B), "every word fits the load bus");
        Self {
            clock: Signal::default(),
            write: Signal::default(),
            address: Signal::default(),
            data: Signal::default(),
            f1_a: Signal::default(),
            f1_b: Signal::default(),
            f1_c: Signal::default(),
            f2_a2: Signal::default(),
            f2_b2: Signal::default(),
            f2_c: Signal::default(),
            f2_i0: Signal::default(),
            f2_p0: Signal::default(),
            f2_f: Signal::default(),
            gx_a: Signal::default(),
            gx_b: Signal::default(),
            gx_c: Signal::default(),
            gy_a: Signal::default(),
            gy_b: Signal::default(),
            gy_c: Signal::default(),
            gz_a: Signal::default(),
            gz_b: Signal::default(),
            gz_c: Signal::default(),
            kx: Signal::default(),
            ky: Signal::default(),
            kz: Signal::default(),
            box_x0: Signal::default(),
            box_x1: Signal::default(),
            box_y0: Signal::default(),
            box_y1: Signal::default(),
            object_class: Signal::default(),
            shift: Signal::default(),
            plane_kind: repeat(planes, Signal::default),
            plane_a: repeat(planes, Signal::default),
            plane_b: repeat(planes, Signal::default),
            plane_c: repeat(planes, Signal::default),
            plane_nx: repeat(planes, Signal::default),
            plane_ny: repeat(planes, Signal::default),
            plane_nz: repeat(planes, Signal::default),
            kept_f1_a: DFF::default(),
            kept_f1_b: DFF::default(),
            kept_f1_c: DFF::default(),
            kept_f2_a2: DFF::default(),
            kept_f2_b2: DFF::default(),
            kept_f2_c: DFF::default(),
            kept_f2_i0: DFF::default(),
            kept_f2_p0: DFF::default(),
            kept_f2_f: DFF::default(),
            kept_gx_a: DFF::default(),
            kept_gx_b: DFF::default(),
            kept_gx_c: DFF::default(),
            kept_gy_a: DFF::default(),
            kept_gy_b: DFF::default(),
            kept_gy_c: DFF::default(),
            kept_gz_a: DFF::default(),
            kept_gz_b: DFF::default(),
            kept_gz_c: DFF::default(),
            kept_kx: DFF::default(),
            kept_ky: DFF::default(),
            kept_kz: DFF::default(),
            inverted_box_x0: DFF::default(),
            kept_box_x1: DFF::default(),
            kept_box_y0: DFF::default(),
            kept_box_y1: DFF::default(),
            kept_object_class: DFF::default(),
            kept_shift: DFF::default(),
            kept_plane_kind: repeat(planes, DFF::default),
            kept_plane_a: repeat(planes, DFF::default),
            kept_plane_b: repeat(planes, DFF::default),
            kept_plane_c: repeat(planes, DFF::default),
            kept_plane_nx: repeat(planes, DFF::default),
            kept_plane_ny: repeat(planes, DFF::default),
            kept_plane_nz: repeat(planes, DFF::default),
            at: (0..BOX_COLUMNS).map(constant).collect(),
            at_plane_kind: plane_addresses(planes, 0),
            at_plane_a: plane_addresses(planes, 1),
            at_plane_b: plane_addresses(planes, 2),
            at_plane_c: plane_addresses(planes, 3),
            at_plane_nx: plane_addresses(planes, 4),
            at_plane_ny: plane_addresses(planes, 5),
            at_plane_nz: plane_addresses(planes, 6),
            at_box_columns: constant(BOX_COLUMNS),
            at_box_lines: constant(BOX_LINES),
            at_control: constant(CONTROL),
            second: constant(12),
            shift_place: constant(2),
            _planes: planes,
            _asleep: false,
        }
    }

    /// Clocks from a write to the word.
    pub const fn latency() -> usize {
        1
    }
}

impl<const S: usize, const F: usize, const P: usize, const N: usize, const G: usize, const B: usize>
    Logic for CoefficientStore<S, F, P, N, G, B>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("coefficient_store");
        dff_setup!(
            self,
            clock,
            kept_f1_a,
            kept_f1_b,
            kept_f1_c,
            kept_f2_a2,
            kept_f2_b2,
            kept_f2_c,
            kept_f2_i0,
            kept_f2_p0,
            kept_f2_f,
            kept_gx_a,
            kept_gx_b,
            kept_gx_c,
            kept_gy_a,
            kept_gy_b,
            kept_gy_c,
            kept_gz_a,
            kept_gz_b,
            kept_gz_c,
            kept_kx,
            kept_ky,
            kept_kz,
            inverted_box_x0,
            kept_box_x1,
            kept_box_y0,
            kept_box_y1,
            kept_object_class,
            kept_shift
        );
        for i in 0..self._planes {
            self.kept_plane_kind[i].clock.next = self.clock.val();
            self.kept_plane_kind[i].d.next = self.kept_plane_kind[i].q.val();
            self.kept_plane_a[i].clock.next = self.clock.val();
            self.kept_plane_a[i].d.next = self.kept_plane_a[i].q.val();
            self.kept_plane_b[i].clock.next = self.clock.val();
            self.kept_plane_b[i].d.next = self.kept_plane_b[i].q.val();
            self.kept_plane_c[i].clock.next = self.clock.val();
            self.kept_plane_c[i].d.next = self.kept_plane_c[i].q.val();
            self.kept_plane_nx[i].clock.next = self.clock.val();
            self.kept_plane_nx[i].d.next = self.kept_plane_nx[i].q.val();
            self.kept_plane_ny[i].clock.next = self.clock.val();
            self.kept_plane_ny[i].d.next = self.kept_plane_ny[i].q.val();
            self.kept_plane_nz[i].clock.next = self.clock.val();
            self.kept_plane_nz[i].d.next = self.kept_plane_nz[i].q.val();
        }
        if self.write.val() {
            if self.address.val() == self.at[0].val() {
                self.kept_f1_a.d.next = signed_cast(self.data.val().get_bits::<S>(0));
            }
            if self.address.val() == self.at[1].val() {
                self.kept_f1_b.d.next = signed_cast(self.data.val().get_bits::<S>(0));
            }
            if self.address.val() == self.at[2].val() {
                self.kept_f1_c.d.next = signed_cast(self.data.val().get_bits::<S>(0));
            }
            if self.address.val() == self.at[3].val() {
                self.kept_f2_a2.d.next = signed_cast(self.data.val().get_bits::<F>(0));
            }
            if self.address.val() == self.at[4].val() {
                self.kept_f2_b2.d.next = signed_cast(self.data.val().get_bits::<F>(0));
            }
            if self.address.val() == self.at[5].val() {
                self.kept_f2_c.d.next = signed_cast(self.data.val().get_bits::<F>(0));
            }
            if self.address.val() == self.at[6].val() {
                self.kept_f2_i0.d.next = signed_cast(self.data.val().get_bits::<F>(0));
            }
            if self.address.val() == self.at[7].val() {
                self.kept_f2_p0.d.next = signed_cast(self.data.val().get_bits::<F>(0));
            }
            if self.address.val() == self.at[8].val() {
                self.kept_f2_f.d.next = signed_cast(self.data.val().get_bits::<F>(0));
            }
            if self.address.val() == self.at[9].val() {
                self.kept_gx_a.d.next = signed_cast(self.data.val().get_bits::<G>(0));
            }
            if self.address.val() == self.at[10].val() {
                self.kept_gx_b.d.next = signed_cast(self.data.val().get_bits::<G>(0));
            }
            if self.address.val() == self.at[11].val() {
                self.kept_gx_c.d.next = signed_cast(self.data.val().get_bits::<G>(0));
            }
            if self.address.val() == self.at[12].val() {
                self.kept_gy_a.d.next = signed_cast(self.data.val().get_bits::<G>(0));
            }
            if self.address.val() == self.at[13].val() {
                self.kept_gy_b.d.next = signed_cast(self.data.val().get_bits::<G>(0));
            }
            if self.address.val() == self.at[14].val() {
                self.kept_gy_c.d.next = signed_cast(self.data.val().get_bits::<G>(0));
            }
            if self.address.val() == self.at[15].val() {
                self.kept_gz_a.d.next = signed_cast(self.data.val().get_bits::<G>(0));
            }
            if self.address.val() == self.at[16].val() {
                self.kept_gz_b.d.next = signed_cast(self.data.val().get_bits::<G>(0));
            }
            if self.address.val() == self.at[17].val() {
                self.kept_gz_c.d.next = signed_cast(self.data.val().get_bits::<G>(0));
            }
            if self.address.val() == self.at[18].val() {
                self.kept_kx.d.next = signed_cast(self.data.val().get_bits::<N>(0));
            }
            if self.address.val() == self.at[19].val() {
                self.kept_ky.d.next = signed_cast(self.data.val().get_bits::<N>(0));
            }
            if self.address.val() == self.at[20].val() {
                self.kept_kz.d.next = signed_cast(self.data.val().get_bits::<N>(0));
            }
            if self.address.val() == self.at_box_columns.val() {
                // Kept inverted, so that the zero of power-up is an empty box.
                self.inverted_box_x0.d.next = !self.data.val().get_bits::<12>(0);
                self.kept_box_x1.d.next = self.data.val().get_bits::<12>(self.second.val().index());
            }
            if self.address.val() == self.at_box_lines.val() {
                self.kept_box_y0.d.next = self.data.val().get_bits::<12>(0);
                self.kept_box_y1.d.next = self.data.val().get_bits::<12>(self.second.val().index());
            }
            if self.address.val() == self.at_control.val() {
                self.kept_object_class.d.next = self.data.val().get_bits::<2>(0);
                self.kept_shift.d.next = self
                    .data
                    .val()
                    .get_bits::<5>(self.shift_place.val().index());
            }
            for i in 0..self._planes {
                if self.address.val() == self.at_plane_kind[i].val() {
                    self.kept_plane_kind[i].d.next = self.data.val().get_bits::<2>(0);
                }
                if self.address.val() == self.at_plane_a[i].val() {
                    self.kept_plane_a[i].d.next = signed_cast(self.data.val().get_bits::<P>(0));
                }
                if self.address.val() == self.at_plane_b[i].val() {
                    self.kept_plane_b[i].d.next = signed_cast(self.data.val().get_bits::<P>(0));
                }
                if self.address.val() == self.at_plane_c[i].val() {
                    self.kept_plane_c[i].d.next = signed_cast(self.data.val().get_bits::<P>(0));
                }
                if self.address.val() == self.at_plane_nx[i].val() {
                    self.kept_plane_nx[i].d.next = signed_cast(self.data.val().get_bits::<N>(0));
                }
                if self.address.val() == self.at_plane_ny[i].val() {
                    self.kept_plane_ny[i].d.next = signed_cast(self.data.val().get_bits::<N>(0));
                }
                if self.address.val() == self.at_plane_nz[i].val() {
                    self.kept_plane_nz[i].d.next = signed_cast(self.data.val().get_bits::<N>(0));
                }
            }
        }
        self.f1_a.next = self.kept_f1_a.q.val();
        self.f1_b.next = self.kept_f1_b.q.val();
        self.f1_c.next = self.kept_f1_c.q.val();
        self.f2_a2.next = self.kept_f2_a2.q.val();
        self.f2_b2.next = self.kept_f2_b2.q.val();
        self.f2_c.next = self.kept_f2_c.q.val();
        self.f2_i0.next = self.kept_f2_i0.q.val();
        self.f2_p0.next = self.kept_f2_p0.q.val();
        self.f2_f.next = self.kept_f2_f.q.val();
        self.gx_a.next = self.kept_gx_a.q.val();
        self.gx_b.next = self.kept_gx_b.q.val();
        self.gx_c.next = self.kept_gx_c.q.val();
        self.gy_a.next = self.kept_gy_a.q.val();
        self.gy_b.next = self.kept_gy_b.q.val();
        self.gy_c.next = self.kept_gy_c.q.val();
        self.gz_a.next = self.kept_gz_a.q.val();
        self.gz_b.next = self.kept_gz_b.q.val();
        self.gz_c.next = self.kept_gz_c.q.val();
        self.kx.next = self.kept_kx.q.val();
        self.ky.next = self.kept_ky.q.val();
        self.kz.next = self.kept_kz.q.val();
        self.box_x0.next = !self.inverted_box_x0.q.val();
        self.box_x1.next = self.kept_box_x1.q.val();
        self.box_y0.next = self.kept_box_y0.q.val();
        self.box_y1.next = self.kept_box_y1.q.val();
        self.object_class.next = self.kept_object_class.q.val();
        self.shift.next = self.kept_shift.q.val();
        for i in 0..self._planes {
            self.plane_kind[i].next = self.kept_plane_kind[i].q.val();
            self.plane_a[i].next = self.kept_plane_a[i].q.val();
            self.plane_b[i].next = self.kept_plane_b[i].q.val();
            self.plane_c[i].next = self.kept_plane_c[i].q.val();
            self.plane_nx[i].next = self.kept_plane_nx[i].q.val();
            self.plane_ny[i].next = self.kept_plane_ny[i].q.val();
            self.plane_nz[i].next = self.kept_plane_nz[i].q.val();
        }
    }
}

clocked!(CoefficientStore<const S: usize, const F: usize, const P: usize, const N: usize, const G: usize, const B: usize>);
