//! Normal of the visible face.

use super::delay::FlagDelay;
use super::pe1::Pe1;
use crate::format::{CAP, FAR_ROOT, FIRST_PLANE, NEAR_ROOT};
use crate::kernel::*;

/// One component of the normal: `g(x, y) -+ ((k rs) >> 6)`, or a constant for the faces that are not the quadric's.
pub struct NormalComponent<const N: usize, const G: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// This clock carries a pixel.
    pub valid: Signal<In, Bit>,
    /// First pixel of the zone.
    pub start: Signal<In, Bit>,
    /// First pixel of a later line.
    pub line: Signal<In, Bit>,
    /// Increment along the line.
    pub a: Signal<In, Int<G>>,
    /// Increment from line to line.
    pub b: Signal<In, Int<G>>,
    /// Value of the first pixel.
    pub c: Signal<In, Int<G>>,
    /// Factor of the root.
    pub k: Signal<In, Int<N>>,
    /// Scaled root, beside the flags.
    pub scaled_root: Signal<In, Int<N>>,
    /// The face is the near one, beside the flags.
    pub is_near: Signal<In, Bit>,
    /// The face is the quadric's, one clock later.
    pub is_quadric: Signal<In, Bit>,
    /// The component of any other face, one clock later.
    pub fixed: Signal<In, Int<N>>,
    /// The component, two clocks after the flags.
    pub result: Signal<Out, Int<N>>,
    /// First-degree part.
    pub g: Pe1<G>,
    product: Signal<Local, Doubled<N>>,
    opposite: Signal<Local, Doubled<N>>,
    kept_change: DFF<Doubled<N>>,
    change: Signal<Local, Int<G>>,
    sum: Signal<Local, Int<G>>,
    kept_component: DFF<Int<N>>,
    binary_point: Constant<Word<8>>,
    dropped: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [const N: usize, const G: usize] NormalComponent [N, G]
    inputs { clock, valid, start, line, a, b, c, k, scaled_root, is_near, is_quadric, fixed }
    parts { result, g, product, opposite, kept_change, change, sum, kept_component, binary_point,
        dropped }
    data { }
}

impl<const N: usize, const G: usize> NormalComponent<N, G> {
    fn new() -> Self {
        Self {
            clock: Signal::default(),
            valid: Signal::default(),
            start: Signal::default(),
            line: Signal::default(),
            a: Signal::default(),
            b: Signal::default(),
            c: Signal::default(),
            k: Signal::default(),
            scaled_root: Signal::default(),
            is_near: Signal::default(),
            is_quadric: Signal::default(),
            fixed: Signal::default(),
            result: Signal::default(),
            g: Pe1::default(),
            product: Signal::default(),
            opposite: Signal::default(),
            kept_change: DFF::default(),
            change: Signal::default(),
            sum: Signal::default(),
            kept_component: DFF::default(),
            binary_point: constant((2 * N - G - 2) as u64),
            dropped: constant((G - N) as u64),
            _asleep: false,
        }
    }
}

impl<const N: usize, const G: usize> Logic for NormalComponent<N, G> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("normal_component");
        clock!(self, clock, g, kept_change, kept_component);
        self.g.valid.next = self.valid.val();
        self.g.start.next = self.start.val();
        self.g.line.next = self.line.val();
        self.g.a.next = self.a.val();
        self.g.b.next = self.b.val();
        self.g.c.next = self.c.val();
        self.product.next = self.k.val() * self.scaled_root.val();
        self.opposite.next = -self.product.val();
        if self.is_near.val() {
            self.kept_change.d.next = self.opposite.val();
        } else {
            self.kept_change.d.next = self.product.val();
        }
        self.change.next = self
            .kept_change
            .q
            .val()
            .get_bits::<G>(self.binary_point.val().index());
        self.sum.next = self.g.value.val() + self.change.val();
        if self.is_quadric.val() {
            self.kept_component.d.next = self.sum.val().get_bits::<N>(self.dropped.val().index());
        } else {
            self.kept_component.d.next = self.fixed.val();
        }
        self.result.next = self.kept_component.q.val();
    }
}

