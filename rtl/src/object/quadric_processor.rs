//! Quadric object processor, second generation.

use crate::format::{FIRST_PLANE, MOST_PLANES, PATCH, far_end};
use crate::kernel::*;
use crate::machine::slot_shape::SlotShape;
use crate::unit::cut_plane::CutPlane;
use crate::unit::delay::{FlagDelay, WordDelay};
use crate::unit::depth_interval::DepthInterval;
use crate::unit::normal_unit::NormalUnit;
use crate::unit::plane_depth::PlaneDepth;
use crate::unit::quadric_pe::QuadricPe;
use crate::unit::two_volume_merge::TwoVolumeMerge;

/// Gives, for every pixel, the visible front of one quadric object cut by planes: depth, face and normal.
///
/// Widths: `W1 = W + 1`, `S = W + 2`, `F = 2 W`, `P = W + 12`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line` | in | raster flags |
/// | `x`, `y` | in | 12 bits, pixel of the flags |
/// | `f1_a`, `f1_b`, `f1_c` | in | `S` bits |
/// | `f2_a2`, `f2_b2`, `f2_c`, `f2_i0`, `f2_p0`, `f2_f` | in | `F` bits |
/// | `gx_a` .. `gz_c` | in | 24 bits |
/// | `kx`, `ky`, `kz` | in | 16 bits |
/// | `box_x0`, `box_x1`, `box_y0`, `box_y1` | in | 12 bits, inclusive |
/// | `object_class` | in | 2 bits |
/// | `shift` | in | 5 bits |
/// | `plane_i_kind` | in | 2 bits |
/// | `plane_i_a`, `plane_i_b`, `plane_i_c` | in | `P` bits |
/// | `plane_i_nx`, `plane_i_ny`, `plane_i_nz` | in | 16 bits |
/// | `out_valid` | out | `valid`, with the results |
/// | `zf`, `zb` | out | `W` bits, front and back depth |
/// | `number` | out | 4 bits, face at `zf` |
/// | `nx`, `ny`, `nz` | out | 16 bits |
///
/// Latency `ceil(W / rows_per_stage) + planes + 7`. The coefficients stay unchanged from the first flags of a zone until
/// that many clocks after its last. Section 2.4.2.
///
/// A machine fitted to a scene may have other words: `R` rows of a root of `K` bits (`W1 = R + 1`, `R2 = R + 2`, `F = 2 R`), a PE1 of `E1 = S + g1` and a
/// PE2 of `E2 = 2 K + g2` bits, normals of `N` bits (`N1 = N - 1`, `G = N + 8`); and for objects that are not of class front there is a
/// processor without half B, a clock shorter ([`Self::of_shape`]).
pub struct QuadricProcessor<
    const W: usize,
    const W1: usize,
    const S: usize,
    const F: usize,
    const P: usize,
    const R: usize = W,
    const R2: usize = S,
    const K: usize = W,
    const E1: usize = S,
    const E2: usize = F,
    const N: usize = 16,
    const N1: usize = 15,
    const G: usize = 24,
> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// This clock carries a pixel.
    pub valid: Signal<In, Bit>,
    /// First pixel of the zone.
    pub start: Signal<In, Bit>,
    /// First pixel of a later line.
    pub line: Signal<In, Bit>,
    /// Column.
    pub x: Signal<In, Word<12>>,
    /// Line.
    pub y: Signal<In, Word<12>>,
    /// Linear part: increment along the line.
    pub f1_a: Signal<In, Int<E1>>,
    /// Linear part: increment from line to line.
    pub f1_b: Signal<In, Int<E1>>,
    /// Linear part: value of the first pixel.
    pub f1_c: Signal<In, Int<E1>>,
    /// Quadratic: second difference along the line.
    pub f2_a2: Signal<In, Int<E2>>,
    /// Quadratic: second difference from line to line.
    pub f2_b2: Signal<In, Int<E2>>,
    /// Quadratic: mixed difference.
    pub f2_c: Signal<In, Int<E2>>,
    /// Quadratic: increment from the first line to the second.
    pub f2_i0: Signal<In, Int<E2>>,
    /// Quadratic: increment from the first pixel to the second.
    pub f2_p0: Signal<In, Int<E2>>,
    /// Quadratic: value of the first pixel.
    pub f2_f: Signal<In, Int<E2>>,
    /// Normal x: increment along the line.
    pub gx_a: Signal<In, Int<G>>,
    /// Normal x: increment from line to line.
    pub gx_b: Signal<In, Int<G>>,
    /// Normal x: value of the first pixel.
    pub gx_c: Signal<In, Int<G>>,
    /// Normal y: increment along the line.
    pub gy_a: Signal<In, Int<G>>,
    /// Normal y: increment from line to line.
    pub gy_b: Signal<In, Int<G>>,
    /// Normal y: value of the first pixel.
    pub gy_c: Signal<In, Int<G>>,
    /// Normal z: increment along the line.
    pub gz_a: Signal<In, Int<G>>,
    /// Normal z: increment from line to line.
    pub gz_b: Signal<In, Int<G>>,
    /// Normal z: value of the first pixel.
    pub gz_c: Signal<In, Int<G>>,
    /// Factor of the root in normal x.
    pub kx: Signal<In, Int<N>>,
    /// Factor of the root in normal y.
    pub ky: Signal<In, Int<N>>,
    /// Factor of the root in normal z.
    pub kz: Signal<In, Int<N>>,
    /// First column of the screen box.
    pub box_x0: Signal<In, Word<12>>,
    /// Last column of the screen box.
    pub box_x1: Signal<In, Word<12>>,
    /// First line of the screen box.
    pub box_y0: Signal<In, Word<12>>,
    /// Last line of the screen box.
    pub box_y1: Signal<In, Word<12>>,
    /// Class of the object.
    pub object_class: Signal<In, Word<2>>,
    /// Places the root is shifted for the normal.
    pub shift: Signal<In, Word<5>>,
    /// Kind of each plane.
    pub plane_kind: Vec<Signal<In, Word<2>>>,
    /// Each plane: increment along the line.
    pub plane_a: Vec<Signal<In, Int<P>>>,
    /// Each plane: increment from line to line.
    pub plane_b: Vec<Signal<In, Int<P>>>,
    /// Each plane: value of the first pixel.
    pub plane_c: Vec<Signal<In, Int<P>>>,
    /// Each plane: normal x.
    pub plane_nx: Vec<Signal<In, Int<N>>>,
    /// Each plane: normal y.
    pub plane_ny: Vec<Signal<In, Int<N>>>,
    /// Each plane: normal z.
    pub plane_nz: Vec<Signal<In, Int<N>>>,
    /// The results belong to a pixel.
    pub out_valid: Signal<Out, Bit>,
    /// Front depth.
    pub zf: Signal<Out, Int<W>>,
    /// Back depth.
    pub zb: Signal<Out, Int<W>>,
    /// Front face.
    pub number: Signal<Out, Word<4>>,
    /// Normal x.
    pub nx: Signal<Out, Int<N>>,
    /// Normal y.
    pub ny: Signal<Out, Int<N>>,
    /// Normal z.
    pub nz: Signal<Out, Int<N>>,
    right_of_x0: Signal<Local, Bit>,
    left_of_x1: Signal<Local, Bit>,
    below_y0: Signal<Local, Bit>,
    above_y1: Signal<Local, Bit>,
    /// The pixel lies in the screen box; as late as the depth sums.
    pub in_box: WordDelay<Bit>,
    /// The two depths.
    pub quadric: QuadricPe<R, W1, R2, F, S, E1, E2, K>,
    /// The interval before the cuts.
    pub interval: DepthInterval<W, S>,
    plane_flags: Vec<FlagDelay>,
    /// Depth of each plane.
    pub planes: Vec<PlaneDepth<W, P>>,
    /// Half A after each plane.
    pub cut_a: Vec<CutPlane<W>>,
    /// Half B after each plane.
    pub cut_b: Vec<CutPlane<W>>,
    /// The half in front.
    pub merge: Optional<TwoVolumeMerge<W>>,
    normal_flags: FlagDelay,
    root_delay: WordDelay<Word<K>>,
    /// The normal.
    pub normal: NormalUnit<K, N, N1, G>,
    valid_delay: WordDelay<Bit>,
    zf_delay: WordDelay<Int<W>>,
    zb_delay: WordDelay<Int<W>>,
    number_delay: WordDelay<Word<4>>,
    surface: Signal<Local, Bit>,
    patch: Constant<Word<2>>,
    absent: Constant<Int<W>>,
    plane_number: Vec<Constant<Word<4>>>,
    _first: usize,
    _planes: usize,
    _first_back: usize,
    _back: usize,
    _two_volumes: usize,
    _one_volume: usize,
    _alone: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize, const R: usize, const R2: usize, const K: usize, const E1: usize, const E2: usize, const N: usize, const N1: usize, const G: usize]
    QuadricProcessor [W, W1, S, F, P, R, R2, K, E1, E2, N, N1, G]
    inputs { clock, valid, start, line, x, y, f1_a, f1_b, f1_c, f2_a2, f2_b2, f2_c, f2_i0, f2_p0,
        f2_f, gx_a, gx_b, gx_c, gy_a, gy_b, gy_c, gz_a, gz_b, gz_c, kx, ky, kz, box_x0, box_x1,
        box_y0, box_y1, object_class, shift, plane_kind, plane_a, plane_b, plane_c, plane_nx,
        plane_ny, plane_nz }
    parts { out_valid, zf, zb, number, nx, ny, nz, right_of_x0, left_of_x1, below_y0, above_y1,
        in_box, quadric, interval, plane_flags, planes, cut_a, cut_b, merge, normal_flags,
        root_delay, normal, valid_delay, zf_delay, zb_delay, number_delay, surface, patch, absent,
        plane_number }
    data { _first, _planes, _first_back, _back, _two_volumes, _one_volume, _alone }
}

