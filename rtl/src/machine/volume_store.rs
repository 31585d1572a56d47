//! Words of a shadow or light volume.

use crate::kernel::*;

/// First address of the words of plane i is `VOLUME_PLANE_ADDRESS + 4 i`.
pub const VOLUME_PLANE_ADDRESS: u64 = 13;
/// Words of one plane of a volume.
pub const VOLUME_PLANE_WORDS: u64 = 4;

/// Keeps the words of a volume; those used at every pixel are kept twice, so that the next volume may be loaded while this one is asked.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `take` | in | begin a pass: the words loaded become those of the volume |
/// | `write` | in | write `data` to `address` |
/// | `address` | in | 8 bits |
/// | `data` | in | `F` bits; a narrower word sits in the low bits |
/// | `is_present` | out | the control word was written before the last `take` and after the one before |
/// | `is_light`, `source` | out | a light volume or a shadow, and its source |
/// | the others | out | the words, as the ports of the quadric volume |
///
/// | address | word |
/// |---|---|
/// | 0, 1, 2 | `f1_a`, `f1_b`, `f1_c` |
/// | 3 .. 8 | `f2_a2`, `f2_b2`, `f2_c`, `f2_i0`, `f2_p0`, `f2_f` |
/// | 9 | `box_x0` in bits 11..0, `box_x1` in bits 23..12 |
/// | 10 | `box_y0`, `box_y1` likewise |
/// | 11 | control: class in bits 1..0, `depth_shift` in 5..2, light volume in 6, source in 10..7 |
/// | 12 | `margin` |
/// | 13 + 4i .. 16 + 4i | `plane_i_kind`, `_a`, `_b`, `_c` |
///
/// The elementary processors read `f1`, `f2` and the planes at the first pixel only; these words act as they are loaded.
pub struct VolumeStore<const W: usize, const S: usize, const F: usize, const P: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Begin a pass.
    pub take: Signal<In, Bit>,
    /// Write.
    pub write: Signal<In, Bit>,
    /// Which word.
    pub address: Signal<In, Word<8>>,
    /// The word.
    pub data: Signal<In, Word<F>>,
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
    /// First column of the screen box.
    pub box_x0: Signal<Out, Word<12>>,
    /// Last column of the screen box.
    pub box_x1: Signal<Out, Word<12>>,
    /// First line of the screen box.
    pub box_y0: Signal<Out, Word<12>>,
    /// Last line of the screen box.
    pub box_y1: Signal<Out, Word<12>>,
    /// Class of the quadric.
    pub object_class: Signal<Out, Word<2>>,
    /// Places by which the quadric's unit of depth is greater.
    pub depth_shift: Signal<Out, Word<4>>,
    /// A light volume: outside is dark.
    pub is_light: Signal<Out, Bit>,
    /// The source it belongs to.
    pub source: Signal<Out, Word<4>>,
    /// Counts that a point has to lie behind the beginning.
    pub margin: Signal<Out, Word<W>>,
    /// There is a volume.
    pub is_present: Signal<Out, Bit>,
    /// Kind of each plane.
    pub plane_kind: Vec<Signal<Out, Word<2>>>,
    /// Each plane: increment along the line.
    pub plane_a: Vec<Signal<Out, Int<P>>>,
    /// Each plane: increment from line to line.
    pub plane_b: Vec<Signal<Out, Int<P>>>,
    /// Each plane: value of the first pixel.
    pub plane_c: Vec<Signal<Out, Int<P>>>,
    kept_f1_a: DFF<Int<S>>,
    kept_f1_b: DFF<Int<S>>,
    kept_f1_c: DFF<Int<S>>,
    kept_f2_a2: DFF<Int<F>>,
    kept_f2_b2: DFF<Int<F>>,
    kept_f2_c: DFF<Int<F>>,
    kept_f2_i0: DFF<Int<F>>,
    kept_f2_p0: DFF<Int<F>>,
    kept_f2_f: DFF<Int<F>>,
    next_box_x0: DFF<Word<12>>,
    kept_box_x0: DFF<Word<12>>,
    next_box_x1: DFF<Word<12>>,
    kept_box_x1: DFF<Word<12>>,
    next_box_y0: DFF<Word<12>>,
    kept_box_y0: DFF<Word<12>>,
    next_box_y1: DFF<Word<12>>,
    kept_box_y1: DFF<Word<12>>,
    next_object_class: DFF<Word<2>>,
    kept_object_class: DFF<Word<2>>,
    next_depth_shift: DFF<Word<4>>,
    kept_depth_shift: DFF<Word<4>>,
    next_is_light: DFF<Bit>,
    kept_is_light: DFF<Bit>,
    next_source: DFF<Word<4>>,
    kept_source: DFF<Word<4>>,
    next_margin: DFF<Word<W>>,
    kept_margin: DFF<Word<W>>,
    next_is_present: DFF<Bit>,
    kept_is_present: DFF<Bit>,
    next_plane_kind: Vec<DFF<Word<2>>>,
    kept_plane_kind: Vec<DFF<Word<2>>>,
    kept_plane_a: Vec<DFF<Int<P>>>,
    kept_plane_b: Vec<DFF<Int<P>>>,
    kept_plane_c: Vec<DFF<Int<P>>>,
    at: Vec<Constant<Word<8>>>,
    at_plane_kind: Vec<Constant<Word<8>>>,
    at_plane_a: Vec<Constant<Word<8>>>,
    at_plane_b: Vec<Constant<Word<8>>>,
    at_plane_c: Vec<Constant<Word<8>>>,
    at_box_columns: Constant<Word<8>>,
    at_box_lines: Constant<Word<8>>,
    at_control: Constant<Word<8>>,
    at_margin: Constant<Word<8>>,
    second: Constant<Word<8>>,
    shift_place: Constant<Word<8>>,
    light_place: Constant<Word<8>>,
    source_place: Constant<Word<8>>,
    _planes: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize, const F: usize, const P: usize] VolumeStore [W, S, F, P]
    inputs { clock, take, write, address, data }
    parts { f1_a, f1_b, f1_c, f2_a2, f2_b2, f2_c, f2_i0, f2_p0, f2_f, box_x0, box_x1, box_y0, box_y1, object_class, depth_shift, is_light, source, margin, is_present, plane_kind, plane_a, plane_b, plane_c, kept_f1_a, kept_f1_b, kept_f1_c, kept_f2_a2, kept_f2_b2, kept_f2_c, kept_f2_i0, kept_f2_p0, kept_f2_f, next_box_x0, kept_box_x0, next_box_x1, kept_box_x1, next_box_y0, kept_box_y0, next_box_y1, kept_box_y1, next_object_class, kept_object_class, next_depth_shift, kept_depth_shift, next_is_light, kept_is_light, next_source, kept_source, next_margin, kept_margin, next_is_present, kept_is_present, next_plane_kind, kept_plane_kind, kept_plane_a, kept_plane_b, kept_plane_c, at, at_plane_kind, at_plane_a, at_plane_b, at_plane_c, at_box_columns, at_box_lines, at_control, at_margin, second, shift_place, light_place, source_place }
    data { _planes }
}

