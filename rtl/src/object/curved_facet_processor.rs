//! Non-planar facet processor.

use crate::format::NEAR_ROOT;
use crate::kernel::*;
use crate::unit::delay::WordDelay;
use crate::unit::one_face::OneFace;
use crate::unit::pe2::Pe2;
use crate::unit::screen_box::ScreenBox;

/// Gives, for every pixel, depth and normal of a facet with sides, depth and normal of second degree.
///
/// `S = W + 2`, `F = 2 W`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line` | in | raster flags |
/// | `x`, `y` | in | 12 bits, pixel of the flags |
/// | `box_x0`, `box_x1`, `box_y0`, `box_y1` | in | 12 bits, inclusive |
/// | `side_i_a2`, `side_i_b2`, `side_i_c`, `side_i_i0`, `side_i_p0`, `side_i_f` | in | `F` bits, not negative inside side i |
/// | `depth_a2`, `depth_b2`, `depth_c`, `depth_i0`, `depth_p0`, `depth_f` | in | `F` bits, in units of `2^-(W-2)` depth words |
/// | `nx_a2`, `nx_b2`, `nx_c`, `nx_i0`, `nx_p0`, `nx_f`, and so on to `nz` | in | `F` bits, in units of `2^-(F-16)` |
/// | `out_valid` | out | `valid`, with the results |
/// | `zf`, `zb` | out | `W` bits, the depth, twice |
/// | `number` | out | 4 bits, 0 |
/// | `nx`, `ny`, `nz` | out | 16 bits |
///
/// Latency 2. Absent outside a side and beyond the ends of the depth word: `ZMAX` twice, number and normal zero. Chaillou 1991, IV.2.6.1.
pub struct CurvedFacetProcessor<const W: usize, const S: usize, const F: usize> {
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
    /// Each side: second difference along the line.
    pub side_a2: Vec<Signal<In, Int<F>>>,
    /// Each side: second difference from line to line.
    pub side_b2: Vec<Signal<In, Int<F>>>,
    /// Each side: mixed difference.
    pub side_c: Vec<Signal<In, Int<F>>>,
    /// Each side: increment from the first line to the second.
    pub side_i0: Vec<Signal<In, Int<F>>>,
    /// Each side: increment from the first pixel to the second.
    pub side_p0: Vec<Signal<In, Int<F>>>,
    /// Each side: value of the first pixel.
    pub side_f: Vec<Signal<In, Int<F>>>,
    /// Depth: second difference along the line.
    pub depth_a2: Signal<In, Int<F>>,
    /// Depth: second difference from line to line.
    pub depth_b2: Signal<In, Int<F>>,
    /// Depth: mixed difference.
    pub depth_c: Signal<In, Int<F>>,
    /// Depth: increment from the first line to the second.
    pub depth_i0: Signal<In, Int<F>>,
    /// Depth: increment from the first pixel to the second.
    pub depth_p0: Signal<In, Int<F>>,
    /// Depth: value of the first pixel.
    pub depth_f: Signal<In, Int<F>>,
    /// Normal x: second difference along the line.
    pub nx_a2: Signal<In, Int<F>>,
    /// Normal x: second difference from line to line.
    pub nx_b2: Signal<In, Int<F>>,
    /// Normal x: mixed difference.
    pub nx_c: Signal<In, Int<F>>,
    /// Normal x: increment from the first line to the second.
    pub nx_i0: Signal<In, Int<F>>,
    /// Normal x: increment from the first pixel to the second.
    pub nx_p0: Signal<In, Int<F>>,
    /// Normal x: value of the first pixel.
    pub nx_f: Signal<In, Int<F>>,
    /// Normal y: second difference along the line.
    pub ny_a2: Signal<In, Int<F>>,
    /// Normal y: second difference from line to line.
    pub ny_b2: Signal<In, Int<F>>,
    /// Normal y: mixed difference.
    pub ny_c: Signal<In, Int<F>>,
    /// Normal y: increment from the first line to the second.
    pub ny_i0: Signal<In, Int<F>>,
    /// Normal y: increment from the first pixel to the second.
    pub ny_p0: Signal<In, Int<F>>,
    /// Normal y: value of the first pixel.
    pub ny_f: Signal<In, Int<F>>,
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
    /// Sides.
    pub sides: Vec<Pe2<F>>,
    /// Depth.
    pub depth: Pe2<F>,
    /// Normal x.
    pub normal_x: Pe2<F>,
    /// Normal y.
    pub normal_y: Pe2<F>,
    /// Normal z.
    pub normal_z: Pe2<F>,
    face: OneFace<W, S>,
    is_there: Signal<Local, Bit>,
    kept_depth: DFF<Int<W>>,
    kept_number: DFF<Word<4>>,
    kept_nx: DFF<Int<16>>,
    kept_ny: DFF<Int<16>>,
    kept_nz: DFF<Int<16>>,
    valid_delay: WordDelay<Bit>,
    sign: Constant<Word<8>>,
    depth_guard: Constant<Word<8>>,
    normal_guard: Constant<Word<8>>,
    facet: Constant<Word<4>>,
    no_normal: Constant<Int<16>>,
    _sides: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize, const F: usize] CurvedFacetProcessor [W, S, F]
    inputs { clock, valid, start, line, x, y, box_x0, box_x1, box_y0, box_y1, side_a2, side_b2,
        side_c, side_i0, side_p0, side_f, depth_a2, depth_b2, depth_c, depth_i0, depth_p0,
        depth_f, nx_a2, nx_b2, nx_c, nx_i0, nx_p0, nx_f, ny_a2, ny_b2, ny_c, ny_i0, ny_p0, ny_f,
        nz_a2, nz_b2, nz_c, nz_i0, nz_p0, nz_f }
    parts { out_valid, zf, zb, number, nx, ny, nz, screen_box, in_box, sides, depth, normal_x,
        normal_y, normal_z, face, is_there, kept_depth, kept_number, kept_nx, kept_ny, kept_nz,
        valid_delay, sign, depth_guard, normal_guard, facet, no_normal }
    data { _sides }
}