/// Gives the normal of the visible face: of the quadric from the polar plane and the root, of a plane its constant.
///
/// `W` is the width of the root. With `rs = root >> shift` (its low 15 bits are used), the component of a face of the quadric is
/// bits 23..8 of `g(x, y) - ((k rs) >> 6)` on the near face (number 0) and of `g(x, y) + ((k rs) >> 6)` on the far face
/// (number 1), where the sign is applied before the shift, which rounds down. Number 2 + i gives the normal of plane i,
/// number 15 `(0, 0, -32767)`, any other number and absent pixels zero.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line` | in | raster flags, beside `number` |
/// | `number` | in | 4 bits, visible face |
/// | `absent` | in | no face is visible |
/// | `root` | in | `W` bits, unsigned, beside `number` |
/// | `shift` | in | 5 bits |
/// | `gx_a` .. `gz_c` | in | 24 bits |
/// | `kx`, `ky`, `kz` | in | 16 bits |
/// | `plane_i_nx`, `plane_i_ny`, `plane_i_nz` | in | 16 bits, normal of plane i |
/// | `nx`, `ny`, `nz` | out | 16 bits |
///
/// Latency 3. Section 6.4 of the restatement, after section 2.4.2.
///
/// A machine fitted to a scene may have components of `N` bits, 10 to 16: then `N1 = N - 1` bits of the root, `G = N + 8` bits of `g`
/// and a product of `2 N` bits that is shifted by `N - 10` take the place of 15, 24, 32 and 6.
pub struct NormalUnit<
    const W: usize,
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
    /// Visible face.
    pub number: Signal<In, Word<4>>,
    /// No face is visible.
    pub absent: Signal<In, Bit>,
    /// Root of the quadric.
    pub root: Signal<In, Word<W>>,
    /// Places the root is shifted to the right.
    pub shift: Signal<In, Word<5>>,
    /// Component x: increment along the line.
    pub gx_a: Signal<In, Int<G>>,
    /// Component x: increment from line to line.
    pub gx_b: Signal<In, Int<G>>,
    /// Component x: value of the first pixel.
    pub gx_c: Signal<In, Int<G>>,
    /// Component y: increment along the line.
    pub gy_a: Signal<In, Int<G>>,
    /// Component y: increment from line to line.
    pub gy_b: Signal<In, Int<G>>,
    /// Component y: value of the first pixel.
    pub gy_c: Signal<In, Int<G>>,
    /// Component z: increment along the line.
    pub gz_a: Signal<In, Int<G>>,
    /// Component z: increment from line to line.
    pub gz_b: Signal<In, Int<G>>,
    /// Component z: value of the first pixel.
    pub gz_c: Signal<In, Int<G>>,
    /// Factor of the root in component x.
    pub kx: Signal<In, Int<N>>,
    /// Factor of the root in component y.
    pub ky: Signal<In, Int<N>>,
    /// Factor of the root in component z.
    pub kz: Signal<In, Int<N>>,
    /// Component x of each plane.
    pub plane_nx: Vec<Signal<In, Int<N>>>,
    /// Component y of each plane.
    pub plane_ny: Vec<Signal<In, Int<N>>>,
    /// Component z of each plane.
    pub plane_nz: Vec<Signal<In, Int<N>>>,
    /// Component x.
    pub nx: Signal<Out, Int<N>>,
    /// Component y.
    pub ny: Signal<Out, Int<N>>,
    /// Component z.
    pub nz: Signal<Out, Int<N>>,
    flags: FlagDelay,
    shifted_root: Signal<Local, Word<W>>,
    low_root: Signal<Local, Word<N1>>,
    wide_root: Signal<Local, Word<N>>,
    number_is_near: Signal<Local, Bit>,
    number_is_far: Signal<Local, Bit>,
    number_is_cap: Signal<Local, Bit>,
    scaled_root: DFF<Int<N>>,
    is_near: DFF<Bit>,
    is_quadric: DFF<Bit>,
    constant_x: DFF<Int<N>>,
    constant_y: DFF<Int<N>>,
    constant_z: DFF<Int<N>>,
    late_is_quadric: DFF<Bit>,
    late_constant_x: DFF<Int<N>>,
    late_constant_y: DFF<Int<N>>,
    late_constant_z: DFF<Int<N>>,
    /// Component x.
    pub component_x: NormalComponent<N, G>,
    /// Component y.
    pub component_y: NormalComponent<N, G>,
    /// Component z.
    pub component_z: NormalComponent<N, G>,
    near_root: Constant<Word<4>>,
    far_root: Constant<Word<4>>,
    cap: Constant<Word<4>>,
    zero: Constant<Int<N>>,
    to_viewer: Constant<Int<N>>,
    plane_number: Vec<Constant<Word<4>>>,
    _planes: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const N: usize, const N1: usize, const G: usize] NormalUnit [W, N, N1, G]
    inputs { clock, valid, start, line, number, absent, root, shift, gx_a, gx_b, gx_c, gy_a, gy_b,
        gy_c, gz_a, gz_b, gz_c, kx, ky, kz, plane_nx, plane_ny, plane_nz }
    parts { nx, ny, nz, flags, shifted_root, low_root, wide_root, number_is_near, number_is_far,
        number_is_cap, scaled_root, is_near, is_quadric, constant_x, constant_y, constant_z,
        late_is_quadric, late_constant_x, late_constant_y, late_constant_z, component_x,
        component_y, component_z, near_root, far_root, cap, zero, to_viewer, plane_number }
    data { _planes }
}

