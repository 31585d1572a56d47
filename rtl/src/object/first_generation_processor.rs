//! Quadric object processor, first generation.

use crate::format::far_end;
use crate::kernel::*;
use crate::unit::contour_choice::ContourChoice;
use crate::unit::delay::{FlagDelay, WordDelay};
use crate::unit::normal_unit::NormalUnit;
use crate::unit::pe1::Pe1;
use crate::unit::pe2::Pe2;
use crate::unit::plane_depth::PlaneDepth;
use crate::unit::quadric_pe::QuadricPe;
use crate::unit::screen_box::ScreenBox;

/// Gives, for every pixel, the visible face of a quadric seen from outside between two parallel planes, found by contours on the screen.
///
/// Kept as the reference for the second generation: no depth is compared with another; the signs of two conics and two lines decide.
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
/// | `surface` | in | the surface alone, not the solid |
/// | `depth_i_a`, `depth_i_b`, `depth_i_c` | in | `P` bits, depth of the front (0) and the back (1) plane |
/// | `conic_i_a2` .. `conic_i_f` | in | `F` bits, not negative where plane i is inside the quadric |
/// | `polar_i_a`, `polar_i_b`, `polar_i_c` | in | `P` bits, negative where the middle of the quadric is on the removed side of plane i |
/// | `plane_i_nx`, `plane_i_ny`, `plane_i_nz` | in | 16 bits, normal of plane i |
/// | `out_valid` | out | `valid`, with the results |
/// | `zf`, `zb` | out | `W` bits, front and back depth |
/// | `number` | out | 4 bits, face at `zf` |
/// | `nx`, `ny`, `nz` | out | 16 bits |
///
/// Latency `ceil(W / rows_per_stage) + 6`. The coefficients stay unchanged from the first flags of a zone until that many clocks
/// after its last. Section 2.4.1, its algorithm corrected.
pub struct FirstGenerationProcessor<
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
    /// The surface alone.
    pub surface: Signal<In, Bit>,
    /// Front and back plane: increment along the line.
    pub depth_a: Vec<Signal<In, Int<P>>>,
    /// Front and back plane: increment from line to line.
    pub depth_b: Vec<Signal<In, Int<P>>>,
    /// Front and back plane: value of the first pixel.
    pub depth_c: Vec<Signal<In, Int<P>>>,
    /// Conic of each plane: second difference along the line.
    pub conic_a2: Vec<Signal<In, Int<F>>>,
    /// Conic of each plane: second difference from line to line.
    pub conic_b2: Vec<Signal<In, Int<F>>>,
    /// Conic of each plane: mixed difference.
    pub conic_c: Vec<Signal<In, Int<F>>>,
    /// Conic of each plane: increment from the first line to the second.
    pub conic_i0: Vec<Signal<In, Int<F>>>,
    /// Conic of each plane: increment from the first pixel to the second.
    pub conic_p0: Vec<Signal<In, Int<F>>>,
    /// Conic of each plane: value of the first pixel.
    pub conic_f: Vec<Signal<In, Int<F>>>,
    /// Polar line of each plane: increment along the line.
    pub polar_a: Vec<Signal<In, Int<P>>>,
    /// Polar line of each plane: increment from line to line.
    pub polar_b: Vec<Signal<In, Int<P>>>,
    /// Polar line of each plane: value of the first pixel.
    pub polar_c: Vec<Signal<In, Int<P>>>,
    /// Each plane: normal x.
    pub plane_nx: Vec<Signal<In, Int<16>>>,
    /// Each plane: normal y.
    pub plane_ny: Vec<Signal<In, Int<16>>>,
    /// Each plane: normal z.
    pub plane_nz: Vec<Signal<In, Int<16>>>,
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
    pub depths: Vec<PlaneDepth<W, P>>,
    /// Conic of each plane.
    pub conics: Vec<Pe2<F>>,
    /// Polar line of each plane.
    pub polars: Vec<Pe1<P>>,
    front_inside: DFF<Bit>,
    back_inside: DFF<Bit>,
    front_middle: DFF<Bit>,
    back_middle: DFF<Bit>,
    /// The faces that the contours leave.
    pub choice: ContourChoice<W, S>,
    normal_flags: FlagDelay,
    root_delay: WordDelay<Word<W>>,
    /// The normal.
    pub normal: NormalUnit<W>,
    valid_delay: WordDelay<Bit>,
    zf_delay: WordDelay<Int<W>>,
    zb_delay: WordDelay<Int<W>>,
    number_delay: WordDelay<Word<4>>,
    absent: Constant<Int<W>>,
    conic_sign: Constant<Word<8>>,
    polar_sign: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize] FirstGenerationProcessor [W, W1, S, F, P]
    inputs { clock, valid, start, line, x, y, f1_a, f1_b, f1_c, f2_a2, f2_b2, f2_c, f2_i0, f2_p0,
        f2_f, gx_a, gx_b, gx_c, gy_a, gy_b, gy_c, gz_a, gz_b, gz_c, kx, ky, kz, box_x0, box_x1,
        box_y0, box_y1, shift, surface, depth_a, depth_b, depth_c, conic_a2, conic_b2, conic_c,
        conic_i0, conic_p0, conic_f, polar_a, polar_b, polar_c, plane_nx, plane_ny, plane_nz }
    parts { out_valid, zf, zb, number, nx, ny, nz, screen_box, in_box, quadric, depths, conics,
        polars, front_inside, back_inside, front_middle, back_middle, choice, normal_flags,
        root_delay, normal, valid_delay, zf_delay, zb_delay, number_delay, absent, conic_sign,
        polar_sign }
    data { }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
    FirstGenerationProcessor<W, W1, S, F, P>
{
    /// A processor with `rows_per_stage` rows between the registers of its root network.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or `rows_per_stage` is not in `1..=W`.
    pub fn new(rows_per_stage: usize) -> Self {
        let sums = <QuadricPe<W, W1, S, F>>::latency(rows_per_stage);
        let normal = <NormalUnit<W>>::latency();
        fields! {
            [clock, valid, start, line, x, y, f1_a, f1_b, f1_c, f2_a2, f2_b2, f2_c, f2_i0, f2_p0,
                f2_f, gx_a, gx_b, gx_c, gy_a, gy_b, gy_c, gz_a, gz_b, gz_c, kx, ky, kz, box_x0,
                box_x1, box_y0, box_y1, shift, surface, out_valid, zf, zb, number, nx, ny, nz,
                screen_box, front_inside, back_inside, front_middle, back_middle]
            depth_a: repeat(2, Default::default),
            depth_b: repeat(2, Default::default),
            depth_c: repeat(2, Default::default),
            conic_a2: repeat(2, Default::default),
            conic_b2: repeat(2, Default::default),
            conic_c: repeat(2, Default::default),
            conic_i0: repeat(2, Default::default),
            conic_p0: repeat(2, Default::default),
            conic_f: repeat(2, Default::default),
            polar_a: repeat(2, Default::default),
            polar_b: repeat(2, Default::default),
            polar_c: repeat(2, Default::default),
            plane_nx: repeat(2, Default::default),
            plane_ny: repeat(2, Default::default),
            plane_nz: repeat(2, Default::default),
            in_box: WordDelay::new(sums),
            quadric: QuadricPe::new(rows_per_stage),
            depths: repeat(2, PlaneDepth::new),
            conics: repeat(2, Default::default),
            polars: repeat(2, Default::default),
            choice: ContourChoice::new(),
            normal_flags: FlagDelay::new(3),
            root_delay: WordDelay::new(ContourChoice::<W, S>::latency()),
            normal: NormalUnit::new(2),
            valid_delay: WordDelay::new(normal),
            zf_delay: WordDelay::new(normal),
            zb_delay: WordDelay::new(normal),
            number_delay: WordDelay::new(normal),
            absent: signed_constant(far_end(W)),
            conic_sign: constant(F as u64 - 1),
            polar_sign: constant(P as u64 - 1),
        }
    }

    /// Clocks from the flags to the results.
    pub const fn latency(rows_per_stage: usize) -> usize {
        <QuadricPe<W, W1, S, F>>::latency(rows_per_stage)
            + ContourChoice::<W, S>::latency()
            + <NormalUnit<W>>::latency()
    }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> Logic
    for FirstGenerationProcessor<W, W1, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("first_generation_processor");
        clock!(
            self,
            clock,
            in_box,
            quadric,
            front_inside,
            back_inside,
            front_middle,
            back_middle,
            choice,
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
        for i in 0..2 {
            self.depths[i].clock.next = self.clock.val();
            self.depths[i].valid.next = self.quadric.late_valid.val();
            self.depths[i].start.next = self.quadric.late_start.val();
            self.depths[i].line.next = self.quadric.late_line.val();
            self.depths[i].a.next = self.depth_a[i].val();
            self.depths[i].b.next = self.depth_b[i].val();
            self.depths[i].c.next = self.depth_c[i].val();
            self.conics[i].clock.next = self.clock.val();
            self.conics[i].valid.next = self.quadric.late_valid.val();
            self.conics[i].start.next = self.quadric.late_start.val();
            self.conics[i].line.next = self.quadric.late_line.val();
            self.conics[i].a2.next = self.conic_a2[i].val();
            self.conics[i].b2.next = self.conic_b2[i].val();
            self.conics[i].c.next = self.conic_c[i].val();
            self.conics[i].i0.next = self.conic_i0[i].val();
            self.conics[i].p0.next = self.conic_p0[i].val();
            self.conics[i].f.next = self.conic_f[i].val();
            self.polars[i].clock.next = self.clock.val();
            self.polars[i].valid.next = self.quadric.late_valid.val();
            self.polars[i].start.next = self.quadric.late_start.val();
            self.polars[i].line.next = self.quadric.late_line.val();
            self.polars[i].a.next = self.polar_a[i].val();
            self.polars[i].b.next = self.polar_b[i].val();
            self.polars[i].c.next = self.polar_c[i].val();
            self.normal.plane_nx[i].next = self.plane_nx[i].val();
            self.normal.plane_ny[i].next = self.plane_ny[i].val();
            self.normal.plane_nz[i].next = self.plane_nz[i].val();
        }
        self.front_inside.d.next = !self.conics[0]
            .value
            .val()
            .get_bit(self.conic_sign.val().index());
        self.back_inside.d.next = !self.conics[1]
            .value
            .val()
            .get_bit(self.conic_sign.val().index());
        self.front_middle.d.next = !self.polars[0]
            .value
            .val()
            .get_bit(self.polar_sign.val().index());
        self.back_middle.d.next = !self.polars[1]
            .value
            .val()
            .get_bit(self.polar_sign.val().index());
        self.choice.surface.next = self.surface.val();
        self.choice.near_sum.next = self.quadric.near_sum.val();
        self.choice.far_sum.next = self.quadric.far_sum.val();
        self.choice.is_there.next = self.quadric.is_inside.val() & self.in_box.late.val();
        self.choice.front_zp.next = self.depths[0].depth.val();
        self.choice.back_zp.next = self.depths[1].depth.val();
        self.choice.front_inside.next = self.front_inside.q.val();
        self.choice.back_inside.next = self.back_inside.q.val();
        self.choice.middle_kept.next = self.front_middle.q.val() & self.back_middle.q.val();
        self.normal_flags.valid.next = self.quadric.late_valid.val();
        self.normal_flags.start.next = self.quadric.late_start.val();
        self.normal_flags.line.next = self.quadric.late_line.val();
        self.root_delay.word.next = self.quadric.root.val();
        self.normal.valid.next = self.normal_flags.late_valid.val();
        self.normal.start.next = self.normal_flags.late_start.val();
        self.normal.line.next = self.normal_flags.late_line.val();
        self.normal.number.next = self.choice.number.val();
        self.normal.absent.next = self.choice.zf.val() == self.absent.val();
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
        self.zf_delay.word.next = self.choice.zf.val();
        self.zb_delay.word.next = self.choice.zb.val();
        self.number_delay.word.next = self.choice.number.val();
        self.out_valid.next = self.valid_delay.late.val();
        self.zf.next = self.zf_delay.late.val();
        self.zb.next = self.zb_delay.late.val();
        self.number.next = self.number_delay.late.val();
        self.nx.next = self.normal.nx.val();
        self.ny.next = self.normal.ny.val();
        self.nz.next = self.normal.nz.val();
    }
}

clocked!(FirstGenerationProcessor<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>);
