//! Cylinder processor: body and front disc in one exact outline, a parabolic body.

use crate::format::{FIRST_PLANE, NEAR_ROOT};
use crate::kernel::*;
use crate::unit::delay::WordDelay;
use crate::unit::one_face::OneFace;
use crate::unit::pe1::Pe1;
use crate::unit::pe2::Pe2;
use crate::unit::screen_box::ScreenBox;

/// Gives, for every pixel, depth and normal of a cylinder whose body is approximated by a parabolic cylinder; outline and disc are exact.
///
/// `S = W + 2`, `F = 2 W`, `P = W + 12`. Orthographic views only, neither end-on nor side-on.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line` | in | raster flags |
/// | `x`, `y` | in | 12 bits, pixel of the flags |
/// | `box_x0`, `box_x1`, `box_y0`, `box_y1` | in | 12 bits, inclusive |
/// | `side_i_a`, `side_i_b`, `side_i_c` | in | `P` bits, i = 0 to 3, not negative in the rectangle between the discs |
/// | `disc_i_a2` .. `disc_i_f` | in | `F` bits, not negative in the front (0) and back (1) disc |
/// | `body_a2` .. `body_f` | in | `F` bits, depth of the body in units of `2^-(W-2)` depth words |
/// | `nx_a2` .. `nz_f` | in | `F` bits, normal of the body in units of `2^-(F-16)` |
/// | `lid_a`, `lid_b`, `lid_c` | in | `P` bits, depth of the front disc in units of `2^-10` depth words |
/// | `lid_nx`, `lid_ny`, `lid_nz` | in | 16 bits, normal of the front disc |
/// | `out_valid` | out | `valid`, with the results |
/// | `zf`, `zb` | out | `W` bits, the depth of the visible part, twice |
/// | `number` | out | 4 bits: 0 body, 2 front disc |
/// | `nx`, `ny`, `nz` | out | 16 bits |
///
/// Latency 3. Absent is `ZMAX` twice, number and normal zero; so is a part beyond the ends of the depth word. Chaillou 1991, IV.2.5.
pub struct CylinderProcessor<const W: usize, const S: usize, const F: usize, const P: usize> {
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
    /// Each side: increment along the line.
    pub side_a: Vec<Signal<In, Int<P>>>,
    /// Each side: increment from line to line.
    pub side_b: Vec<Signal<In, Int<P>>>,
    /// Each side: value of the first pixel.
    pub side_c: Vec<Signal<In, Int<P>>>,
    /// Front and back disc: second difference along the line.
    pub disc_a2: Vec<Signal<In, Int<F>>>,
    /// Front and back disc: second difference from line to line.
    pub disc_b2: Vec<Signal<In, Int<F>>>,
    /// Front and back disc: mixed difference.
    pub disc_c: Vec<Signal<In, Int<F>>>,
    /// Front and back disc: increment from the first line to the second.
    pub disc_i0: Vec<Signal<In, Int<F>>>,
    /// Front and back disc: increment from the first pixel to the second.
    pub disc_p0: Vec<Signal<In, Int<F>>>,
    /// Front and back disc: value of the first pixel.
    pub disc_f: Vec<Signal<In, Int<F>>>,
    /// Body: second difference along the line.
    pub body_a2: Signal<In, Int<F>>,
    /// Body: second difference from line to line.
    pub body_b2: Signal<In, Int<F>>,
    /// Body: mixed difference.
    pub body_c: Signal<In, Int<F>>,
    /// Body: increment from the first line to the second.
    pub body_i0: Signal<In, Int<F>>,
    /// Body: increment from the first pixel to the second.
    pub body_p0: Signal<In, Int<F>>,
    /// Body: value of the first pixel.
    pub body_f: Signal<In, Int<F>>,
    /// Normal x of the body: second difference along the line.
    pub nx_a2: Signal<In, Int<F>>,
    /// Normal x of the body: second difference from line to line.
    pub nx_b2: Signal<In, Int<F>>,
    /// Normal x of the body: mixed difference.
    pub nx_c: Signal<In, Int<F>>,
    /// Normal x of the body: increment from the first line to the second.
    pub nx_i0: Signal<In, Int<F>>,
    /// Normal x of the body: increment from the first pixel to the second.
    pub nx_p0: Signal<In, Int<F>>,
    /// Normal x of the body: value of the first pixel.
    pub nx_f: Signal<In, Int<F>>,
    /// Normal y of the body: second difference along the line.
    pub ny_a2: Signal<In, Int<F>>,
    /// Normal y of the body: second difference from line to line.
    pub ny_b2: Signal<In, Int<F>>,
    /// Normal y of the body: mixed difference.
    pub ny_c: Signal<In, Int<F>>,
    /// Normal y of the body: increment from the first line to the second.
    pub ny_i0: Signal<In, Int<F>>,
    /// Normal y of the body: increment from the first pixel to the second.
    pub ny_p0: Signal<In, Int<F>>,
    /// Normal y of the body: value of the first pixel.
    pub ny_f: Signal<In, Int<F>>,
    /// Normal z of the body: second difference along the line.
    pub nz_a2: Signal<In, Int<F>>,
    /// Normal z of the body: second difference from line to line.
    pub nz_b2: Signal<In, Int<F>>,
    /// Normal z of the body: mixed difference.
    pub nz_c: Signal<In, Int<F>>,
    /// Normal z of the body: increment from the first line to the second.
    pub nz_i0: Signal<In, Int<F>>,
    /// Normal z of the body: increment from the first pixel to the second.
    pub nz_p0: Signal<In, Int<F>>,
    /// Normal z of the body: value of the first pixel.
    pub nz_f: Signal<In, Int<F>>,
    /// Front disc: increment along the line.
    pub lid_a: Signal<In, Int<P>>,
    /// Front disc: increment from line to line.
    pub lid_b: Signal<In, Int<P>>,
    /// Front disc: value of the first pixel.
    pub lid_c: Signal<In, Int<P>>,
    /// Normal x of the front disc.
    pub lid_nx: Signal<In, Int<16>>,
    /// Normal y of the front disc.
    pub lid_ny: Signal<In, Int<16>>,
    /// Normal z of the front disc.
    pub lid_nz: Signal<In, Int<16>>,
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
    /// Sides.
    pub sides: Vec<Pe1<P>>,
    /// Discs.
    pub discs: Vec<Pe2<F>>,
    /// Body.
    pub body_depth: Pe2<F>,
    /// Normal x of the body.
    pub normal_x: Pe2<F>,
    /// Normal y of the body.
    pub normal_y: Pe2<F>,
    /// Normal z of the body.
    pub normal_z: Pe2<F>,
    /// Front disc.
    pub lid: Pe1<P>,
    between: Signal<Local, Bit>,
    in_front: Signal<Local, Bit>,
    in_back: Signal<Local, Bit>,
    kept_there: DFF<Bit>,
    kept_z: DFF<Int<S>>,
    part: DFF<Word<4>>,
    part_nx: DFF<Int<16>>,
    part_ny: DFF<Int<16>>,
    part_nz: DFF<Int<16>>,
    face: OneFace<W, S>,
    kept_depth: DFF<Int<W>>,
    kept_number: DFF<Word<4>>,
    kept_nx: DFF<Int<16>>,
    kept_ny: DFF<Int<16>>,
    kept_nz: DFF<Int<16>>,
    valid_delay: WordDelay<Bit>,
    side_sign: Constant<Word<8>>,
    sign: Constant<Word<8>>,
    depth_guard: Constant<Word<8>>,
    lid_guard: Constant<Word<8>>,
    normal_guard: Constant<Word<8>>,
    body_face: Constant<Word<4>>,
    lid_face: Constant<Word<4>>,
    no_normal: Constant<Int<16>>,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize, const F: usize, const P: usize] CylinderProcessor [W, S, F, P]
    inputs { clock, valid, start, line, x, y, box_x0, box_x1, box_y0, box_y1, side_a, side_b,
        side_c, disc_a2, disc_b2, disc_c, disc_i0, disc_p0, disc_f, body_a2, body_b2, body_c,
        body_i0, body_p0, body_f, nx_a2, nx_b2, nx_c, nx_i0, nx_p0, nx_f, ny_a2, ny_b2, ny_c,
        ny_i0, ny_p0, ny_f, nz_a2, nz_b2, nz_c, nz_i0, nz_p0, nz_f, lid_a, lid_b, lid_c, lid_nx,
        lid_ny, lid_nz }
    parts { out_valid, zf, zb, number, nx, ny, nz, screen_box, in_box, sides, discs, body_depth,
        normal_x, normal_y, normal_z, lid, between, in_front, in_back, kept_there, kept_z, part,
        part_nx, part_ny, part_nz, face, kept_depth, kept_number, kept_nx, kept_ny, kept_nz,
        valid_delay, side_sign, sign, depth_guard, lid_guard, normal_guard, body_face, lid_face,
        no_normal }
    data { }
}