impl<
    const W: usize,
    const W1: usize,
    const S: usize,
    const F: usize,
    const P: usize,
    const R: usize,
    const R2: usize,
    const K: usize,
    const E1: usize,
    const E2: usize,
    const N: usize,
    const N1: usize,
    const G: usize,
> QuadricProcessor<W, W1, S, F, P, R, R2, K, E1, E2, N, N1, G>
{
    /// A processor with `planes` cut planes and `rows_per_stage` rows between the registers of its root network.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other, `planes` exceeds 12 or `rows_per_stage` is not in `1..=W`.
    pub fn new(planes: usize, rows_per_stage: usize) -> Self {
        Self::of_shape(&SlotShape::full(planes), rows_per_stage)
    }

    /// A processor of a shape. Without half B, for objects that are not of class front, it has no merge and is a clock shorter.
    ///
    /// # Panics
    ///
    /// As [`Self::new`].
    pub fn of_shape(shape: &SlotShape, rows_per_stage: usize) -> Self {
        let SlotShape {
            planes,
            two_volumes,
        } = *shape;
        assert!(
            planes <= MOST_PLANES,
            "an object has at most {MOST_PLANES} planes"
        );
        let halves = usize::from(two_volumes);
        let sums = QuadricPe::<R, W1, R2, F, S, E1, E2, K>::latency(rows_per_stage);
        let normal = NormalUnit::<K, N, N1, G>::latency();
        Self {
            clock: Signal::default(),
            valid: Signal::default(),
            start: Signal::default(),
            line: Signal::default(),
            x: Signal::default(),
            y: Signal::default(),
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
            out_valid: Signal::default(),
            zf: Signal::default(),
            zb: Signal::default(),
            number: Signal::default(),
            nx: Signal::default(),
            ny: Signal::default(),
            nz: Signal::default(),
            right_of_x0: Signal::default(),
            left_of_x1: Signal::default(),
            below_y0: Signal::default(),
            above_y1: Signal::default(),
            in_box: WordDelay::new(sums),
            quadric: QuadricPe::new(rows_per_stage),
            interval: DepthInterval::new(),
            plane_flags: repeat(planes, || FlagDelay::new(1)),
            planes: repeat(planes, PlaneDepth::new),
            cut_a: repeat(planes, CutPlane::new),
            cut_b: repeat(planes * halves, CutPlane::new),
            merge: Optional::new(TwoVolumeMerge::default(), two_volumes),
            normal_flags: FlagDelay::new(3 + halves),
            root_delay: WordDelay::new(planes + 1 + halves),
            normal: NormalUnit::new(planes),
            valid_delay: WordDelay::new(normal),
            zf_delay: WordDelay::new(normal),
            zb_delay: WordDelay::new(normal),
            number_delay: WordDelay::new(normal),
            surface: Signal::default(),
            patch: constant(PATCH),
            absent: signed_constant(far_end(W)),
            plane_number: (0..planes as u64)
                .map(|i| constant(FIRST_PLANE + i))
                .collect(),
            _first: planes.min(1),
            _planes: planes,
            _first_back: planes.min(1) * halves,
            _back: planes * halves,
            _two_volumes: halves,
            _one_volume: 1 - halves,
            _alone: planes * (1 - halves),
            _asleep: false,
        }
    }

    /// Clocks from the flags to the results.
    pub const fn latency(planes: usize, rows_per_stage: usize) -> usize {
        QuadricPe::<R, W1, R2, F, S, E1, E2, K>::latency(rows_per_stage)
            + DepthInterval::<W, S>::latency()
            + planes * CutPlane::<W>::latency()
            + TwoVolumeMerge::<W>::latency()
            + NormalUnit::<K, N, N1, G>::latency()
    }

    /// Clocks from the flags to the results of a processor of a shape.
    pub const fn latency_of(shape: &SlotShape, rows_per_stage: usize) -> usize {
        Self::latency(shape.planes, rows_per_stage) - !shape.two_volumes as usize
    }
}