fn plane_addresses(planes: usize, word: u64) -> Vec<Constant<Word<8>>> {
    (0..planes as u64)
        .map(|i| constant(VOLUME_PLANE_ADDRESS + VOLUME_PLANE_WORDS * i + word))
        .collect()
}

impl<const W: usize, const S: usize, const F: usize, const P: usize> VolumeStore<W, S, F, P> {
    /// A store for a volume with `planes` planes.
    pub fn new(planes: usize) -> Self {
        fields! {
            [clock, take, write, address, data, f1_a, f1_b, f1_c, f2_a2, f2_b2, f2_c, f2_i0, f2_p0, f2_f, box_x0, box_x1, box_y0, box_y1, object_class, depth_shift, is_light, source, margin, is_present, kept_f1_a, kept_f1_b, kept_f1_c, kept_f2_a2, kept_f2_b2, kept_f2_c, kept_f2_i0, kept_f2_p0, kept_f2_f, next_box_x0, kept_box_x0, next_box_x1, kept_box_x1, next_box_y0, kept_box_y0, next_box_y1, kept_box_y1, next_object_class, kept_object_class, next_depth_shift, kept_depth_shift, next_is_light, kept_is_light, next_source, kept_source, next_margin, kept_margin, next_is_present, kept_is_present]
            plane_kind: repeat(planes, Default::default),
            kept_plane_kind: repeat(planes, Default::default),
            plane_a: repeat(planes, Default::default),
            kept_plane_a: repeat(planes, Default::default),
            plane_b: repeat(planes, Default::default),
            kept_plane_b: repeat(planes, Default::default),
            plane_c: repeat(planes, Default::default),
            kept_plane_c: repeat(planes, Default::default),
            next_plane_kind: repeat(planes, Default::default),
            at: (0..9).map(constant).collect(),
            at_plane_kind: plane_addresses(planes, 0),
            at_plane_a: plane_addresses(planes, 1),
            at_plane_b: plane_addresses(planes, 2),
            at_plane_c: plane_addresses(planes, 3),
            at_box_columns: constant(9),
            at_box_lines: constant(10),
            at_control: constant(11),
            at_margin: constant(12),
            second: constant(12),
            shift_place: constant(2),
            light_place: constant(6),
            source_place: constant(7),
            _planes: planes,
        }
    }
}