impl<const W: usize, const S: usize, const F: usize, const P: usize> CylinderProcessor<W, S, F, P> {
    /// A processor of `W` bits of depth.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other.
    pub fn new() -> Self {
        assert!(
            F == 2 * W && P == W + 12,
            "a quadratic has twice the bits of a depth, a plane 12 bits more"
        );
        fields! {
            [clock, valid, start, line, x, y, box_x0, box_x1, box_y0, box_y1, body_a2, body_b2,
                body_c, body_i0, body_p0, body_f, nx_a2, nx_b2, nx_c, nx_i0, nx_p0, nx_f, ny_a2,
                ny_b2, ny_c, ny_i0, ny_p0, ny_f, nz_a2, nz_b2, nz_c, nz_i0, nz_p0, nz_f, lid_a,
                lid_b, lid_c, lid_nx, lid_ny, lid_nz, out_valid, zf, zb, number, nx, ny, nz,
                screen_box, body_depth, normal_x, normal_y, normal_z, lid, between, in_front, in_back,
                kept_there, kept_z, part, part_nx, part_ny, part_nz, kept_depth, kept_number,
                kept_nx, kept_ny, kept_nz]
            side_a: repeat(4, Default::default),
            side_b: repeat(4, Default::default),
            side_c: repeat(4, Default::default),
            disc_a2: repeat(2, Default::default),
            disc_b2: repeat(2, Default::default),
            disc_c: repeat(2, Default::default),
            disc_i0: repeat(2, Default::default),
            disc_p0: repeat(2, Default::default),
            disc_f: repeat(2, Default::default),
            in_box: WordDelay::new(1),
            sides: repeat(4, Default::default),
            discs: repeat(2, Default::default),
            face: OneFace::new(),
            valid_delay: WordDelay::new(3),
            side_sign: constant(P as u64 - 1),
            sign: constant(F as u64 - 1),
            depth_guard: constant((F - S) as u64),
            lid_guard: constant((P - S) as u64),
            normal_guard: constant(F as u64 - 16),
            body_face: constant(NEAR_ROOT),
            lid_face: constant(FIRST_PLANE),
            no_normal: signed_constant(0),
        }
    }

