//! Patch object processor.

use crate::format::{MOST_PLANES, far_end};
use crate::kernel::*;
use crate::unit::delay::{FlagDelay, WordDelay};
use crate::unit::normal_unit::NormalUnit;
use crate::unit::patch_decider::PatchDecider;
use crate::unit::plane_depth::PlaneDepth;
use crate::unit::quadric_pe::QuadricPe;
use crate::unit::screen_box::ScreenBox;

/// Gives, for every pixel, the visible face of a bare quadric surface cut by planes: depth, face and normal.
///
/// The planes decide in parallel, so the latency does not depend on their number, and there is neither a second half of the depth
/// interval nor a merge nor a normal of a plane. What comes out is what the quadric processor gives for class patch.
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
/// | `shift` | in | 5 bits |
/// | `plane_i_kind` | in | 2 bits |
/// | `plane_i_a`, `plane_i_b`, `plane_i_c` | in | `P` bits |
/// | `out_valid` | out | `valid`, with the results |
/// | `zf`, `zb` | out | `W` bits, front and back depth |
/// | `number` | out | 4 bits, face at `zf` |
/// | `nx`, `ny`, `nz` | out | 16 bits |
///
/// Latency `ceil(W / rows_per_stage) + 7`. The coefficients stay unchanged from the first flags of a zone until that many clocks
/// after its last. Sections 2.4.3 and 5.2.1.
pub struct PatchProcessor<
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
    /// Normal x: increment along the line.
    pub gx_a: Signal<In, Int<24>>,
    /// Normal x: increment from line to line.
    pub gx_b: Signal<In, Int<24>>,
    /// Normal x: value of the first pixel.
    pub gx_c: Signal<In, Int<24>>,
    /// Normal y: increment along the line.
    pub gy_a: Signal<In, Int<24>>,
    /// Normal y: increment from line to line.
    pub gy_b: Signal<In, Int<24>>,
    /// Normal y: value of the first pixel.
    pub gy_c: Signal<In, Int<24>>,
    /// Normal z: increment along the line.
    pub gz_a: Signal<In, Int<24>>,
    /// Normal z: increment from line to line.
    pub gz_b: Signal<In, Int<24>>,
    /// Normal z: value of the first pixel.
    pub gz_c: Signal<In, Int<24>>,
    /// Factor of the root in normal x.
    pub kx: Signal<In, Int<16>>,
    /// Factor of the root in normal y.
    pub ky: Signal<In, Int<16>>,
    /// Factor of the root in normal z.
    pub kz: Signal<In, Int<16>>,
    /// First column of the screen box.
    pub box_x0: Signal<In, Word<12>>,
    /// Last column of the screen box.
    pub box_x1: Signal<In, Word<12>>,
    /// First line of the screen box.
    pub box_y0: Signal<In, Word<12>>,
    /// Last line of the screen box.
    pub box_y1: Signal<In, Word<12>>,
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
    /// The results belong to a pixel.
    pub out_valid: Signal<Out, Bit>,
    /// Front depth.
    pub zf: Signal<Out, Int<W>>,
    /// Back depth.
    pub zb: Signal<Out, Int<W>>,
    /// Visible face.
    pub number: Signal<Out, Word<4>>,
    /// Normal x.
    pub nx: Signal<Out, Int<16>>,
    /// Normal y.
    pub ny: Signal<Out, Int<16>>,
    /// Normal z.
    pub nz: Signal<Out, Int<16>>,
    /// Test against the screen box.
    pub screen_box: ScreenBox,
    in_box: WordDelay<Bit>,
    /// The two depths.
    pub quadric: QuadricPe<W, W1, S, F>,
    /// Depth of each plane.
    pub planes: Vec<PlaneDepth<W, P>>,
    /// The face that all planes keep.
    pub decider: PatchDecider<W, S>,
    normal_flags: FlagDelay,
    root_delay: WordDelay<Word<W>>,
    /// The normal.
    pub normal: NormalUnit<W>,
    valid_delay: WordDelay<Bit>,
    zf_delay: WordDelay<Int<W>>,
    zb_delay: WordDelay<Int<W>>,
    number_delay: WordDelay<Word<4>>,
    absent: Constant<Int<W>>,
    _planes: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize] PatchProcessor [W, W1, S, F, P]
    inputs { clock, valid, start, line, x, y, f1_a, f1_b, f1_c, f2_a2, f2_b2, f2_c, f2_i0, f2_p0,
        f2_f, gx_a, gx_b, gx_c, gy_a, gy_b, gy_c, gz_a, gz_b, gz_c, kx, ky, kz, box_x0, box_x1,
        box_y0, box_y1, shift, plane_kind, plane_a, plane_b, plane_c }
    parts { out_valid, zf, zb, number, nx, ny, nz, screen_box, in_box, quadric, planes, decider,
        normal_flags, root_delay, normal, valid_delay, zf_delay, zb_delay, number_delay, absent }
    data { _planes }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
    PatchProcessor<W, W1, S, F, P>
{
    /// A processor with `planes` cut planes and `rows_per_stage` rows between the registers of its root network.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other, `planes` exceeds 12 or `rows_per_stage` is not in `1..=W`.
    pub fn new(planes: usize, rows_per_stage: usize) -> Self {
        assert!(
            planes <= MOST_PLANES,
            "an object has at most {MOST_PLANES} planes"
        );
        let sums = <QuadricPe<W, W1, S, F>>::latency(rows_per_stage);
        let normal = <NormalUnit<W>>::latency();
        fields! {
            [clock, valid, start, line, x, y, f1_a, f1_b, f1_c, f2_a2, f2_b2, f2_c, f2_i0, f2_p0,
                f2_f, gx_a, gx_b, gx_c, gy_a, gy_b, gy_c, gz_a, gz_b, gz_c, kx, ky, kz, box_x0,
                box_x1, box_y0, box_y1, shift, out_valid, zf, zb, number, nx, ny, nz, screen_box]
            plane_kind: repeat(planes, Default::default),
            plane_a: repeat(planes, Default::default),
            plane_b: repeat(planes, Default::default),
            plane_c: repeat(planes, Default::default),
            in_box: WordDelay::new(sums),
            quadric: QuadricPe::new(rows_per_stage),
            planes: repeat(planes, PlaneDepth::new),
            decider: PatchDecider::new(planes),
            normal_flags: FlagDelay::new(4),
            root_delay: WordDelay::new(PatchDecider::<W, S>::latency()),
            normal: NormalUnit::new(0),
            valid_delay: WordDelay::new(normal),
            zf_delay: WordDelay::new(normal),
            zb_delay: WordDelay::new(normal),
            number_delay: WordDelay::new(normal),
            absent: signed_constant(far_end(W)),
            _planes: planes,
        }
    }

    /// Clocks from the flags to the results.
    pub const fn latency(rows_per_stage: usize) -> usize {
        <QuadricPe<W, W1, S, F>>::latency(rows_per_stage)
            + PatchDecider::<W, S>::latency()
            + <NormalUnit<W>>::latency()
    }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> Logic
    for PatchProcessor<W, W1, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("patch_processor");
        clock!(
            self,
            clock,
            in_box,
            quadric,
            decider,
            normal_flags,
            root_delay,
            normal,
            valid_delay,
            zf_delay,
            zb_delay,
            number_delay
        );
        self.screen_box.x.next = self.x.val();
        self.screen_box.y.next = self.y.val();
        self.screen_box.box_x0.next = self.box_x0.val();
        self.screen_box.box_x1.next = self.box_x1.val();
        self.screen_box.box_y0.next = self.box_y0.val();
        self.screen_box.box_y1.next = self.box_y1.val();
        self.in_box.word.next = self.screen_box.in_box.val();
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
        self.decider.near_sum.next = self.quadric.near_sum.val();
        self.decider.far_sum.next = self.quadric.far_sum.val();
        self.decider.is_inside.next = self.quadric.is_inside.val();
        self.decider.in_box.next = self.in_box.late.val();
        // The flags that the quadric core hands on bring the planes beside its sums.
        for i in 0..self._planes {
            self.planes[i].clock.next = self.clock.val();
            self.planes[i].valid.next = self.quadric.late_valid.val();
            self.planes[i].start.next = self.quadric.late_start.val();
            self.planes[i].line.next = self.quadric.late_line.val();
            self.planes[i].a.next = self.plane_a[i].val();
            self.planes[i].b.next = self.plane_b[i].val();
            self.planes[i].c.next = self.plane_c[i].val();
            self.decider.plane_kind[i].next = self.plane_kind[i].val();
            self.decider.plane_zp[i].next = self.planes[i].depth.val();
        }
        self.normal_flags.valid.next = self.quadric.late_valid.val();
        self.normal_flags.start.next = self.quadric.late_start.val();
        self.normal_flags.line.next = self.quadric.late_line.val();
        self.root_delay.word.next = self.quadric.root.val();
        self.normal.valid.next = self.normal_flags.late_valid.val();
        self.normal.start.next = self.normal_flags.late_start.val();
        self.normal.line.next = self.normal_flags.late_line.val();
        self.normal.number.next = self.decider.number.val();
        self.normal.absent.next = self.decider.zf.val() == self.absent.val();
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
        self.zf_delay.word.next = self.decider.zf.val();
        self.zb_delay.word.next = self.decider.zb.val();
        self.number_delay.word.next = self.decider.number.val();
        self.out_valid.next = self.valid_delay.late.val();
        self.zf.next = self.zf_delay.late.val();
        self.zb.next = self.zb_delay.late.val();
        self.number.next = self.number_delay.late.val();
        self.nx.next = self.normal.nx.val();
        self.ny.next = self.normal.ny.val();
        self.nz.next = self.normal.nz.val();
    }
}

clocked!(PatchProcessor<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>);