impl<const W: usize, const S: usize, const F: usize, const P: usize> Logic
    for VolumeStore<W, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("volume_store");
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
            next_box_x0,
            kept_box_x0,
            next_box_x1,
            kept_box_x1,
            next_box_y0,
            kept_box_y0,
            next_box_y1,
            kept_box_y1,
            next_object_class,
            kept_object_class,
            next_depth_shift,
            kept_depth_shift,
            next_is_light,
            kept_is_light,
            next_source,
            kept_source,
            next_margin,
            kept_margin,
            next_is_present,
            kept_is_present
        );
        for i in 0..self._planes {
            self.kept_plane_kind[i].clock.next = self.clock.val();
            self.kept_plane_kind[i].d.next = self.kept_plane_kind[i].q.val();
            self.next_plane_kind[i].clock.next = self.clock.val();
            self.next_plane_kind[i].d.next = self.next_plane_kind[i].q.val();
            self.kept_plane_a[i].clock.next = self.clock.val();
            self.kept_plane_a[i].d.next = self.kept_plane_a[i].q.val();
            self.kept_plane_b[i].clock.next = self.clock.val();
            self.kept_plane_b[i].d.next = self.kept_plane_b[i].q.val();
            self.kept_plane_c[i].clock.next = self.clock.val();
            self.kept_plane_c[i].d.next = self.kept_plane_c[i].q.val();
        }
        if self.take.val() {
            self.kept_box_x0.d.next = self.next_box_x0.q.val();
            self.kept_box_x1.d.next = self.next_box_x1.q.val();
            self.kept_box_y0.d.next = self.next_box_y0.q.val();
            self.kept_box_y1.d.next = self.next_box_y1.q.val();
            self.kept_object_class.d.next = self.next_object_class.q.val();
            self.kept_depth_shift.d.next = self.next_depth_shift.q.val();
            self.kept_is_light.d.next = self.next_is_light.q.val();
            self.kept_source.d.next = self.next_source.q.val();
            self.kept_margin.d.next = self.next_margin.q.val();
            self.kept_is_present.d.next = self.next_is_present.q.val();
            for i in 0..self._planes {
                self.kept_plane_kind[i].d.next = self.next_plane_kind[i].q.val();
            }
            self.next_is_present.d.next = false;
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
            if self.address.val() == self.at_box_columns.val() {
                self.next_box_x0.d.next = self.data.val().get_bits::<12>(0);
                self.next_box_x1.d.next = self.data.val().get_bits::<12>(self.second.val().index());
            }
            if self.address.val() == self.at_box_lines.val() {
                self.next_box_y0.d.next = self.data.val().get_bits::<12>(0);
                self.next_box_y1.d.next = self.data.val().get_bits::<12>(self.second.val().index());
            }
            if self.address.val() == self.at_control.val() {
                self.next_object_class.d.next = self.data.val().get_bits::<2>(0);
                self.next_depth_shift.d.next = self
                    .data
                    .val()
                    .get_bits::<4>(self.shift_place.val().index());
                self.next_is_light.d.next = self.data.val().get_bit(self.light_place.val().index());
                self.next_source.d.next = self
                    .data
                    .val()
                    .get_bits::<4>(self.source_place.val().index());
                self.next_is_present.d.next = true;
            }
            if self.address.val() == self.at_margin.val() {
                self.next_margin.d.next = self.data.val().get_bits::<W>(0);
            }
            for i in 0..self._planes {
                if self.address.val() == self.at_plane_kind[i].val() {
                    self.next_plane_kind[i].d.next = self.data.val().get_bits::<2>(0);
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
        self.box_x0.next = self.kept_box_x0.q.val();
        self.box_x1.next = self.kept_box_x1.q.val();
        self.box_y0.next = self.kept_box_y0.q.val();
        self.box_y1.next = self.kept_box_y1.q.val();
        self.object_class.next = self.kept_object_class.q.val();
        self.depth_shift.next = self.kept_depth_shift.q.val();
        self.is_light.next = self.kept_is_light.q.val();
        self.source.next = self.kept_source.q.val();
        self.margin.next = self.kept_margin.q.val();
        self.is_present.next = self.kept_is_present.q.val();
        for i in 0..self._planes {
            self.plane_kind[i].next = self.kept_plane_kind[i].q.val();
            self.plane_a[i].next = self.kept_plane_a[i].q.val();
            self.plane_b[i].next = self.kept_plane_b[i].q.val();
            self.plane_c[i].next = self.kept_plane_c[i].q.val();
        }
    }
}

clocked!(VolumeStore<const W: usize, const S: usize, const F: usize, const P: usize>);
