//! Convex polyhedron processor.

use crate::kernel::*;
use crate::unit::delay::WordDelay;
use crate::unit::half_spaces::HalfSpaces;
use crate::unit::plane_depth::PlaneDepth;
use crate::unit::plane_normal::PlaneNormal;
use crate::unit::screen_box::ScreenBox;

/// Gives, for every pixel, the front and back depth of a convex solid of planes, with faces and normals.
///
/// `P = W + 12`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line` | in | raster flags |
/// | `x`, `y` | in | 12 bits, pixel of the flags |
/// | `box_x0`, `box_x1`, `box_y0`, `box_y1` | in | 12 bits, inclusive |
/// | `plane_i_kind` | in | 2 bits: 0 none, 1 front (keeps z >= zp), 2 back (keeps z <= zp), 3 perpendicular (keeps zp >= 0) |
/// | `plane_i_a`, `plane_i_b`, `plane_i_c` | in | `P` bits |
/// | `plane_i_nx`, `plane_i_ny`, `plane_i_nz` | in | 16 bits, outward normal |
/// | `out_valid` | out | `valid`, with the results |
/// | `zf`, `zb` | out | `W` bits, front and back depth |
/// | `number`, `back_number` | out | 4 bits, faces at `zf` and `zb`: 2 + i plane i, 15 an end of the depth word |
/// | `nx`, `ny`, `nz` | out | 16 bits, normal of the front face |
/// | `back_nx`, `back_ny`, `back_nz` | out | 16 bits, normal of the back face |
///
/// Latency `ceil(log2 planes) + 4`. A solid without thickness is there; absent is `ZMAX` twice, numbers and normals zero. The
/// coefficients stay unchanged from the first flags of a zone until that many clocks after its last. Annex A.
pub struct PolyhedronProcessor<const W: usize, const P: usize> {
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
    /// Kind of each plane.
    pub plane_kind: Vec<Signal<In, Word<2>>>,
    /// Each plane: increment along the line.
    pub plane_a: Vec<Signal<In, Int<P>>>,
    /// Each plane: increment from line to line.
    pub plane_b: Vec<Signal<In, Int<P>>>,
    /// Each plane: value of the first pixel.
    pub plane_c: Vec<Signal<In, Int<P>>>,
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
    /// Back face.
    pub back_number: Signal<Out, Word<4>>,
    /// Normal x of the back face.
    pub back_nx: Signal<Out, Int<16>>,
    /// Normal y of the back face.
    pub back_ny: Signal<Out, Int<16>>,
    /// Normal z of the back face.
    pub back_nz: Signal<Out, Int<16>>,
    /// Test against the screen box.
    pub screen_box: ScreenBox,
    in_box: WordDelay<Bit>,
    /// Depth of each plane.
    pub planes: Vec<PlaneDepth<W, P>>,
    /// What all planes keep.
    pub half_spaces: HalfSpaces<W>,
    front_normal: PlaneNormal,
    back_normal: PlaneNormal,
    valid_delay: WordDelay<Bit>,
    zf_delay: WordDelay<Int<W>>,
    zb_delay: WordDelay<Int<W>>,
    number_delay: WordDelay<Word<4>>,
    back_number_delay: WordDelay<Word<4>>,
    near_end_nz: Constant<Int<16>>,
    far_end_nz: Constant<Int<16>>,
    _planes: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const P: usize] PolyhedronProcessor [W, P]
    inputs { clock, valid, start, line, x, y, box_x0, box_x1, box_y0, box_y1, plane_kind, plane_a,
        plane_b, plane_c, plane_nx, plane_ny, plane_nz }
    parts { out_valid, zf, zb, number, nx, ny, nz, back_number, back_nx, back_ny, back_nz,
        screen_box, in_box, planes, half_spaces, front_normal, back_normal, valid_delay, zf_delay,
        zb_delay, number_delay, back_number_delay, near_end_nz, far_end_nz }
    data { _planes }
}

