//! Flat facet processor.

use crate::format::FIRST_PLANE;
use crate::kernel::*;
use crate::unit::delay::WordDelay;
use crate::unit::one_face::OneFace;
use crate::unit::pe1::Pe1;
use crate::unit::screen_box::ScreenBox;

/// Gives, for every pixel, depth and normal of a flat facet of three or four sides, convex on the screen, its normals interpolated (Phong).
///
/// `S = W + 2`, `P = W + 12`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line` | in | raster flags |
/// | `x`, `y` | in | 12 bits, pixel of the flags |
/// | `box_x0`, `box_x1`, `box_y0`, `box_y1` | in | 12 bits, inclusive |
/// | `side_i_a`, `side_i_b`, `side_i_c` | in | `P` bits, not negative inside side i |
/// | `depth_a`, `depth_b`, `depth_c` | in | `P` bits, in units of `2^-10` depth words |
/// | `nx_a`, `nx_b`, `nx_c`, and so on to `nz` | in | 24 bits, in units of `2^-8` |
/// | `out_valid` | out | `valid`, with the results |
/// | `zf`, `zb` | out | `W` bits, the depth, twice |
/// | `number` | out | 4 bits, 2 |
/// | `nx`, `ny`, `nz` | out | 16 bits |
///
/// Latency 2. Absent outside a side and beyond the ends of the depth word: `ZMAX` twice, number and normal zero. Chaillou 1991, IV.2.2; section 4.1.2.
pub struct FacetProcessor<const W: usize, const S: usize, const P: usize> {
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
    /// Depth: increment along the line.
    pub depth_a: Signal<In, Int<P>>,
    /// Depth: increment from line to line.
    pub depth_b: Signal<In, Int<P>>,
    /// Depth: value of the first pixel.
    pub depth_c: Signal<In, Int<P>>,
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
    /// Normal z: increment along the line.
    pub nz_a: Signal<In, Int<24>>,
    /// Normal z: increment from line to line.
    pub nz_b: Signal<In, Int<24>>,
    /// Normal z: value of the first pixel.
    pub nz_c: Signal<In, Int<24>>,
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
    /// Depth.
    pub depth: Pe1<P>,
    /// Normal x.
    pub normal_x: Pe1<24>,
    /// Normal y.
    pub normal_y: Pe1<24>,
    /// Normal z.
    pub normal_z: Pe1<24>,
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
    no_face: Constant<Word<4>>,
    no_normal: Constant<Int<16>>,
    _sides: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const S: usize, const P: usize] FacetProcessor [W, S, P]
    inputs { clock, valid, start, line, x, y, box_x0, box_x1, box_y0, box_y1, side_a, side_b,
        side_c, depth_a, depth_b, depth_c, nx_a, nx_b, nx_c, ny_a, ny_b, ny_c, nz_a, nz_b, nz_c }
    parts { out_valid, zf, zb, number, nx, ny, nz, screen_box, in_box, sides, depth, normal_x,
        normal_y, normal_z, face, is_there, kept_depth, kept_number, kept_nx, kept_ny, kept_nz,
        valid_delay, sign, depth_guard, normal_guard, facet, no_face, no_normal }
    data { _sides }
}

impl<const W: usize, const S: usize, const P: usize> FacetProcessor<W, S, P> {
    /// A processor of `sides` sides.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or `sides` is not in `3..=4`.
    pub fn new(sides: usize) -> Self {
        assert!(P == W + 12, "a plane has 12 bits more than a depth");
        assert!((3..=4).contains(&sides), "a facet has 3 to 4 sides");
        fields! {
            [clock, valid, start, line, x, y, box_x0, box_x1, box_y0, box_y1, depth_a, depth_b,
                depth_c, nx_a, nx_b, nx_c, ny_a, ny_b, ny_c, nz_a, nz_b, nz_c, out_valid, zf, zb,
                number, nx, ny, nz, screen_box, depth, normal_x, normal_y, normal_z, is_there,
                kept_depth, kept_number, kept_nx, kept_ny, kept_nz]
            side_a: repeat(sides, Default::default),
            side_b: repeat(sides, Default::default),
            side_c: repeat(sides, Default::default),
            in_box: WordDelay::new(1),
            sides: repeat(sides, Default::default),
            face: OneFace::new(),
            valid_delay: WordDelay::new(2),
            sign: constant(P as u64 - 1),
            depth_guard: constant((P - S) as u64),
            normal_guard: constant(8),
            facet: constant(FIRST_PLANE),
            no_face: constant(0),
            no_normal: signed_constant(0),
            _sides: sides,
        }
    }

    /// Clocks from the flags to the results.
    pub const fn latency() -> usize {
        2
    }
}

impl<const W: usize, const S: usize, const P: usize> Logic for FacetProcessor<W, S, P> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("facet_processor");
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
            self.sides[i].a.next = self.side_a[i].val();
            self.sides[i].b.next = self.side_b[i].val();
            self.sides[i].c.next = self.side_c[i].val();
        }
        self.depth.valid.next = self.valid.val();
        self.depth.start.next = self.start.val();
        self.depth.line.next = self.line.val();
        self.depth.a.next = self.depth_a.val();
        self.depth.b.next = self.depth_b.val();
        self.depth.c.next = self.depth_c.val();
        self.normal_x.valid.next = self.valid.val();
        self.normal_x.start.next = self.start.val();
        self.normal_x.line.next = self.line.val();
        self.normal_x.a.next = self.nx_a.val();
        self.normal_x.b.next = self.nx_b.val();
        self.normal_x.c.next = self.nx_c.val();
        self.normal_y.valid.next = self.valid.val();
        self.normal_y.start.next = self.start.val();
        self.normal_y.line.next = self.line.val();
        self.normal_y.a.next = self.ny_a.val();
        self.normal_y.b.next = self.ny_b.val();
        self.normal_y.c.next = self.ny_c.val();
        self.normal_z.valid.next = self.valid.val();
        self.normal_z.start.next = self.start.val();
        self.normal_z.line.next = self.line.val();
        self.normal_z.a.next = self.nz_a.val();
        self.normal_z.b.next = self.nz_b.val();
        self.normal_z.c.next = self.nz_c.val();
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
        self.kept_number.d.next = self.no_face.val();
        self.kept_nx.d.next = self.no_normal.val();
        self.kept_ny.d.next = self.no_normal.val();
        self.kept_nz.d.next = self.no_normal.val();
        if self.face.is_present.val() {
            self.kept_number.d.next = self.facet.val();
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

clocked!(FacetProcessor<const W: usize, const S: usize, const P: usize>);