impl<const W: usize, const S: usize, const F: usize> CurvedFacetProcessor<W, S, F> {
    /// A processor of `sides` sides.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or `sides` is not in `1..=4`.
    pub fn new(sides: usize) -> Self {
        assert!(F == 2 * W, "a quadratic has twice the bits of a depth");
        assert!((1..=4).contains(&sides), "a facet has 1 to 4 sides");
        fields! {
            [clock, valid, start, line, x, y, box_x0, box_x1, box_y0, box_y1, depth_a2, depth_b2,
                depth_c, depth_i0, depth_p0, depth_f, nx_a2, nx_b2, nx_c, nx_i0, nx_p0, nx_f,
                ny_a2, ny_b2, ny_c, ny_i0, ny_p0, ny_f, nz_a2, nz_b2, nz_c, nz_i0, nz_p0, nz_f,
                out_valid, zf, zb, number, nx, ny, nz, screen_box, depth, normal_x, normal_y,
                normal_z, is_there, kept_depth, kept_number, kept_nx, kept_ny, kept_nz]
            side_a2: repeat(sides, Default::default),
            side_b2: repeat(sides, Default::default),
            side_c: repeat(sides, Default::default),
            side_i0: repeat(sides, Default::default),
            side_p0: repeat(sides, Default::default),
            side_f: repeat(sides, Default::default),
            in_box: WordDelay::new(1),
            sides: repeat(sides, Default::default),
            face: OneFace::new(),
            valid_delay: WordDelay::new(2),
            sign: constant(F as u64 - 1),
            depth_guard: constant((F - S) as u64),
            normal_guard: constant(F as u64 - 16),
            facet: constant(NEAR_ROOT),
            no_normal: signed_constant(0),
            _sides: sides,
        }
    }

    /// Clocks from the flags to the results.
    pub const fn latency() -> usize {
        2
    }
}

impl<const W: usize, const S: usize, const F: usize> Logic for CurvedFacetProcessor<W, S, F> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("curved_facet_processor");
        clock!(
            self,
            clock,
            in_box,
            depth,
            normal_x,
            normal_y,
            normal_z,
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
        for i in 0..self._sides {
            self.sides[i].clock.next = self.clock.val();
            self.sides[i].valid.next = self.valid.val();
            self.sides[i].start.next = self.start.val();
            self.sides[i].line.next = self.line.val();
            self.sides[i].a2.next = self.side_a2[i].val();
            self.sides[i].b2.next = self.side_b2[i].val();
            self.sides[i].c.next = self.side_c[i].val();
            self.sides[i].i0.next = self.side_i0[i].val();
            self.sides[i].p0.next = self.side_p0[i].val();
            self.sides[i].f.next = self.side_f[i].val();
        }
        self.depth.valid.next = self.valid.val();
        self.depth.start.next = self.start.val();
        self.depth.line.next = self.line.val();
        self.depth.a2.next = self.depth_a2.val();
        self.depth.b2.next = self.depth_b2.val();
        self.depth.c.next = self.depth_c.val();
        self.depth.i0.next = self.depth_i0.val();
        self.depth.p0.next = self.depth_p0.val();
        self.depth.f.next = self.depth_f.val();
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
        self.is_there.next = self.in_box.late.val();
        for i in 0..self._sides {
            if self.sides[i].value.val().get_bit(self.sign.val().index()) {
                self.is_there.next = false;
            }
        }
        self.face.is_there.next = self.is_there.val();
        self.face.z.next = self
            .depth
            .value
            .val()
            .get_bits::<S>(self.depth_guard.val().index());
        self.kept_depth.d.next = self.face.depth.val();
        self.kept_number.d.next = self.facet.val();
        self.kept_nx.d.next = self.no_normal.val();
        self.kept_ny.d.next = self.no_normal.val();
        self.kept_nz.d.next = self.no_normal.val();
        if self.face.is_present.val() {
            self.kept_nx.d.next = self
                .normal_x
                .value
                .val()
                .get_bits::<16>(self.normal_guard.val().index());
            self.kept_ny.d.next = self
                .normal_y
                .value
                .val()
                .get_bits::<16>(self.normal_guard.val().index());
            self.kept_nz.d.next = self
                .normal_z
                .value
                .val()
                .get_bits::<16>(self.normal_guard.val().index());
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

clocked!(CurvedFacetProcessor<const W: usize, const S: usize, const F: usize>);
