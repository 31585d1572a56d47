//! Shadow or light volume of a quadric and planes.

use crate::format::MOST_PLANES;
use crate::kernel::*;
use crate::unit::coarse_point::CoarsePoint;
use crate::unit::delay::{FlagDelay, WordDelay};
use crate::unit::half_space_test::HalfSpaceTest;
use crate::unit::pe1::Pe1;
use crate::unit::quadric_pe::QuadricPe;
use crate::unit::quadric_test::QuadricTest;
use crate::unit::screen_box::ScreenBox;
use crate::unit::visible_point::VisiblePoint;

/// Says, for every pixel, whether the visible point lies in a shadow or light volume: a quadric cut by planes.
///
/// A point is in an intersection exactly if it is in every part, so every part is asked by itself: no chain of cuts, no second half.
///
/// Widths: `W1 = W + 1`, `S = W + 2`, `F = 2 W`, `P = W + 12`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line` | in | raster flags |
/// | `x`, `y` | in | 12 bits, pixel of the flags |
/// | `depth` | in | `W` bits, visible depth of the pixel, `ceil(W / rows_per_stage) + 1` clocks after its flags |
/// | `f1_a`, `f1_b`, `f1_c` | in | `S` bits |
/// | `f2_a2`, `f2_b2`, `f2_c`, `f2_i0`, `f2_p0`, `f2_f` | in | `F` bits |
/// | `box_x0`, `box_x1`, `box_y0`, `box_y1` | in | 12 bits, inclusive |
/// | `object_class` | in | 2 bits |
/// | `depth_shift` | in | 4 bits: the quadric's depths are in units of `2^depth_shift` depth words |
/// | `margin` | in | `W` bits, unsigned: counts that a point has to lie behind the beginning; at most half the depth word |
/// | `plane_i_kind` | in | 2 bits |
/// | `plane_i_a`, `plane_i_b`, `plane_i_c` | in | `P` bits |
/// | `out_valid` | out | `valid`, with the result |
/// | `is_inside` | out | the point lies in the volume; the background is in none |
///
/// Latency `ceil(W / rows_per_stage) + 4`. The coefficients stay unchanged from the first flags of a zone until that many clocks after its last.
/// Sections 3.2.1 and 4.1.3.
pub struct QuadricVolume<
    const W: usize,
    const W1: usize,
    const S: usize,
    const F: usize,
    const P: usize,
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
    /// Visible depth.
    pub depth: Signal<In, Int<W>>,
    /// Linear part: increment along the line.
    pub f1_a: Signal<In, Int<S>>,
    /// Linear part: increment from line to line.
    pub f1_b: Signal<In, Int<S>>,
    /// Linear part: value of the first pixel.
    pub f1_c: Signal<In, Int<S>>,
    /// Quadratic: second difference along the line.
    pub f2_a2: Signal<In, Int<F>>,
    /// Quadratic: second difference from line to line.
    pub f2_b2: Signal<In, Int<F>>,
    /// Quadratic: mixed difference.
    pub f2_c: Signal<In, Int<F>>,
    /// Quadratic: increment from the first line to the second.
    pub f2_i0: Signal<In, Int<F>>,
    /// Quadratic: increment from the first pixel to the second.
    pub f2_p0: Signal<In, Int<F>>,
    /// Quadratic: value of the first pixel.
    pub f2_f: Signal<In, Int<F>>,
    /// First column of the screen box.
    pub box_x0: Signal<In, Word<12>>,
    /// Last column of the screen box.
    pub box_x1: Signal<In, Word<12>>,
    /// First line of the screen box.
    pub box_y0: Signal<In, Word<12>>,
    /// Last line of the screen box.
    pub box_y1: Signal<In, Word<12>>,
    /// Class of the quadric.
    pub object_class: Signal<In, Word<2>>,
    /// Places by which the quadric's unit of depth is greater.
    pub depth_shift: Signal<In, Word<4>>,
    /// Counts that a point has to lie behind the beginning.
    pub margin: Signal<In, Word<W>>,
    /// Kind of each plane.
    pub plane_kind: Vec<Signal<In, Word<2>>>,
    /// Each plane: increment along the line.
    pub plane_a: Vec<Signal<In, Int<P>>>,
    /// Each plane: increment from line to line.
    pub plane_b: Vec<Signal<In, Int<P>>>,
    /// Each plane: value of the first pixel.
    pub plane_c: Vec<Signal<In, Int<P>>>,
    /// The result belongs to a pixel.
    pub out_valid: Signal<Out, Bit>,
    /// The point lies in the volume.
    pub is_inside: Signal<Out, Bit>,
    /// Test against the screen box.
    pub screen_box: ScreenBox,
    in_box: WordDelay<Bit>,
    /// The two depths.
    pub quadric: QuadricPe<W, W1, S, F>,
    quadric_test: QuadricTest<W, S>,
    plane_flags: FlagDelay,
    /// The visible point.
    pub point: VisiblePoint<W, S>,
    coarse_point: CoarsePoint<W, S>,
    /// Depth of each plane.
    pub planes: Vec<Pe1<P>>,
    tests: Vec<HalfSpaceTest<W, S, P>>,
    in_all: Signal<Local, Bit>,
    kept: DFF<Bit>,
    valid_delay: WordDelay<Bit>,
    _planes: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize] QuadricVolume [W, W1, S, F, P]
    inputs { clock, valid, start, line, x, y, depth, f1_a, f1_b, f1_c, f2_a2, f2_b2, f2_c, f2_i0,
        f2_p0, f2_f, box_x0, box_x1, box_y0, box_y1, object_class, depth_shift, margin, plane_kind, plane_a,
        plane_b, plane_c }
    parts { out_valid, is_inside, screen_box, in_box, quadric, quadric_test, plane_flags, point, coarse_point,
        planes, tests, in_all, kept, valid_delay }
    data { _planes }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
    QuadricVolume<W, W1, S, F, P>
{
    /// A volume with `planes` planes and `rows_per_stage` rows between the registers of its root network.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other, `planes` exceeds 12 or `rows_per_stage` is not in `1..=W`.
    pub fn new(planes: usize, rows_per_stage: usize) -> Self {
        assert!(
            planes <= MOST_PLANES,
            "a volume has at most {MOST_PLANES} planes"
        );
        let sums = <QuadricPe<W, W1, S, F>>::latency(rows_per_stage);
        fields! {
            [clock, valid, start, line, x, y, depth, f1_a, f1_b, f1_c, f2_a2, f2_b2, f2_c, f2_i0,
                f2_p0, f2_f, box_x0, box_x1, box_y0, box_y1, object_class, depth_shift, margin, out_valid,
                is_inside, screen_box, in_all, kept]
            plane_kind: repeat(planes, Default::default),
            plane_a: repeat(planes, Default::default),
            plane_b: repeat(planes, Default::default),
            plane_c: repeat(planes, Default::default),
            in_box: WordDelay::new(sums + 1),
            quadric: QuadricPe::new(rows_per_stage),
            quadric_test: QuadricTest::new(),
            plane_flags: FlagDelay::new(1),
            point: VisiblePoint::new(),
            coarse_point: CoarsePoint::new(),
            planes: repeat(planes, Pe1::default),
            tests: repeat(planes, HalfSpaceTest::new),
            valid_delay: WordDelay::new(sums + 1 + 1),
            _planes: planes,
        }
    }

    /// Clocks from the flags to the result.
    pub const fn latency(rows_per_stage: usize) -> usize {
        <QuadricPe<W, W1, S, F>>::latency(rows_per_stage) + QuadricTest::<W, S>::latency() + 1
    }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> Logic
    for QuadricVolume<W, W1, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("quadric_volume");
        clock!(
            self,
            clock,
            in_box,
            quadric,
            quadric_test,
            plane_flags,
            point,
            coarse_point,
            kept,
            valid_delay
        );
        self.screen_box.x.next = self.x.val();
        self.screen_box.y.next = self.y.val();
        self.screen_box.box_x0.next = self.box_x0.val();
        self.screen_box.box_x1.next = self.box_x1.val();
        self.screen_box.box_y0.next = self.box_y0.val();
        self.screen_box.box_y1.next = self.box_y1.val();
        self.in_box.word.next = self.screen_box.in_box.val();
        self.point.depth.next = self.depth.val();
        self.point.margin.next = self.margin.val();
        self.coarse_point.depth.next = self.depth.val();
        self.coarse_point.margin.next = self.margin.val();
        self.coarse_point.depth_shift.next = self.depth_shift.val();
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
        self.quadric_test.object_class.next = self.object_class.val();
        self.quadric_test.near_sum.next = self.quadric.near_sum.val();
        self.quadric_test.far_sum.next = self.quadric.far_sum.val();
        self.quadric_test.is_inside.next = self.quadric.is_inside.val();
        self.quadric_test.z.next = self.coarse_point.z.val();
        self.quadric_test.entered.next = self.coarse_point.entered.val();
        self.plane_flags.valid.next = self.quadric.late_valid.val();
        self.plane_flags.start.next = self.quadric.late_start.val();
        self.plane_flags.line.next = self.quadric.late_line.val();
        for i in 0..self._planes {
            self.planes[i].clock.next = self.clock.val();
            self.planes[i].valid.next = self.plane_flags.late_valid.val();
            self.planes[i].start.next = self.plane_flags.late_start.val();
            self.planes[i].line.next = self.plane_flags.late_line.val();
            self.planes[i].a.next = self.plane_a[i].val();
            self.planes[i].b.next = self.plane_b[i].val();
            self.planes[i].c.next = self.plane_c[i].val();
            self.tests[i].clock.next = self.clock.val();
            self.tests[i].kind.next = self.plane_kind[i].val();
            self.tests[i].zp.next = self.planes[i].value.val();
            self.tests[i].z.next = self.point.z.val();
            self.tests[i].entered.next = self.point.entered.val();
        }
        self.in_all.next =
            self.in_box.late.val() & self.point.is_surface.val() & self.quadric_test.holds.val();
        for i in 0..self._planes {
            if !self.tests[i].holds.val() {
                self.in_all.next = false;
            }
        }
        self.kept.d.next = self.in_all.val();
        self.is_inside.next = self.kept.q.val();
        self.valid_delay.word.next = self.valid.val();
        self.out_valid.next = self.valid_delay.late.val();
    }
}

clocked!(QuadricVolume<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>);
