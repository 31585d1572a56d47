//! Sphere processor: an exact outline, and a paraboloid for the depth.

use crate::format::CAP;
use crate::kernel::*;
use crate::unit::delay::{FlagDelay, WordDelay};
use crate::unit::pe1::Pe1;
use crate::unit::pe2::Pe2;
use crate::unit::screen_box::ScreenBox;
use crate::unit::side_interval::SideInterval;

/// Gives, for every pixel, depth and normal of a sphere whose front is approximated by a paraboloid; its outline is exact.
///
/// `S = W + 2`, `F = 2 W`. Orthographic views only.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line` | in | raster flags |
/// | `x`, `y` | in | 12 bits, pixel of the flags |
/// | `box_x0`, `box_x1`, `box_y0`, `box_y1` | in | 12 bits, inclusive |
/// | `outline_a2` .. `outline_f` | in | `F` bits, not negative inside the outline |
/// | `front_a2` .. `front_f` | in | `F` bits, front depth in units of `2^-(W-2)` depth words |
/// | `depth_sum` | in | `S` bits, front depth plus back depth |
/// | `nx_a` .. `ny_c` | in | 24 bits, normal in units of `2^-8` |
/// | `nz_a2` .. `nz_f` | in | `F` bits, normal in units of `2^-(F-16)` |
/// | `out_valid` | out | `valid`, with the results |
/// | `zf`, `zb` | out | `W` bits, front and back depth |
/// | `number` | out | 4 bits: 0 the sphere, 15 the cap of a sphere that reaches nearer than `ZLOW` |
/// | `nx`, `ny`, `nz` | out | 16 bits |
///
/// Latency 4. Absent is `ZMAX` twice, number and normal zero. Front and back depth of a sphere have the same sum at every pixel, so one
/// subtractor does what the source spends a fourth second-degree processor on. Chaillou 1991, IV.2.4.
pub struct SphereProcessor<const W: usize, const S: usize, const F: usize> {
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
    /// First column of the screen box.
    pub box_x0: Signal<In, Word<12>>,
    /// Last column of the screen box.
    pub box_x1: Signal<In, Word<12>>,
    /// First line of the screen box.
    pub box_y0: Signal<In, Word<12>>,
    /// Last line of the screen box.
    pub box_y1: Signal<In, Word<12>>,
    /// Outline: second difference along the line.
    pub outline_a2: Signal<In, Int<F>>,
    /// Outline: second difference from line to line.
    pub outline_b2: Signal<In, Int<F>>,
    /// Outline: mixed difference.
    pub outline_c: Signal<In, Int<F>>,
    /// Outline: increment from the first line to the second.
    pub outline_i0: Signal<In, Int<F>>,
    /// Outline: increment from the first pixel to the second.
    pub outline_p0: Signal<In, Int<F>>,
    /// Outline: value of the first pixel.
    pub outline_f: Signal<In, Int<F>>,
    /// Front depth: second difference along the line.
    pub front_a2: Signal<In, Int<F>>,
    /// Front depth: second difference from line to line.
    pub front_b2: Signal<In, Int<F>>,
    /// Front depth: mixed difference.
    pub front_c: Signal<In, Int<F>>,
    /// Front depth: increment from the first line to the second.
    pub front_i0: Signal<In, Int<F>>,
    /// Front depth: increment from the first pixel to the second.
    pub front_p0: Signal<In, Int<F>>,
    /// Front depth: value of the first pixel.
    pub front_f: Signal<In, Int<F>>,
    /// Front depth plus back depth.
    pub depth_sum: Signal<In, Int<S>>,
    /// Normal x: increment along the line.
    pub nx_a: Signal<In, Int<24>>,
    /// Normal x: increment from line to line.
    pub nx_b: Signal<In, Int<24>>,
    /// Normal x: value of the first pixel.
    pub nx_c: Signal<In, Int<24>>,
    /// Normal y: increment along the line.
    pub ny_a: Signal<In, Int<24>>,
    /// Normal y: increment from line to line.
    pub ny_b: Signal<In, Int<24>>,
    /// Normal y: value of the first pixel.
    pub ny_c: Signal<In, Int<24>>,
    /// Normal z: second difference along the line.
    pub nz_a2: Signal<In, Int<F>>,
    /// Normal z: second difference from line to line.
    pub nz_b2: Signal<In, Int<F>>,
    /// Normal z: mixed difference.
    pub nz_c: Signal<In, Int<F>>,
    /// Normal z: increment from the first line to the second.
    pub nz_i0: Signal<In, Int<F>>,
    /// Normal z: increment from the first pixel to the second.
    pub nz_p0: Signal<In, Int<F>>,
    /// Normal z: value of the first pixel.
    pub nz_f: Signal<In, Int<F>>,
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
    /// Outline.
    pub outline: Pe2<F>,
    /// Front depth.
    pub front: Pe2<F>,
    near_depth: Signal<Local, Int<S>>,
    kept_near: DFF<Int<S>>,
    kept_far: DFF<Int<S>>,
    kept_there: DFF<Bit>,
    /// Ends of the depth word.
    pub interval: SideInterval<W, S>,
    late_zf: DFF<Int<W>>,
    late_zb: DFF<Int<W>>,
    late_number: DFF<Word<4>>,
    late_present: DFF<Bit>,
    normal_flags: FlagDelay,
    /// Normal x.
    pub normal_x: Pe1<24>,
    /// Normal y.
    pub normal_y: Pe1<24>,
    /// Normal z.
    pub normal_z: Pe2<F>,
    kept_zf: DFF<Int<W>>,
    kept_zb: DFF<Int<W>>,
    kept_number: DFF<Word<4>>,
    kept_nx: DFF<Int<16>>,
    kept_ny: DFF<Int<16>>,
    kept_nz: DFF<Int<16>>,
    valid_delay: WordDelay<Bit>,
    sign: Constant<Word<8>>,
    depth_guard: Constant<Word<8>>,
    linear_guard: Constant<Word<8>>,
    quadratic_guard: Constant<Word<8>>,
    cap: Constant<Word<4>>,
    no_normal: Constant<Int<16>>,
    to_viewer: Constant<Int<16>>,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize, const F: usize] SphereProcessor [W, S, F]
    inputs { clock, valid, start, line, x, y, box_x0, box_x1, box_y0, box_y1, outline_a2,
        outline_b2, outline_c, outline_i0, outline_p0, outline_f, front_a2, front_b2, front_c,
        front_i0, front_p0, front_f, depth_sum, nx_a, nx_b, nx_c, ny_a, ny_b, ny_c, nz_a2, nz_b2,
        nz_c, nz_i0, nz_p0, nz_f }
    parts { out_valid, zf, zb, number, nx, ny, nz, screen_box, in_box, outline, front, near_depth,
        kept_near, kept_far, kept_there, interval, late_zf, late_zb, late_number,
        late_present, normal_flags, normal_x, normal_y, normal_z, kept_zf, kept_zb,
        kept_number, kept_nx, kept_ny, kept_nz, valid_delay, sign, depth_guard, linear_guard,
        quadratic_guard, cap, no_normal, to_viewer }
    data { }
}