impl<const W: usize, const P: usize> PolyhedronProcessor<W, P> {
    /// A processor of `planes` planes.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or `planes` is not in `1..=12`.
    pub fn new(planes: usize) -> Self {
        let tree = PlaneDepth::<W, P>::latency() + HalfSpaces::<W>::tree_latency(planes);
        fields! {
            [clock, valid, start, line, x, y, box_x0, box_x1, box_y0, box_y1, out_valid, zf, zb,
                number, nx, ny, nz, back_number, back_nx, back_ny, back_nz, screen_box]
            plane_kind: repeat(planes, Default::default),
            plane_a: repeat(planes, Default::default),
            plane_b: repeat(planes, Default::default),
            plane_c: repeat(planes, Default::default),
            plane_nx: repeat(planes, Default::default),
            plane_ny: repeat(planes, Default::default),
            plane_nz: repeat(planes, Default::default),
            in_box: WordDelay::new(tree),
            planes: repeat(planes, PlaneDepth::new),
            half_spaces: HalfSpaces::new(planes),
            front_normal: PlaneNormal::new(planes),
            back_normal: PlaneNormal::new(planes),
            valid_delay: WordDelay::new(tree + 2),
            zf_delay: WordDelay::new(1),
            zb_delay: WordDelay::new(1),
            number_delay: WordDelay::new(1),
            back_number_delay: WordDelay::new(1),
            near_end_nz: signed_constant(-32_767),
            far_end_nz: signed_constant(32_767),
            _planes: planes,
        }
    }

    /// Clocks from the flags to the results.
    pub const fn latency(planes: usize) -> usize {
        PlaneDepth::<W, P>::latency() + HalfSpaces::<W>::latency(planes) + PlaneNormal::latency()
    }
}

impl<const W: usize, const P: usize> Logic for PolyhedronProcessor<W, P> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("polyhedron_processor");
        clock!(
            self,
            clock,
            in_box,
            half_spaces,
            front_normal,
            back_normal,
            valid_delay,
            zf_delay,
            zb_delay,
            number_delay,
            back_number_delay
        );
        self.screen_box.x.next = self.x.val();
        self.screen_box.y.next = self.y.val();
        self.screen_box.box_x0.next = self.box_x0.val();
        self.screen_box.box_x1.next = self.box_x1.val();
        self.screen_box.box_y0.next = self.box_y0.val();
        self.screen_box.box_y1.next = self.box_y1.val();
        self.in_box.word.next = self.screen_box.in_box.val();
        self.half_spaces.is_there.next = self.in_box.late.val();
        for i in 0..self._planes {
            self.planes[i].clock.next = self.clock.val();
            self.planes[i].valid.next = self.valid.val();
            self.planes[i].start.next = self.start.val();
            self.planes[i].line.next = self.line.val();
            self.planes[i].a.next = self.plane_a[i].val();
            self.planes[i].b.next = self.plane_b[i].val();
            self.planes[i].c.next = self.plane_c[i].val();
            self.half_spaces.plane_kind[i].next = self.plane_kind[i].val();
            self.half_spaces.plane_zp[i].next = self.planes[i].depth.val();
            self.front_normal.plane_nx[i].next = self.plane_nx[i].val();
            self.front_normal.plane_ny[i].next = self.plane_ny[i].val();
            self.front_normal.plane_nz[i].next = self.plane_nz[i].val();
            self.back_normal.plane_nx[i].next = self.plane_nx[i].val();
            self.back_normal.plane_ny[i].next = self.plane_ny[i].val();
            self.back_normal.plane_nz[i].next = self.plane_nz[i].val();
        }
        self.front_normal.number.next = self.half_spaces.nf.val();
        self.front_normal.end_nz.next = self.near_end_nz.val();
        self.back_normal.number.next = self.half_spaces.nb.val();
        self.back_normal.end_nz.next = self.far_end_nz.val();
        self.valid_delay.word.next = self.valid.val();
        self.zf_delay.word.next = self.half_spaces.zf.val();
        self.zb_delay.word.next = self.half_spaces.zb.val();
        self.number_delay.word.next = self.half_spaces.nf.val();
        self.back_number_delay.word.next = self.half_spaces.nb.val();
        self.out_valid.next = self.valid_delay.late.val();
        self.zf.next = self.zf_delay.late.val();
        self.zb.next = self.zb_delay.late.val();
        self.number.next = self.number_delay.late.val();
        self.back_number.next = self.back_number_delay.late.val();
        self.nx.next = self.front_normal.nx.val();
        self.ny.next = self.front_normal.ny.val();
        self.nz.next = self.front_normal.nz.val();
        self.back_nx.next = self.back_normal.nx.val();
        self.back_ny.next = self.back_normal.ny.val();
        self.back_nz.next = self.back_normal.nz.val();
    }
}

clocked!(PolyhedronProcessor<const W: usize, const P: usize>);