impl<
    const W: usize,
    const W1: usize,
    const S: usize,
    const F: usize,
    const P: usize,
    const R: usize,
    const R2: usize,
    const K: usize,
    const E1: usize,
    const E2: usize,
    const N: usize,
    const N1: usize,
    const G: usize,
> Logic for QuadricProcessor<W, W1, S, F, P, R, R2, K, E1, E2, N, N1, G>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("quadric_processor");
        clock!(
            self,
            clock,
            in_box,
            quadric,
            interval,
            normal_flags,
            root_delay,
            normal,
            valid_delay,
            zf_delay,
            zb_delay,
            number_delay
        );
        self.right_of_x0.next = self.x.val() >= self.box_x0.val();
        self.left_of_x1.next = self.x.val() <= self.box_x1.val();
        self.below_y0.next = self.y.val() >= self.box_y0.val();
        self.above_y1.next = self.y.val() <= self.box_y1.val();
        self.in_box.word.next = self.right_of_x0.val()
            & self.left_of_x1.val()
            & self.below_y0.val()
            & self.above_y1.val();
        self.quadric.valid.next = self.valid.val();
        self.quadric.start.next = self.start.val();
        self.quadric.line.next = self.line.val();
        self.quadric.f1_a.next = self.f1_a.val();
        self.quadric.f1_b.next = self.f1_b.val();
        self.quadric.f1_c.next = self.f1_c.val();
        self.quadric.f2_a2.next = self.f2_a2.val();
        self.quadric.f2_b2.next = self.f2_b2.val();
        self.quadric.f2_c.next = self.f2_c.val();
        self.quadric.f2_i0.next = self.f2_i0.val();
        self.quadric.f2_p0.next = self.f2_p0.val();
        self.quadric.f2_f.next = self.f2_f.val();
        self.interval.near_sum.next = self.quadric.near_sum.val();
        self.interval.far_sum.next = self.quadric.far_sum.val();
        self.interval.is_inside.next = self.quadric.is_inside.val();
        self.interval.in_box.next = self.in_box.late.val();
        self.interval.object_class.next = self.object_class.val();
        self.surface.next = self.object_class.val() == self.patch.val();
        for i in 0..self._first {
            self.plane_flags[i].valid.next = self.quadric.late_valid.val();
            self.plane_flags[i].start.next = self.quadric.late_start.val();
            self.plane_flags[i].line.next = self.quadric.late_line.val();
            self.cut_a[i].zf.next = self.interval.zf_a.val();
            self.cut_a[i].nf.next = self.interval.nf_a.val();
            self.cut_a[i].zb.next = self.interval.zb_a.val();
            self.cut_a[i].nb.next = self.interval.nb_a.val();
        }
        for i in 0..self._first_back {
            self.cut_b[i].zf.next = self.interval.zf_b.val();
            self.cut_b[i].nf.next = self.interval.nf_b.val();
            self.cut_b[i].zb.next = self.interval.zb_b.val();
            self.cut_b[i].nb.next = self.interval.nb_b.val();
        }
        for i in 1..self._planes {
            self.plane_flags[i].valid.next = self.plane_flags[i - 1].late_valid.val();
            self.plane_flags[i].start.next = self.plane_flags[i - 1].late_start.val();
            self.plane_flags[i].line.next = self.plane_flags[i - 1].late_line.val();
            self.cut_a[i].zf.next = self.cut_a[i - 1].cut_zf.val();
            self.cut_a[i].nf.next = self.cut_a[i - 1].cut_nf.val();
            self.cut_a[i].zb.next = self.cut_a[i - 1].cut_zb.val();
            self.cut_a[i].nb.next = self.cut_a[i - 1].cut_nb.val();
        }
        for i in 1..self._back {
            self.cut_b[i].zf.next = self.cut_b[i - 1].cut_zf.val();
            self.cut_b[i].nf.next = self.cut_b[i - 1].cut_nf.val();
            self.cut_b[i].zb.next = self.cut_b[i - 1].cut_zb.val();
            self.cut_b[i].nb.next = self.cut_b[i - 1].cut_nb.val();
        }
        for i in 0..self._planes {
            self.plane_flags[i].clock.next = self.clock.val();
            self.planes[i].clock.next = self.clock.val();
            self.planes[i].valid.next = self.plane_flags[i].late_valid.val();
            self.planes[i].start.next = self.plane_flags[i].late_start.val();
            self.planes[i].line.next = self.plane_flags[i].late_line.val();
            self.planes[i].a.next = self.plane_a[i].val();
            self.planes[i].b.next = self.plane_b[i].val();
            self.planes[i].c.next = self.plane_c[i].val();
            self.cut_a[i].clock.next = self.clock.val();
            self.cut_a[i].kind.next = self.plane_kind[i].val();
            self.cut_a[i].surface.next = self.surface.val();
            self.cut_a[i].number.next = self.plane_number[i].val();
            self.cut_a[i].zp.next = self.planes[i].depth.val();
            self.normal.plane_nx[i].next = self.plane_nx[i].val();
            self.normal.plane_ny[i].next = self.plane_ny[i].val();
            self.normal.plane_nz[i].next = self.plane_nz[i].val();
        }
        for i in 0..self._back {
            self.cut_b[i].clock.next = self.clock.val();
            self.cut_b[i].kind.next = self.plane_kind[i].val();
            self.cut_b[i].surface.next = self.surface.val();
            self.cut_b[i].number.next = self.plane_number[i].val();
            self.cut_b[i].zp.next = self.planes[i].depth.val();
        }
        // Without planes the interval goes straight on; otherwise the last assignment, that of the last plane, holds.
        self.normal_flags.valid.next = self.quadric.late_valid.val();
        self.normal_flags.start.next = self.quadric.late_start.val();
        self.normal_flags.line.next = self.quadric.late_line.val();
        for i in 0..self._planes {
            self.normal_flags.valid.next = self.plane_flags[i].late_valid.val();
            self.normal_flags.start.next = self.plane_flags[i].late_start.val();
            self.normal_flags.line.next = self.plane_flags[i].late_line.val();
        }
        for _i in 0..self._two_volumes {
            self.merge.clock.next = self.clock.val();
            self.merge.zf_a.next = self.interval.zf_a.val();
            self.merge.nf_a.next = self.interval.nf_a.val();
            self.merge.zb_a.next = self.interval.zb_a.val();
            self.merge.nb_a.next = self.interval.nb_a.val();
            self.merge.zf_b.next = self.interval.zf_b.val();
            self.merge.nf_b.next = self.interval.nf_b.val();
            self.merge.zb_b.next = self.interval.zb_b.val();
            self.merge.nb_b.next = self.interval.nb_b.val();
        }
        for i in 0..self._back {
            self.merge.zf_a.next = self.cut_a[i].cut_zf.val();
            self.merge.nf_a.next = self.cut_a[i].cut_nf.val();
            self.merge.zb_a.next = self.cut_a[i].cut_zb.val();
            self.merge.nb_a.next = self.cut_a[i].cut_nb.val();
            self.merge.zf_b.next = self.cut_b[i].cut_zf.val();
            self.merge.nf_b.next = self.cut_b[i].cut_nf.val();
            self.merge.zb_b.next = self.cut_b[i].cut_zb.val();
            self.merge.nb_b.next = self.cut_b[i].cut_nb.val();
        }
        self.root_delay.word.next = self.quadric.root.val();
        self.normal.valid.next = self.normal_flags.late_valid.val();
        self.normal.start.next = self.normal_flags.late_start.val();
        self.normal.line.next = self.normal_flags.late_line.val();
        self.normal.root.next = self.root_delay.late.val();
        self.normal.shift.next = self.shift.val();
        self.normal.gx_a.next = self.gx_a.val();
        self.normal.gx_b.next = self.gx_b.val();
        self.normal.gx_c.next = self.gx_c.val();
        self.normal.gy_a.next = self.gy_a.val();
        self.normal.gy_b.next = self.gy_b.val();
        self.normal.gy_c.next = self.gy_c.val();
        self.normal.gz_a.next = self.gz_a.val();
        self.normal.gz_b.next = self.gz_b.val();
        self.normal.gz_c.next = self.gz_c.val();
        self.normal.kx.next = self.kx.val();
        self.normal.ky.next = self.ky.val();
        self.normal.kz.next = self.kz.val();
        self.valid_delay.word.next = self.normal_flags.late_valid.val();
        for _i in 0..self._two_volumes {
            self.normal.number.next = self.merge.nf.val();
            self.normal.absent.next = self.merge.zf.val() == self.absent.val();
            self.zf_delay.word.next = self.merge.zf.val();
            self.zb_delay.word.next = self.merge.zb.val();
            self.number_delay.word.next = self.merge.nf.val();
        }
        for _i in 0..self._one_volume {
            self.normal.number.next = self.interval.nf_a.val();
            self.normal.absent.next = self.interval.zf_a.val() == self.absent.val();
            self.zf_delay.word.next = self.interval.zf_a.val();
            self.zb_delay.word.next = self.interval.zb_a.val();
            self.number_delay.word.next = self.interval.nf_a.val();
        }
        for i in 0..self._alone {
            self.normal.number.next = self.cut_a[i].cut_nf.val();
            self.normal.absent.next = self.cut_a[i].cut_zf.val() == self.absent.val();
            self.zf_delay.word.next = self.cut_a[i].cut_zf.val();
            self.zb_delay.word.next = self.cut_a[i].cut_zb.val();
            self.number_delay.word.next = self.cut_a[i].cut_nf.val();
        }
        self.out_valid.next = self.valid_delay.late.val();
        self.zf.next = self.zf_delay.late.val();
        self.zb.next = self.zb_delay.late.val();
        self.number.next = self.number_delay.late.val();
        self.nx.next = self.normal.nx.val();
        self.ny.next = self.normal.ny.val();
        self.nz.next = self.normal.nz.val();
    }
}

clocked!(QuadricProcessor<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize, const R: usize, const R2: usize, const K: usize, const E1: usize, const E2: usize, const N: usize, const N1: usize, const G: usize>);