impl<const W: usize, const N: usize, const N1: usize, const G: usize> NormalUnit<W, N, N1, G> {
    /// A unit for an object with `planes` planes.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other.
    pub fn new(planes: usize) -> Self {
        assert!(
            N1 + 1 == N && G == N + 8 && N >= 10,
            "widths of a normal of N bits"
        );
        Self {
            clock: Signal::default(),
            valid: Signal::default(),
            start: Signal::default(),
            line: Signal::default(),
            number: Signal::default(),
            absent: Signal::default(),
            root: Signal::default(),
            shift: Signal::default(),
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
            plane_nx: repeat(planes, Signal::default),
            plane_ny: repeat(planes, Signal::default),
            plane_nz: repeat(planes, Signal::default),
            nx: Signal::default(),
            ny: Signal::default(),
            nz: Signal::default(),
            flags: FlagDelay::new(1),
            shifted_root: Signal::default(),
            low_root: Signal::default(),
            wide_root: Signal::default(),
            number_is_near: Signal::default(),
            number_is_far: Signal::default(),
            number_is_cap: Signal::default(),
            scaled_root: DFF::default(),
            is_near: DFF::default(),
            is_quadric: DFF::default(),
            constant_x: DFF::default(),
            constant_y: DFF::default(),
            constant_z: DFF::default(),
            late_is_quadric: DFF::default(),
            late_constant_x: DFF::default(),
            late_constant_y: DFF::default(),
            late_constant_z: DFF::default(),
            component_x: NormalComponent::new(),
            component_y: NormalComponent::new(),
            component_z: NormalComponent::new(),
            near_root: constant(NEAR_ROOT),
            far_root: constant(FAR_ROOT),
            cap: constant(CAP),
            zero: signed_constant(0),
            to_viewer: signed_constant(1 - (1 << N1)),
            plane_number: (0..planes as u64)
                .map(|i| constant(FIRST_PLANE + i))
                .collect(),
            _planes: planes,
            _asleep: false,
        }
    }

    /// Clocks from the face number to the normal.
    pub const fn latency() -> usize {
        3
    }
}