impl<const W: usize, const S: usize, const F: usize> SphereProcessor<W, S, F> {
    /// A processor of `W` bits of depth.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other.
    pub fn new() -> Self {
        assert!(F == 2 * W, "a quadratic has twice the bits of a depth");
        fields! {
            [clock, valid, start, line, x, y, box_x0, box_x1, box_y0, box_y1, outline_a2,
                outline_b2, outline_c, outline_i0, outline_p0, outline_f, front_a2, front_b2,
                front_c, front_i0, front_p0, front_f, depth_sum, nx_a, nx_b, nx_c, ny_a, ny_b,
                ny_c, nz_a2, nz_b2, nz_c, nz_i0, nz_p0, nz_f, out_valid, zf, zb, number, nx, ny,
                nz, screen_box, outline, front, near_depth, kept_near, kept_far, kept_there,
                late_zf, late_zb, late_number, late_present, normal_x, normal_y,
                normal_z, kept_zf, kept_zb, kept_number, kept_nx, kept_ny, kept_nz]
            in_box: WordDelay::new(1),
            interval: SideInterval::new(),
            normal_flags: FlagDelay::new(2),
            valid_delay: WordDelay::new(4),
            sign: constant(F as u64 - 1),
            depth_guard: constant((F - S) as u64),
            linear_guard: constant(8),
            quadratic_guard: constant(F as u64 - 16),
            cap: constant(CAP),
            no_normal: signed_constant(0),
            to_viewer: signed_constant(-32_767),
        }
    }

    /// Clocks from the flags to the results.
    pub const fn latency() -> usize {
        4
    }
}