    /// Clocks from the flags to the results.
    pub const fn latency() -> usize {
        3
    }
}

impl<const W: usize, const S: usize, const F: usize, const P: usize> Default
    for CylinderProcessor<W, S, F, P>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize, const S: usize, const F: usize, const P: usize> Logic
    for CylinderProcessor<W, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("cylinder_processor");
        clock!(
            self,
            clock,
            in_box,
            body_depth,
            normal_x,
            normal_y,
            normal_z,
            lid,
            kept_there,
            kept_z,
            part,
            part_nx,
            part_ny,
            part_nz,
            kept_depth,
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
        for i in 0..4 {
            self.sides[i].clock.next = self.clock.val();
            self.sides[i].valid.next = self.valid.val();
            self.sides[i].start.next = self.start.val();
            self.sides[i].line.next = self.line.val();
            self.sides[i].a.next = self.side_a[i].val();
            self.sides[i].b.next = self.side_b[i].val();
            self.sides[i].c.next = self.side_c[i].val();
        }
        for i in 0..2 {
            self.discs[i].clock.next = self.clock.val();
            self.discs[i].valid.next = self.valid.val();
            self.discs[i].start.next = self.start.val();
            self.discs[i].line.next = self.line.val();
            self.discs[i].a2.next = self.disc_a2[i].val();
            self.discs[i].b2.next = self.disc_b2[i].val();
            self.discs[i].c.next = self.disc_c[i].val();
            self.discs[i].i0.next = self.disc_i0[i].val();
            self.discs[i].p0.next = self.disc_p0[i].val();
            self.discs[i].f.next = self.disc_f[i].val();
        }
        self.body_depth.valid.next = self.valid.val();
        self.body_depth.start.next = self.start.val();
        self.body_depth.line.next = self.line.val();
        self.body_depth.a2.next = self.body_a2.val();
        self.body_depth.b2.next = self.body_b2.val();
        self.body_depth.c.next = self.body_c.val();
        self.body_depth.i0.next = self.body_i0.val();
        self.body_depth.p0.next = self.body_p0.val();
        self.body_depth.f.next = self.body_f.val();
        self.normal_x.valid.next = self.valid.val();
        self.normal_x.start.next = self.start.val();
        self.normal_x.line.next = self.line.val();
        self.normal_x.a2.next = self.nx_a2.val();
        self.normal_x.b2.next = self.nx_b2.val();
        self.normal_x.c.next = self.nx_c.val();
        self.normal_x.i0.next = self.nx_i0.val();
        self.normal_x.p0.next = self.nx_p0.val();
        self.normal_x.f.next = self.nx_f.val();
        self.normal_y.valid.next = self.valid.val();
        self.normal_y.start.next = self.start.val();
        self.normal_y.line.next = self.line.val();
        self.normal_y.a2.next = self.ny_a2.val();
        self.normal_y.b2.next = self.ny_b2.val();
        self.normal_y.c.next = self.ny_c.val();
        self.normal_y.i0.next = self.ny_i0.val();
        self.normal_y.p0.next = self.ny_p0.val();
        self.normal_y.f.next = self.ny_f.val();
        self.normal_z.valid.next = self.valid.val();
        self.normal_z.start.next = self.start.val();
        self.normal_z.line.next = self.line.val();
        self.normal_z.a2.next = self.nz_a2.val();
        self.normal_z.b2.next = self.nz_b2.val();
        self.normal_z.c.next = self.nz_c.val();
        self.normal_z.i0.next = self.nz_i0.val();
        self.normal_z.p0.next = self.nz_p0.val();
        self.normal_z.f.next = self.nz_f.val();
        self.lid.valid.next = self.valid.val();
        self.lid.start.next = self.start.val();
        self.lid.line.next = self.line.val();
        self.lid.a.next = self.lid_a.val();
        self.lid.b.next = self.lid_b.val();
        self.lid.c.next = self.lid_c.val();
        self.between.next = true;
        for i in 0..4 {
            if self.sides[i]
                .value
                .val()
                .get_bit(self.side_sign.val().index())
            {
                self.between.next = false;
            }
        }
        self.in_front.next = !self.discs[0].value.val().get_bit(self.sign.val().index());
        self.in_back.next = !self.discs[1].value.val().get_bit(self.sign.val().index());
        self.kept_there.d.next = self.in_box.late.val()
            & (self.in_front.val() | self.between.val() | self.in_back.val());
        if self.in_front.val() {
            self.kept_z.d.next = self
                .lid
                .value
                .val()
                .get_bits::<S>(self.lid_guard.val().index());
            self.part.d.next = self.lid_face.val();
            self.part_nx.d.next = self.lid_nx.val();
            self.part_ny.d.next = self.lid_ny.val();
            self.part_nz.d.next = self.lid_nz.val();
        } else {
            self.kept_z.d.next = self
                .body_depth
                .value
                .val()
                .get_bits::<S>(self.depth_guard.val().index());
            self.part.d.next = self.body_face.val();
            self.part_nx.d.next = self
                .normal_x
                .value
                .val()
                .get_bits::<16>(self.normal_guard.val().index());
            self.part_ny.d.next = self
                .normal_y
                .value
                .val()
                .get_bits::<16>(self.normal_guard.val().index());
            self.part_nz.d.next = self
                .normal_z
                .value
                .val()
                .get_bits::<16>(self.normal_guard.val().index());
        }
        self.face.z.next = self.kept_z.q.val();
        self.face.is_there.next = self.kept_there.q.val();
        self.kept_depth.d.next = self.face.depth.val();
        self.kept_number.d.next = self.body_face.val();
        self.kept_nx.d.next = self.no_normal.val();
        self.kept_ny.d.next = self.no_normal.val();
        self.kept_nz.d.next = self.no_normal.val();
        if self.face.is_present.val() {
            self.kept_number.d.next = self.part.q.val();
            self.kept_nx.d.next = self.part_nx.q.val();
            self.kept_ny.d.next = self.part_ny.q.val();
            self.kept_nz.d.next = self.part_nz.q.val();
        }
        self.valid_delay.word.next = self.valid.val();
        self.out_valid.next = self.valid_delay.late.val();
        self.zf.next = self.kept_depth.q.val();
        self.zb.next = self.kept_depth.q.val();
        self.number.next = self.kept_number.q.val();
        self.nx.next = self.kept_nx.q.val();
        self.ny.next = self.kept_ny.q.val();
        self.nz.next = self.kept_nz.q.val();
    }
}

clocked!(CylinderProcessor<const W: usize, const S: usize, const F: usize, const P: usize>);