impl<const W: usize, const N: usize, const N1: usize, const G: usize> Logic
    for NormalUnit<W, N, N1, G>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("normal_unit");
        clock!(
            self,
            clock,
            flags,
            scaled_root,
            is_near,
            is_quadric,
            constant_x,
            constant_y,
            constant_z,
            late_is_quadric,
            late_constant_x,
            late_constant_y,
            late_constant_z,
            component_x,
            component_y,
            component_z
        );
        self.flags.valid.next = self.valid.val();
        self.flags.start.next = self.start.val();
        self.flags.line.next = self.line.val();
        self.shifted_root.next = self.root.val() >> self.shift.val();
        self.low_root.next = bit_cast::<N1, W>(self.shifted_root.val());
        self.wide_root.next = bit_cast::<N, N1>(self.low_root.val());
        self.scaled_root.d.next = signed_cast(self.wide_root.val());
        self.number_is_near.next = self.number.val() == self.near_root.val();
        self.number_is_far.next = self.number.val() == self.far_root.val();
        self.number_is_cap.next = self.number.val() == self.cap.val();
        self.is_near.d.next = self.number_is_near.val();
        self.is_quadric.d.next =
            (self.number_is_near.val() | self.number_is_far.val()) & !self.absent.val();
        self.constant_x.d.next = self.zero.val();
        self.constant_y.d.next = self.zero.val();
        self.constant_z.d.next = self.zero.val();
        if !self.absent.val() {
            if self.number_is_cap.val() {
                self.constant_z.d.next = self.to_viewer.val();
            }
            for i in 0..self._planes {
                if self.number.val() == self.plane_number[i].val() {
                    self.constant_x.d.next = self.plane_nx[i].val();
                    self.constant_y.d.next = self.plane_ny[i].val();
                    self.constant_z.d.next = self.plane_nz[i].val();
                }
            }
        }
        self.late_is_quadric.d.next = self.is_quadric.q.val();
        self.late_constant_x.d.next = self.constant_x.q.val();
        self.late_constant_y.d.next = self.constant_y.q.val();
        self.late_constant_z.d.next = self.constant_z.q.val();
        self.component_x.valid.next = self.flags.late_valid.val();
        self.component_x.start.next = self.flags.late_start.val();
        self.component_x.line.next = self.flags.late_line.val();
        self.component_x.a.next = self.gx_a.val();
        self.component_x.b.next = self.gx_b.val();
        self.component_x.c.next = self.gx_c.val();
        self.component_x.k.next = self.kx.val();
        self.component_x.scaled_root.next = self.scaled_root.q.val();
        self.component_x.is_near.next = self.is_near.q.val();
        self.component_x.is_quadric.next = self.late_is_quadric.q.val();
        self.component_x.fixed.next = self.late_constant_x.q.val();
        self.component_y.valid.next = self.flags.late_valid.val();
        self.component_y.start.next = self.flags.late_start.val();
        self.component_y.line.next = self.flags.late_line.val();
        self.component_y.a.next = self.gy_a.val();
        self.component_y.b.next = self.gy_b.val();
        self.component_y.c.next = self.gy_c.val();
        self.component_y.k.next = self.ky.val();
        self.component_y.scaled_root.next = self.scaled_root.q.val();
        self.component_y.is_near.next = self.is_near.q.val();
        self.component_y.is_quadric.next = self.late_is_quadric.q.val();
        self.component_y.fixed.next = self.late_constant_y.q.val();
        self.component_z.valid.next = self.flags.late_valid.val();
        self.component_z.start.next = self.flags.late_start.val();
        self.component_z.line.next = self.flags.late_line.val();
        self.component_z.a.next = self.gz_a.val();
        self.component_z.b.next = self.gz_b.val();
        self.component_z.c.next = self.gz_c.val();
        self.component_z.k.next = self.kz.val();
        self.component_z.scaled_root.next = self.scaled_root.q.val();
        self.component_z.is_near.next = self.is_near.q.val();
        self.component_z.is_quadric.next = self.late_is_quadric.q.val();
        self.component_z.fixed.next = self.late_constant_z.q.val();
        self.nx.next = self.component_x.result.val();
        self.ny.next = self.component_y.result.val();
        self.nz.next = self.component_z.result.val();
    }
}

clocked!(NormalUnit<const W: usize, const N: usize, const N1: usize, const G: usize>);