impl<const W: usize, const S: usize, const F: usize> Default for SphereProcessor<W, S, F> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize, const S: usize, const F: usize> Logic for SphereProcessor<W, S, F> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("sphere_processor");
        clock!(
            self,
            clock,
            in_box,
            outline,
            front,
            kept_near,
            kept_far,
            kept_there,
            late_zf,
            late_zb,
            late_number,
            late_present,
            normal_flags,
            normal_x,
            normal_y,
            normal_z,
            kept_zf,
            kept_zb,
            kept_number,
            kept_nx,
            kept_ny,
            kept_nz,
            valid_delay
        );
        self.screen_box.x.next = self.x.val();
        self.screen_box.y.next = self.y.val();
        self.screen_box.box_x0.next = self.box_x0.val();
        self.screen_box.box_x1.next = self.box_x1.val();
        self.screen_box.box_y0.next = self.box_y0.val();
        self.screen_box.box_y1.next = self.box_y1.val();
        self.in_box.word.next = self.screen_box.in_box.val();
        self.outline.valid.next = self.valid.val();
        self.outline.start.next = self.start.val();
        self.outline.line.next = self.line.val();
        self.outline.a2.next = self.outline_a2.val();
        self.outline.b2.next = self.outline_b2.val();
        self.outline.c.next = self.outline_c.val();
        self.outline.i0.next = self.outline_i0.val();
        self.outline.p0.next = self.outline_p0.val();
        self.outline.f.next = self.outline_f.val();
        self.front.valid.next = self.valid.val();
        self.front.start.next = self.start.val();
        self.front.line.next = self.line.val();
        self.front.a2.next = self.front_a2.val();
        self.front.b2.next = self.front_b2.val();
        self.front.c.next = self.front_c.val();
        self.front.i0.next = self.front_i0.val();
        self.front.p0.next = self.front_p0.val();
        self.front.f.next = self.front_f.val();
        self.near_depth.next = self
            .front
            .value
            .val()
            .get_bits::<S>(self.depth_guard.val().index());
        self.kept_near.d.next = self.near_depth.val();
        self.kept_far.d.next = self.depth_sum.val() - self.near_depth.val();
        self.kept_there.d.next =
            self.in_box.late.val() & !self.outline.value.val().get_bit(self.sign.val().index());
        self.interval.near_sum.next = self.kept_near.q.val();
        self.interval.far_sum.next = self.kept_far.q.val();
        self.interval.is_there.next = self.kept_there.q.val();
        self.late_zf.d.next = self.interval.zf.val();
        self.late_zb.d.next = self.interval.zb.val();
        self.late_number.d.next = self.interval.number.val();
        self.late_present.d.next = self.interval.is_present.val();
        // The normal is used two clocks later than the depth.
        self.normal_flags.valid.next = self.valid.val();
        self.normal_flags.start.next = self.start.val();
        self.normal_flags.line.next = self.line.val();
        self.normal_x.valid.next = self.normal_flags.late_valid.val();
        self.normal_x.start.next = self.normal_flags.late_start.val();
        self.normal_x.line.next = self.normal_flags.late_line.val();
        self.normal_x.a.next = self.nx_a.val();
        self.normal_x.b.next = self.nx_b.val();
        self.normal_x.c.next = self.nx_c.val();
        self.normal_y.valid.next = self.normal_flags.late_valid.val();
        self.normal_y.start.next = self.normal_flags.late_start.val();
        self.normal_y.line.next = self.normal_flags.late_line.val();
        self.normal_y.a.next = self.ny_a.val();
        self.normal_y.b.next = self.ny_b.val();
        self.normal_y.c.next = self.ny_c.val();
        self.normal_z.valid.next = self.normal_flags.late_valid.val();
        self.normal_z.start.next = self.normal_flags.late_start.val();
        self.normal_z.line.next = self.normal_flags.late_line.val();
        self.normal_z.a2.next = self.nz_a2.val();
        self.normal_z.b2.next = self.nz_b2.val();
        self.normal_z.c.next = self.nz_c.val();
        self.normal_z.i0.next = self.nz_i0.val();
        self.normal_z.p0.next = self.nz_p0.val();
        self.normal_z.f.next = self.nz_f.val();
        self.kept_zf.d.next = self.late_zf.q.val();
        self.kept_zb.d.next = self.late_zb.q.val();
        self.kept_number.d.next = self.late_number.q.val();
        self.kept_nx.d.next = self.no_normal.val();
        self.kept_ny.d.next = self.no_normal.val();
        self.kept_nz.d.next = self.no_normal.val();
        if self.late_present.q.val() {
            self.kept_nx.d.next = self
                .normal_x
                .value
                .val()
                .get_bits::<16>(self.linear_guard.val().index());
            self.kept_ny.d.next = self
                .normal_y
                .value
                .val()
                .get_bits::<16>(self.linear_guard.val().index());
            self.kept_nz.d.next = self
                .normal_z
                .value
                .val()
                .get_bits::<16>(self.quadratic_guard.val().index());
            if self.late_number.q.val() == self.cap.val() {
                self.kept_nx.d.next = self.no_normal.val();
                self.kept_ny.d.next = self.no_normal.val();
                self.kept_nz.d.next = self.to_viewer.val();
            }
        }
        self.valid_delay.word.next = self.valid.val();
        self.out_valid.next = self.valid_delay.late.val();
        self.zf.next = self.kept_zf.q.val();
        self.zb.next = self.kept_zb.q.val();
        self.number.next = self.kept_number.q.val();
        self.nx.next = self.kept_nx.q.val();
        self.ny.next = self.kept_ny.q.val();
        self.nz.next = self.kept_nz.q.val();
    }
}

clocked!(SphereProcessor<const W: usize, const S: usize, const F: usize>);
